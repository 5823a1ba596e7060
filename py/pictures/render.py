"""Pictures (PNG) and animations (GIF) of a scene, a snapshot or a recorded series, drawn off-screen.

    sq.picture('bed.png', sq.SceneSnapshot.ofScene(), colour='speed')
    sq.animation('impact.gif', sq.RecordedSeries('vtk'), chains=True)
"""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import checks
from ..files.wholefile import ReplacingBytes, requireFolder
from ..measure.scenesnapshot import SceneSnapshot
from ..measure.snapshot import Snapshot
from .renderer import Renderer
from .renderpieces import COLOURS, Style, camera, hasScale, pieces

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from PIL.Image import Image

    from ..typealiases import PathLike

DPI = 200              # of pictures; of animations half of it
TITLE, CAPTION = 11, 9  # pt
LOWEST, HIGHEST = 50, 8192  # pixels of a view's width and height; graphics cards draw no more than twice as many
RATES = 0.01, 50       # frames a second: a GIF counts hundredths of a second, and viewers slow down what lasts only one
FARTHEST = 1e15        # m from the origin: nothing is drawn there
FOOT = 0.07            # room for the scale below a view, over its height


def picture(path: PathLike, views: Any, colour: str | None = 'plain', chains: bool = False, cut: bool = False,
            limits: tuple[float, float] | None = None, chainLimit: float | None = None, elevation: float = 14.0, azimuth: float = -90.0,
            title: str = '', width: int = 1100) -> None:
    """A PNG of one view or several side by side, in the same scale and colours.

    :param views: a `SceneSnapshot` or `Snapshot`, or a list of such or of (caption, such)
    :param colour: of the particles: 'plain', 'kind' (shape), 'speed', 'force' (largest normal force), 'pressure', 'octahedralStress', 'contacts';
        None: not drawn
    :param chains: normal forces as tubes between centres, whose section grows with the force; particles are translucent then
    :param cut: take the half towards the viewer away
    :param limits: (lowest, highest) of the colours, which stand for numbers then; None: from the views
    :param chainLimit: the force [N] of the thickest tubes; None: from the views
    :param elevation, azimuth: of the viewer, above the horizontal and around z from +x, counterclockwise seen from above [degrees]; -90: from -y
    :param width: of a view in pixels
    :raises ValueError: a value out of range; ImportError: a package is missing; RuntimeError: drawing failed
    """
    _checkPath(path, '.png')
    title = _text('title', title)
    captions, frames = zip(*_views(views))
    style = _style(frames, colour, chains, cut, limits, chainLimit)
    eye, size = _eye(frames, style, elevation, azimuth, width)
    with Renderer() as renderer:
        images = [renderer.draw(pieces(frame, style, eye, size), eye, size) for frame in frames]
    figure = _compose(images, captions, style, title, eye, DPI)
    with ReplacingBytes(path) as file:
        figure.savefig(file, format='png', dpi=DPI, metadata={'Software': None})


def animation(path: PathLike, frames: Iterable[SceneSnapshot | Snapshot], colour: str | None = 'speed', chains: bool = False, cut: bool = False,
              limits: tuple[float, float] | None = None, chainLimit: float | None = None, elevation: float = 14.0, azimuth: float = -90.0,
              title: str = '', width: int = 480,
              rate: float = 12.0, start: float | None = None) -> None:
    """A GIF of `frames`, all in the same scale and colours; the caption is the time.

    :param frames: a sequence of `SceneSnapshot` or `Snapshot`. Of one that reads each when it is asked for, a `RecordedSeries` for
        example, no more than one is in memory; it is read twice
    :param rate: frames a second, at most 50; the GIF rounds what each lasts to hundredths of a second (12: 0.08 s)
    :param start: the moment [s] from which the time counts; None: the first frame's
    :param colour, chains, cut, limits, chainLimit, elevation, azimuth, title, width, raises: as in `picture`
    """
    _checkPath(path, '.gif')
    title, start = _text('title', title), None if start is None else checks.finite('start', start)
    rate, frames = checks.within('rate', rate, *RATES), _sequence(frames)
    style = _style((_sceneSnapshot('frames', frame) for frame in frames), colour, chains, cut, limits, chainLimit)
    ends = [_sceneSnapshot('frames', frames[place]) for place in (0, -1)]
    eye, size = _eye(ends, style, elevation, azimuth, width)
    start, images = ends[0].time if start is None else start, []
    with Renderer() as renderer:
        for frame in (_sceneSnapshot('frames', frame) for frame in frames):
            figure = _compose([renderer.draw(pieces(frame, style, eye, size), eye, size)], [_clock(frame.time - start)], style, title, eye, DPI // 2)
            images.append(_withPalette(_pixels(figure, DPI // 2), style))
    with ReplacingBytes(path) as file:
        images[0].save(file, format='GIF', save_all=True, append_images=images[1:], duration=10 * round(100 / rate), loop=0, optimize=True)


def _withPalette(picture: NDArray[Any], style: Style) -> Image:
    """The picture as PIL's, with a palette of its own of 256 colours, in which all of the bars of colours are."""
    from PIL import Image
    height, width = picture.shape[:2]
    shares = np.linspace(0, 1, width)
    ramps = [np.repeat(mappable.get_cmap()(shares, bytes=True)[None, :, :3], height // 8, axis=0) for mappable, _ in style.bars()]
    return Image.fromarray(np.concatenate([picture, *ramps])).quantize(256, dither=Image.Dither.NONE).crop((0, 0, width, height))


def _views(views: Any) -> list[tuple[str, SceneSnapshot]]:
    """List of (caption, SceneSnapshot)."""
    if isinstance(views, (SceneSnapshot, Snapshot)):
        views = [views]
    try:
        views = [('', view) if isinstance(view, (SceneSnapshot, Snapshot)) else tuple(view) for view in views]
    except TypeError:
        views = [()]
    if not views:
        raise ValueError('views = []: there is nothing to show')
    if any(len(view) != 2 or not isinstance(view[0], str) for view in views):
        raise ValueError('views: must be a SceneSnapshot or a Snapshot, or a list of such or of (caption, such)')
    return [(_text('views', caption), _sceneSnapshot('views', view)) for caption, view in views]


def _sceneSnapshot(name: str, view: Any) -> SceneSnapshot:
    """A `SceneSnapshot` that can be drawn."""
    if not isinstance(view, (SceneSnapshot, Snapshot)):
        raise ValueError(f'{name} = {view!r}: is no SceneSnapshot and no Snapshot')
    snapshot = SceneSnapshot.ofSnapshot(view) if isinstance(view, Snapshot) else view
    lost = ~(np.abs(snapshot.particles['position']) <= FARTHEST).all(axis=1)
    if lost.any():
        row = snapshot.particles[lost][0]
        raise ValueError(f'{name}: body {row["id"]} is at {tuple(row["position"].tolist())}, which cannot be drawn')
    return snapshot


def _text(name: str, value: Any) -> str:
    """A text that matplotlib can write: what stands between two dollars is a formula to it."""
    from matplotlib import cbook, mathtext
    if cbook.is_math_text(checks.text(name, value)):
        try:
            mathtext.MathTextParser('path').parse(value)
        except ValueError as error:
            raise ValueError(f'{name} = {value!r}: has no formula between its dollars ({error})') from None
    return value


def _sequence(frames: Any) -> Sequence[Any]:
    """`frames` as they are if they can be read twice, else as a list."""
    if isinstance(frames, (SceneSnapshot, Snapshot)) or not isinstance(frames, Iterable):
        raise ValueError('frames: must be a sequence of SceneSnapshot or Snapshot')
    frames = frames if isinstance(frames, Sequence) else list(frames)
    if not len(frames):
        raise ValueError('frames = []: there is nothing to show')
    return frames


def _style(frames: Iterable[SceneSnapshot], colour: Any, chains: Any, cut: Any, limits: Any, chainLimit: Any) -> Style:
    checks.oneOf('colour', colour, (*COLOURS, None))
    if limits is not None:
        limits = _limits(limits, colour)
    return Style.of(frames, colour, checks.boolean('chains', chains), checks.boolean('cut', cut), limits,
                    None if chainLimit is None else checks.positive('chainLimit', chainLimit))


def _limits(limits: Any, colour: str | None) -> tuple[float, float]:
    if not hasScale(colour):
        raise ValueError(f'limits = {limits!r}: colour = {colour!r} stands for no numbers')
    try:
        low, high = limits
    except (TypeError, ValueError):
        raise ValueError(f'limits = {limits!r}: must be two numbers') from None
    low, high = checks.finite('limits[0]', low), checks.finite('limits[1]', high)
    if not low < high:
        raise ValueError(f'limits = {limits!r}: the first must be below the second')
    return low, high


def _eye(frames: Sequence[SceneSnapshot], style: Style, elevation: Any, azimuth: Any, width: Any) -> tuple[dict[str, Any], tuple[int, int]]:
    """Camera that sees all `frames`, and the size of the picture."""
    width = checks.wholeNumber('width', width, LOWEST, HIGHEST)
    eye, shape = camera(frames, style, np.radians(checks.within('elevation', elevation, -90, 90)), np.radians(checks.finite('azimuth', azimuth)))
    height = int(np.clip(round(width * shape), LOWEST, min(4 * width, HIGHEST)))
    return {**eye, 'height': max(eye['height'], eye['height'] / shape * height / width)}, (width, height)  # a flat scene keeps its sides


def _checkPath(path: PathLike, ending: str) -> None:
    if os.path.splitext(checks.path('path', path))[1].lower() != ending:
        raise ValueError(f'path = {path!r}: must end in {ending}')
    requireFolder(path)


def _clock(seconds: float) -> str:
    return f'{1e3 * seconds:.2f} ms' if abs(seconds) < 1 else f'{seconds:.3f} s'


def _compose(images: Sequence[NDArray[Any]], captions: Sequence[str], style: Style, title: str, eye: Mapping[str, Any], dpi: int) -> Figure:
    """Figure of the images side by side with captions, a scale, and a bar for each kind of colours."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    height, width = images[0].shape[:2]
    size = (len(images) * width / dpi + 0.05 + 0.95 * len(style.bars()), (1 + FOOT) * height / dpi + 0.28 * any(captions) + 0.32 * bool(title))
    figure = Figure(figsize=size, layout='constrained')
    FigureCanvasAgg(figure)
    panels = np.atleast_1d(figure.subplots(1, len(images)))
    for axes, image, caption in zip(panels, images, captions):
        axes.imshow(image, interpolation='lanczos')
        axes.set_title(caption, fontsize=CAPTION)
        axes.axis('off')
        axes.set_ylim((1 + FOOT) * height, 0)
    _drawScale(panels[0], eye['height'] / height, images[0].shape)
    for mappable, label in style.bars():
        figure.colorbar(mappable, ax=list(panels), shrink=0.8, aspect=24, pad=0.01, extend='max').set_label(label, fontsize=CAPTION)
    figure.suptitle(title, fontsize=TITLE)
    return figure


def _drawScale(axes: Axes, pixel: float, shape: tuple[int, ...]) -> None:
    """A bar of 1, 2 or 5 times a power of ten below the picture, about a sixth as wide; `pixel`: what one shows [m]."""
    target = shape[1] * pixel / 6
    power = 10 ** np.floor(np.log10(target))
    length = power * max(factor for factor in (1, 2, 5) if factor * power <= target)
    left, low = 0.02 * shape[1], (1 + FOOT / 2) * shape[0]
    axes.plot([left, left + length / pixel], [low, low], color='#30343a', lw=2, solid_capstyle='butt')
    axes.text(left + length / pixel + 0.01 * shape[1], low, f'{1e3 * length:g} mm', va='center', fontsize=CAPTION - 2, color='#30343a')


def _pixels(figure: Figure, dpi: int) -> NDArray[Any]:
    figure.set_dpi(dpi)
    figure.canvas.draw()
    canvas: Any = figure.canvas
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
