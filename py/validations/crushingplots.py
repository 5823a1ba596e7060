"""Pictures of single particle crushing, like figures 2-4 of Zhao & Chi (2023), without a display."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..pictures.style import COLOURS, MARKERS, newFigure, rampColours, save
from .cutdistribution import CutDistribution

if TYPE_CHECKING:
    from ..typealiases import Floats, PathLike

BINS = np.linspace(0, 1, 21)
MIDDLES = (BINS[1:] + BINS[:-1]) / 2
XLABEL, YLABEL = '$d/d_{max}$', 'part of the fragments [%]'


def frequencies(values: Floats, byMass: bool = False) -> Floats:
    """Part of the fragments in each of BINS, by number or by mass [%]."""
    counts = np.histogram(values, BINS, weights=values ** 3 if byMass else None)[0]
    return 100 * counts / counts.sum()


def exactFrequencies(exponent: float, ratios: Floats, byMass: bool = False) -> Floats:
    distribution = CutDistribution(exponent)
    return 100 * np.diff((distribution.massOfParents if byMass else distribution.ofParents)(BINS, ratios))


def exponents(path: PathLike, runs: Any, ratios: Any) -> None:
    """Sizes for several exponents of the cut (figure 2), by number and by mass.

    :param runs: {p: sizes over d_max}; :param ratios: the parents' sizes over d_max
    """
    figure, panels = newFigure(2, 1, 5, 3.8)
    for axes, byMass in zip(panels[0], (False, True)):
        for (exponent, values), colour, marker in zip(runs.items(), COLOURS, MARKERS):
            axes.plot(MIDDLES, exactFrequencies(exponent, ratios, byMass), color=colour, lw=1.5)
            axes.plot(MIDDLES, frequencies(values, byMass), marker, color=colour, ms=5, label=f'p = {exponent:g}')
        axes.plot([], [], color='0.3', lw=1.5, label='exact')
        axes.set(xlabel=XLABEL, ylabel='part of the mass [%]' if byMass else YLABEL, xlim=(0, 1), ylim=(0, None),
                 title='by mass' if byMass else 'by number')
    panels[0, 0].legend(frameon=False)
    figure.suptitle(f'{len(ratios)} parents, each broken once')
    save(figure, path)


def repetitions(path: PathLike, runs: Any, exponent: float, ratios: Any) -> None:
    """The same parents broken again with other seeds (figure 3). `runs`: sizes over d_max of each."""
    figure, panels = newFigure(1, 1, 6, 4)
    axes = panels[0, 0]
    for values in runs:
        axes.plot(MIDDLES, frequencies(values), color='0.65', lw=0.8)
    axes.plot([], [], color='0.65', lw=0.8, label=f'{len(runs)} seeds')
    axes.plot(MIDDLES, exactFrequencies(exponent, ratios), color=COLOURS[0], lw=2, label='exact')
    axes.set(xlabel=XLABEL, ylabel=YLABEL, xlim=(0, 1), ylim=(0, None), title=f'{len(ratios)} parents, p = {exponent:g}')
    axes.legend(frameon=False)
    save(figure, path)


def classes(path: PathLike, runs: Any) -> None:
    """Empirical distributions of parents of several classes of size (figure 4). `runs`: {(low, high) [m]: sizes over high}."""
    figure, panels = newFigure(1, 1, 6, 4)
    axes = panels[0, 0]
    for ((low, high), values), colour in zip(runs.items(), rampColours(len(runs))):
        ordered = np.sort(np.ravel(values))
        axes.plot(ordered, 100 * np.arange(1, len(ordered) + 1) / len(ordered), color=colour, lw=1, label=f'{1e3 * low:g}-{1e3 * high:g} mm')
    axes.set(xlabel=XLABEL, ylabel='part of the fragments that are smaller [%]', xlim=(0, 1), ylim=(0, 100), title='Parents of ten classes, p = 2')
    axes.legend(frameon=False, fontsize=8)
    save(figure, path)
