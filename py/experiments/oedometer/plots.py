"""Pictures of oedometer tests, one or several together, like those of Zhao & Chi (2023)."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ...measure import contactstatistics
from ...measure.grading import Grading
from ...measure.scenesnapshot import SceneSnapshot
from ...measure.snapshot import Snapshot
from ...pictures import render
from ...pictures.style import COLOURS, newFigure, outerLegend, save
from ...scene.container import Container
from .case import Case

FORCE_EDGES = np.linspace(0, 5, 41)     # bins of a particle's mean contact force, over the mean
RELATIVE_LOWEST = 0.02                  # of a fragment's size over its ancestor's, in the picture
LABELS = {   # of axes: name of the panel: keywords of Axes.set
    'strains': dict(xlabel='axial strain [%]', ylabel='axial stress (dotted: lateral) [MPa]'),
    'voids': dict(xscale='log', xlabel='axial stress [MPa]', ylabel='void ratio'),
    'particles': dict(xlabel='axial strain [%]', ylabel='particles', ylim=(0, None)),
    'specimen': dict(xscale='log', xlabel='d [mm]', ylabel='mass finer [%]', title='specimen'),
    'fragments': dict(xscale='log', xlabel='size of fragment/size of first particle', xlim=(RELATIVE_LOWEST, 1.05), title='fragments'),
    'numbers': dict(xlabel='contacts of a particle', ylabel='share of the particles'),
    'forces': dict(xlabel='mean contact force of a particle/mean', ylabel='probability density', yscale='log'),
}
SIDES = ('all particles', 'without rattlers (none or one contact)')
NAMES = {'cube': 'cube', 'balls4': '4 balls', 'balls18': '18 balls', 'none': 'no breakage'}


def _name(case: Case) -> str:
    return NAMES[case.summary['parameters']['mode']]


def gradings(path: str, cases: Sequence[Case]) -> None:
    """Grading curves before and after; and of the fragments, over the sizes of the particles that they are of."""
    figure, panels = newFigure(2, 1, 5.2, 4.0)
    whole, relative = panels[0]
    _curve(whole, cases[0].before, 1e3, color='black', lw=1.4, ls='--', label='before')
    for colour, case in zip(COLOURS, cases):
        _curve(whole, case.after, 1e3, color=colour, lw=1.4, label=_name(case))
        if case.relative is not None:
            _curve(relative, case.relative, 1, color=colour, lw=1.4, label=_name(case))
    lowest = min(case.after.size(1e-3) for case in cases)
    whole.set(**LABELS['specimen'], xlim=(1e3 * lowest, None))
    relative.set(**LABELS['fragments'])
    plainTicks(whole)
    plainTicks(relative)
    outerLegend(figure, (whole,))
    save(figure, path)


def _curve(axes: Any, grading: Grading, unit: float, **style: Any) -> None:
    axes.step(unit * np.repeat(grading.sizes, 2), 100 * np.repeat(grading.sums, 2)[1:-1], where='post', **style)


def plainTicks(axes: Any) -> None:
    """1, 2, 5, 10, ... on a logarithmic axis x, not powers of ten."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f'{value:g}'))


def stresses(path: str, cases: Sequence[Case]) -> None:
    """Axial stress and lateral stress over strain; void ratio over axial stress; events."""
    figure, panels = newFigure(3, 1, 4.4, 3.8)
    strainPanel, voidPanel, numberPanel = panels[0]
    for colour, case in zip(COLOURS, cases):
        record, label = case.stress, _name(case)
        strainPanel.plot(100 * record['strain'], 1e-6 * record['plateStress'], color=colour, lw=1.4, label=label)
        strainPanel.plot(100 * record['strain'], 1e-6 * record['lateralStress'], color=colour, lw=0.8, ls=':')
        voidPanel.plot(1e-6 * record['plateStress'], record['voidRatio'], color=colour, lw=1.4)
        numberPanel.plot(100 * record['strain'], record['particles'], color=colour, lw=1.4)
    strainPanel.set(**LABELS['strains'])
    low = min(case.stress['plateStress'].min() for case in cases)
    voidPanel.set(**LABELS['voids'], xlim=(1e-6 * max(low, 1e4), None))
    numberPanel.set(**LABELS['particles'])
    plainTicks(voidPanel)
    outerLegend(figure, (strainPanel,))
    save(figure, path)


def contacts(path: str, cases: Sequence[Case]) -> None:
    """Distributions of contact number and mean contact force, with rattlers (left) and without (right)."""
    figure, panels = newFigure(2, 2, 4.6, 3.2)
    middles = (FORCE_EDGES[1:] + FORCE_EDGES[:-1]) / 2
    for colour, case in zip(COLOURS, cases):
        for column, chosen in enumerate((case.contacts, contactstatistics.withoutRattlers(case.contacts))):
            numbers, shares = contactstatistics.numberDistribution(chosen)
            panels[0, column].plot(numbers, shares, 'o-', ms=3, color=colour, lw=1, label=_name(case))
            density = contactstatistics.forceDistribution(chosen, FORCE_EDGES)
            panels[1, column].plot(middles, np.where(density > 0, density, np.nan), 'o-', ms=3, color=colour, lw=1)
    for column, title in enumerate(SIDES):
        panels[0, column].set(**LABELS['numbers'], title=title, xlim=(-0.5, 25.5))
        panels[1, column].set(**LABELS['forces'])
    outerLegend(figure, (panels[0, 0],))
    save(figure, path)


def specimens(path: str, views: Iterable[tuple[str, Snapshot]], container: Container) -> None:
    """The specimen from the side, its front half taken away: a panel for each (caption, `Snapshot`)."""
    render.picture(path, [(caption, SceneSnapshot.ofSnapshot(snapshot, container)) for caption, snapshot in views], cut=True)
