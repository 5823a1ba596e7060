"""Pictures of an identification."""
from __future__ import annotations

import io
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from PIL import Image

from ..pictures.style import COLOURS, MARKERS, newFigure, outerLegend, rampColours
from . import fit as fits
from . import hertz, unloading
from .curves import Curve, forceAt

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..typealiases import Floats, PathLike
    from .fit import Fit, Points
    from .unloading import Comparison

GREY = '#555555'
ROUNDING = 1e-9   # of an overlap that is the same
DPI, SHADES = 120, 160   # of the PNG: a third of the bytes of full colour


def hertzPicture(path: PathLike, curves: Sequence[Curve]) -> None:
    """Elastic cases against Hertz: force over half-width, and the relative departures."""
    figure, ((left, right),) = newFigure(2, 1, 4.6, 3.8)
    for i, curve in enumerate(curves):
        style: dict[str, Any] = dict(marker=MARKERS[i], ms=5.5, color=COLOURS[i], mec='white', mew=0.7)
        left.plot(1e3 * curve.halfWidth, curve.force, ls='', label=curve.name, zorder=3, **style)
        left.plot(1e3 * hertz.halfWidth(curve.modulus, curve.radius, curve.force), curve.force, color=GREY, lw=1.2)
        force, halfWidth = hertz.errors(curve)
        ratio = fits.nominalHalfWidth(curve) / curve.radius
        right.plot(ratio, 100 * force, lw=1.3, **style)
        right.plot(ratio, 100 * halfWidth, lw=1.3, ls=':', mfc='none', **{**style, 'mec': COLOURS[i]})
    left.plot([], [], color=GREY, lw=1.2, label='Hertz')
    right.plot([], [], color=GREY, lw=1.3, marker=MARKERS[0], ms=5.5, mec='white', label='force at the same overlap')
    right.plot([], [], color=GREY, lw=1.3, ls=':', marker=MARKERS[0], ms=5.5, mfc='none', label='half-width under the same force')
    left.set(xscale='log', yscale='log', xlabel='half-width $a$ [mm]', ylabel='force [N]')
    right.set(xlabel=r'$\sqrt{Rd}/R$', ylabel='departure from Hertz [%]', ylim=(-2, 2))
    for axes in (left, right):
        axes.legend(frameon=False, fontsize=9)
    save(figure, path)


def convergencePicture(path: PathLike, curves: Mapping[float, tuple[int, Curve]]) -> None:
    """Force over overlap on several meshes, relative to the finest; `curves` as of cases.convergence."""
    figure, ((axes,),) = newFigure(1, 1, 5.8, 3.8)
    *coarser, finest = sorted(curves)
    reference = curves[finest][1]
    for colour, marker, fineness in zip(rampColours(len(coarser)), MARKERS, coarser):
        unknowns, curve = curves[fineness]
        axes.plot(numpy.sqrt(curve.overlap / curve.yieldPoint.overlap), 100 * (curve.force / forceAt(reference, curve.overlap) - 1),
                  color=colour, marker=marker, ms=5, lw=1.3, mec='white', mew=0.5, label=f'{unknowns:,} unknowns')
    axes.axhline(0, color=GREY, lw=1.2, ls='--', label=f'{curves[finest][0]:,} unknowns')
    axes.set(xscale='log', xlabel=r'$\sqrt{d/d_y}$', ylabel='difference of the force\nfrom the finest mesh [%]')
    _plainTicks(axes)
    outerLegend(figure, [axes], columns=2)
    save(figure, path)


def _plainTicks(axes: Axes) -> None:
    """1, 2, 5, 10, ... on a logarithmic x axis that is short."""
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f'{x:g}'))
    axes.xaxis.set_minor_formatter(NullFormatter())


def collapsePicture(path: PathLike, curves: Sequence[Curve], law: Fit, disc: Fit) -> None:
    """The dimensionless curves of all cases with the fits, above, and the fits' errors, below; `law` and `disc` are the fit.Fits over sqrt(R d) and
    over the finite elements' half-width."""
    figure, panels = newFigure(2, 2, 4.7, 3.3, sharex='col', sharey='row')
    columns = ((law, fits.nominalHalfWidth, r'over $a = \sqrt{Rd}$, as the law in YADE'),
               (disc, lambda curve: curve.halfWidth, 'over the half-width, as the paper'))
    for (fit, halfWidth, title), (above, below) in zip(columns, panels.T):
        for i, curve in enumerate(curves):
            _drawCase(above, below, fit, fits.points([curve], halfWidth), i, f'{curve.name} ($R$ = {1e3 * curve.radius:.3g} mm)')
        above.plot([], [], color=GREY, lw=1.2, label='fit of the plastic law')
        above.set(xscale='log', yscale='log')
        above.set_title(title, fontsize=10.5)
        below.axhline(0, color=GREY, lw=1)
        below.set(xlabel=r'$(a - a_y)/a_y$')
    panels[0, 0].set_ylabel('$f_p/f_y$')
    panels[1, 0].set_ylabel('error of the fitted force [%]')
    outerLegend(figure, panels[0], columns=3)
    save(figure, path)


def _drawCase(above: Axes, below: Axes, fit: Fit, points: Points, i: int, label: str) -> None:
    """One case's points, its fitted curve and its errors; open marks, the later cases' smaller, as they lie on each other."""
    model = fits.force([fit.constants[name] for name in fits.CONSTANTS], points.ratio, points.excess)
    style: dict[str, Any] = dict(ls='', marker=MARKERS[i], ms=9 - 1.5 * i, mfc='none', mec=COLOURS[i], mew=1, zorder=3)
    above.plot(points.excess, points.force - 1, label=label, **style)
    above.plot(points.excess, model - 1, color=GREY, lw=1.2)
    below.plot(points.excess, 100 * (model / points.force - 1), **style)


def unloadingPicture(path: PathLike, loading: Curve, curves: Sequence[Curve]) -> None:
    """Loading and each unloading of one case, a panel for each, with the law's branches."""
    figure, (panels,) = newFigure(len(curves), 1, 4.6, 3.9)
    overlapUnit, forceUnit = loading.yieldPoint.overlap, loading.yieldPoint.force
    for axes, curve in zip(panels, curves):
        before = loading.overlap <= curve.overlap[0] * (1 + ROUNDING)
        axes.plot(loading.overlap[before] / overlapUnit, loading.force[before] / forceUnit, color=COLOURS[0], lw=1.6, label='loading')
        axes.plot(curve.overlap / overlapUnit, curve.force / forceUnit, ls='', marker=MARKERS[0], ms=5.5, color=COLOURS[1], mec='white', mew=0.6,
                  label='unloading', zorder=3)
        for branch, style, label in ((unloading.lawBranch(curve), '-', r'law: disc $a^2 = R d_{max}$'),
                                     (unloading.originalBranch(curve), ':', 'original $R$'),
                                     (unloading.discBranch(curve, curve.halfWidth[0]), '--', 'disc of the finite elements')):
            overlap = numpy.linspace(branch.residual, curve.overlap[0], 200)
            axes.plot(overlap / overlapUnit, unloading.force(branch, curve.modulus, overlap) / forceUnit, color=GREY, lw=1.3, ls=style, label=label)
        axes.set(xlabel='overlap $d/d_y$', xlim=(0, None), ylim=(0, None))
    panels[0].set_ylabel('force $f_N/f_y$')
    panels[0].legend(frameon=False, fontsize=9)
    save(figure, path)


def restitutionPicture(path: PathLike, comparisons: Sequence[Comparison], law: Fit, ranges: Any) -> None:
    """Restitution over the largest overlap: of the finite elements, of the law, and of the law fitted to smaller loads; `ranges` as of
    identify.Identification."""
    figure, ((axes,),) = newFigure(1, 1, 6.0, 4.0)
    for i, case in enumerate(dict.fromkeys(one.case for one in comparisons)):
        own = [one for one in comparisons if one.case == case]
        axes.plot([one.largest for one in own], [one.returned**0.5 for one in own], ls='', marker=MARKERS[i], ms=9 - 1.5 * i, mfc='none',
                  mec=COLOURS[i], mew=1.2, label=f'{case}, finite elements', zorder=3)
    largest = max(one.largest for one in comparisons)
    overlaps = numpy.geomspace(1.01, largest, 120)
    for colour, (reach, fit) in zip(rampColours(len(ranges)), ranges.items()):
        axes.plot(overlaps, _restitutions(fit, overlaps), color=colour, lw=1.1, ls='--', label=rf'law, $\sqrt{{Rd}}/R$ < {reach:.2g}')
    axes.plot(overlaps, _restitutions(law, overlaps), color=GREY, lw=1.6, label='law')
    axes.set(xscale='log', xlabel='largest overlap $d_{max}/d_y$', ylabel='restitution of a slow collision', ylim=(None, 1.02))
    _plainTicks(axes)
    axes.legend(frameon=False, fontsize=8.5, loc='lower left')
    save(figure, path)


def _restitutions(fit: Fit, overlaps: Floats) -> Any:
    constants = [fit.constants[name] for name in fits.CONSTANTS]
    return [unloading.lawRestitution(constants, 1, overlap) for overlap in overlaps]


def save(figure: Figure, path: PathLike) -> None:
    """Write the PNG; it takes the place of an older one only when it is complete."""
    drawn, partial = io.BytesIO(), f'{path}.part'
    figure.savefig(drawn, format='png', dpi=DPI)
    Image.open(drawn).convert('RGB').quantize(SHADES, dither=Image.Dither.NONE).save(partial, format='png', optimize=True)
    os.replace(partial, path)
