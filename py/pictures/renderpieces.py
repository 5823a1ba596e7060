"""What a snapshot looks like: triangles and tubes with their colours, and where to look from."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..measure import bodyarrays
from ..measure.scenesnapshot import SceneSnapshot
from ..mesh.surfaces import UPRIGHT, BodySurfaces, containerSurfaces, particleSurfaces
from ..typealiases import Bools, Floats, Rows

Plane: TypeAlias = tuple[Floats, Floats]  # a point [m] and the normal

SAND, STEEL = np.array([0.87, 0.72, 0.46]), np.array([0.52, 0.57, 0.66])
KINDS = np.array([(0.9, 0.62, 0), (0.34, 0.71, 0.91), (0, 0.62, 0.45), (0.8, 0.47, 0.65), (0.94, 0.89, 0.26), (0, 0.45, 0.7)])  # Okabe & Ito
CONTAINER = (0.55, 0.62, 0.70)
FINENESS = 0.4         # of a pixel: distance between a particle's surface and its triangles
DETAILS = 5e-4, 0.05   # the same over the largest half size, at least and at most
FAINT, MIST = 0.05, (0.45, 0.50, 0.56)  # opacity and colour of plain particles around force chains
GLASS = 0.18, 0.10     # opacity of the container, and around force chains
TOP_SHARE = 0.995      # of all values lie below the end of a colour scale
WEAK = 0.02            # forces below this share of the largest shown are left out
THICKEST = 0.38        # radius of the thickest tube, over the particles' smallest half size (its median)
ROOM = 1.04            # picture over what is in it
HEADROOM = 0.06        # of a container above the highest particle, over the particles' height
LARGE = 2.0            # half size over the median (by volume), above which a particle is not cut away: an impactor


class Scale(NamedTuple):
    """What a colour stands for: label, factor from SI, and values of a snapshot, one a particle."""

    label: str
    factor: float
    values: Callable[[SceneSnapshot], Floats]


COLOURS: dict[str, Scale | None] = {
    'plain': None, 'kind': None,
    'speed': Scale('speed [m/s]', 1.0, lambda snapshot: snapshot.speeds()),
    'force': Scale('largest normal force [N]', 1.0, lambda snapshot: snapshot.largestForces()),
    'pressure': Scale('pressure [kPa]', 1e-3, lambda snapshot: -np.trace(snapshot.particles['stress'], axis1=1, axis2=2) / 3),
    'octahedralStress': Scale('octahedral shear stress [kPa]', 1e-3, lambda snapshot: snapshot.particles['octahedralStress']),
    'contacts': Scale('contacts', 1.0, lambda snapshot: snapshot.particles['contacts'].astype(float)),
}
CHAIN_LABEL = 'normal force of contacts [N]'


def hasScale(colour: str | None) -> bool:
    """Whether the colour stands for numbers."""
    return _scaleOf(colour) is not None


def _scaleOf(colour: str | None) -> Scale | None:
    return None if colour is None else COLOURS[colour]


class Style:
    """How snapshots are coloured: all of one picture or animation alike.

    :ivar colour, chains, cut: as in `render.picture`; :ivar limits: of the particles' colours; :ivar chainLimit: [N]; :ivar thickest: radius [m]
    :ivar kinds: shapes (M, 4); :ivar box: around the particles of all snapshots (2, 3) [m]
    """

    def __init__(self, colour: str | None, chains: bool, cut: bool, limits: tuple[float, float] | None, chainLimit: float | None, thickest: float,
                 kinds: Floats, box: Floats) -> None:
        self.colour, self.chains, self.cut = colour, chains, cut
        self.limits, self.chainLimit, self.thickest, self.kinds, self.box = limits, chainLimit, thickest, kinds, box

    @classmethod
    def of(cls, snapshots: Iterable[SceneSnapshot], colour: str | None, chains: bool, cut: bool, limits: tuple[float, float] | None,
           chainLimit: float | None) -> Self:
        """The style of `snapshots`, each of which is looked at once."""
        values: list[Floats] = []
        strongest, sizes, kinds, boxes = [], [], np.zeros((0, 4)), []
        scale = _scaleOf(colour)
        for snapshot in snapshots:
            if limits is None and scale is not None:
                values.append(scale.factor * scale.values(snapshot))
            forces = snapshot.normalForces()
            strongest.append(_quantile(forces[np.isfinite(forces)], TOP_SHARE))
            if len(snapshot.particles):
                sizes.append(np.median(snapshot.particles['extents'].min(axis=1)))
            kinds = np.unique(np.concatenate([kinds, _shapes(snapshot)]), axis=0)
            boxes.append(_particleBox(snapshot))
        if values:
            numbers = np.concatenate(values)
            numbers = numbers[np.isfinite(numbers)]
            limits = (min(_quantile(numbers, 1 - TOP_SHARE), 0.0), _quantile(numbers, TOP_SHARE))
        if chains and chainLimit is None:
            chainLimit = max(strongest)
        box = np.array([np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]])
        return cls(colour, chains, cut, limits, chainLimit, THICKEST * min(sizes, default=0.0), kinds, box)

    def bars(self) -> list[tuple[Any, str]]:
        """List of (matplotlib's ScalarMappable, label)."""
        from matplotlib.cm import ScalarMappable
        result = []
        scale = _scaleOf(self.colour)
        if self.limits is not None and scale is not None:
            result.append((ScalarMappable(_norm(self.limits), 'viridis'), scale.label))
        if self.chainLimit is not None and self.chains:
            result.append((ScalarMappable(_norm((0, self.chainLimit)), _chainColours()), CHAIN_LABEL))
        return result

    def colours(self, snapshot: SceneSnapshot) -> NDArray[Any]:
        """Of the particles, (N, 3) bytes."""
        if self.colour == 'plain':
            return _bytes(np.tile(MIST, (len(snapshot.particles), 1)) if self.chains else _plain(snapshot.particles))
        if self.colour == 'kind':
            # All kinds are in both lists, so their places are those in `kinds`.
            _, places = np.unique(np.concatenate([self.kinds, _shapes(snapshot)]), axis=0, return_inverse=True)
            return _bytes(KINDS[places.ravel()[len(self.kinds):] % len(KINDS)])
        mappable, _ = self.bars()[0]
        scale = _scaleOf(self.colour)
        assert scale is not None, self.colour
        return mappable.to_rgba(scale.factor * scale.values(snapshot), bytes=True)[:, :3]


def pieces(snapshot: SceneSnapshot, style: Style, eye: Mapping[str, Any], size: tuple[int, int]) -> list[dict[str, Any]]:
    """What `Renderer.draw` takes: container, particles, force chains of the `snapshot`, for a picture of `size` pixels."""
    result, container = [], _container(snapshot, style)
    plane = _cutPlane(style, snapshot, eye['direction'])
    rows = _kept(snapshot.particles, plane)
    shown = snapshot.particles[rows]
    if style.colour is not None and len(shown):
        surface = particleSurfaces(shown, _details(shown, eye['height'] / size[1]))
        result.append(dict(points=surface.points, triangles=surface.triangles, normals=surface.normals,
                           colours=style.colours(snapshot)[rows][surface.owner], opacity=FAINT if style.chains else 1.0))
    if style.chains:
        result += _chains(snapshot, style, plane)
    if len(container.points):
        result.append(dict(points=container.points, triangles=container.triangles, normals=container.normals, colour=CONTAINER,
                           opacity=GLASS[style.chains], specular=0.0, **({} if plane is None else {'keep': plane})))
    return result


def _cutPlane(style: Style, snapshot: SceneSnapshot, direction: Floats) -> Plane | None:
    """(point, normal) of the upright plane through the middle of the container or the particles; None without `cut`."""
    if not style.cut:
        return None
    finite = np.any(snapshot.container['kind'] != bodyarrays.WALL)
    box = SceneSnapshot(snapshot.particles[:0], container=snapshot.container).box() if finite else style.box
    return box.mean(axis=0), _horizontal(direction)


def _kept(particles: Rows, plane: Plane | None) -> Bools:
    """Which particles lie behind the plane (None: all), or are so large that the picture would miss them."""
    if plane is None or not len(particles):
        return np.ones(len(particles), dtype=bool)
    sizes, volumes = particles['extents'].max(axis=1), particles['extents'].prod(axis=1)
    order = np.argsort(sizes)
    median = sizes[order[np.searchsorted(np.cumsum(volumes[order]), volumes.sum() / 2)]]
    return ((particles['position'] - plane[0]) @ plane[1] > 0) | (sizes > LARGE * median)


def _details(particles: Rows, pixel: float) -> Floats:
    """Of each particle, see `particleSurfaces`; `pixel`: what one shows [m]. In powers of two, so that few tessellations serve all."""
    asked = FINENESS * pixel / particles['extents'].max(axis=1)
    return np.clip(2.0 ** np.floor(np.log2(asked)), *DETAILS)


def _chains(snapshot: SceneSnapshot, style: Style, plane: Plane | None) -> list[dict[str, Any]]:
    """Tubes from centre to centre, of a section in proportion to the force."""
    forces, rows = snapshot.normalForces(), snapshot.contacts
    limit = style.chainLimit or 0.0
    strong = forces > WEAK * limit
    if plane is not None:
        strong &= (rows['point'] - plane[0]) @ plane[1] > 0
    if not strong.any():
        return []
    share, mappable = np.clip(forces[strong] / limit, 0, 1), style.bars()[-1][0]
    ends = np.stack([rows['centre1'], rows['centre2']], axis=1)[strong].reshape(-1, 3)
    return [dict(points=ends, lines=np.arange(len(ends)).reshape(-1, 2), radii=np.repeat(style.thickest * np.sqrt(share), 2),
                 colours=np.repeat(mappable.to_rgba(forces[strong], bytes=True)[:, :3], 2, axis=0))]


def camera(snapshots: Sequence[SceneSnapshot], style: Style, elevation: float, azimuth: float) -> tuple[dict[str, Any], float]:
    """Camera (see `Renderer.draw`) that sees all between the `snapshots`, the first one and the last, and height over width of its picture.

    :param elevation, azimuth: of the viewer, above the horizontal and around z from +x, counterclockwise seen from above [rad]
    """
    direction = -np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
    up = np.cross(right, direction)
    corners = np.concatenate([_boxCorners(style.box), *(_container(snapshot, style).points for snapshot in snapshots)])
    plane = _cutPlane(style, snapshots[0], direction)
    if plane is not None:  # what is cut away is not looked at
        corners = corners - np.minimum((corners - plane[0]) @ plane[1], 0)[:, None] * plane[1]
    low, high = (np.array([(corners @ axis).min(), (corners @ axis).max()]) for axis in (right, up))
    centre = low.mean() * right + high.mean() * up + (corners @ direction).mean() * direction
    width, height = (ROOM * np.ptp(span) or 1.0 for span in (low, high))
    return dict(centre=centre, direction=direction, up=up, height=height), height / width


def _boxCorners(box: Floats) -> Floats:
    return np.array(np.meshgrid(*np.transpose(box))).reshape(3, -1).T


def _particleBox(snapshot: SceneSnapshot) -> Floats:
    """Box around the particles alone, (2, 3) [m]; without any, around the container."""
    return SceneSnapshot(snapshot.particles).box() if len(snapshot.particles) else snapshot.box()


def _container(snapshot: SceneSnapshot, style: Style) -> BodySurfaces:
    """`BodySurfaces` of the container; standing cylinders end a little above the particles: what is empty needs no room in a picture."""
    rows, (low, high) = snapshot.container.copy(), style.box[:, 2]
    for row in np.flatnonzero(rows['kind'] == bodyarrays.CYLINDER) if len(snapshot.particles) else ():
        border = rows[row]
        if abs(bodyarrays.matrices(border['orientation'])[2, 2]) > UPRIGHT:
            bottom, top = (border['position'][2] + side * border['numbers'][1] / 2 for side in (-1, 1))
            bottom, top = max(bottom, low - HEADROOM * (high - low)), min(top, high + HEADROOM * (high - low))
            border['position'][2], border['numbers'][1] = (bottom + top) / 2, top - bottom
    return containerSurfaces(rows, style.box)


def _horizontal(direction: Floats) -> Floats:
    flat = np.array([direction[0], direction[1], 0.0])
    return flat / np.linalg.norm(flat) if np.linalg.norm(flat) > 1e-9 else np.asarray(direction)


def _plain(rows: Rows) -> Floats:
    """Sand of slightly different tints; what is of another material than most is steel."""
    tint = 0.82 + 0.18 * ((rows['id'] * 0.618034) % 1)
    colours = tint[:, None] * SAND
    if len(rows):
        materials, counts = np.unique(rows['material'], return_counts=True)
        colours[rows['material'] != materials[counts.argmax()]] = STEEL
    return colours


def _shapes(snapshot: SceneSnapshot) -> Floats:
    """Proportions and exponents (N, 4), rounded: what a kind of particle has in common."""
    rows = snapshot.particles
    return np.round(np.column_stack([rows['extents'][:, 1:] / rows['extents'][:, :1], rows['exponents']]), 3)


def _norm(limits: tuple[float, float]) -> Any:
    from matplotlib.colors import Normalize
    low, high = limits
    return Normalize(low, high if high > low else low + 1)


def _chainColours() -> Any:
    from matplotlib import colormaps
    from matplotlib.colors import ListedColormap
    return ListedColormap(colormaps['inferno_r'](np.linspace(0.14, 0.95, 256)))  # without what is lost on white


def _bytes(colours: Floats) -> NDArray[Any]:
    return np.round(255 * np.clip(colours, 0, 1)).astype('u1')


def _quantile(values: Floats, share: float) -> float:
    return float(np.quantile(values, share)) if len(values) else 0.0
