"""How the study's pictures look: colours for the colour-blind, markers, panels, files."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..typealiases import PathLike

COLOURS = ('#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9', '#000000')   # after Okabe and Ito
MARKERS = ('o', 's', '^', 'D', 'v', 'P', 'X')
RAMP = ((0.0, '#1b1464'), (0.3, '#0f6fae'), (0.55, '#11a08a'), (0.8, '#d9a400'), (1.0, '#d1400f'))


def rampColours(number: int) -> list[tuple[float, float, float, float]]:
    """`number` colours in order, dark blue to red by way of green and yellow, of rising then falling lightness."""
    from matplotlib.colors import LinearSegmentedColormap
    ramp = LinearSegmentedColormap.from_list('ramp', RAMP)
    return [ramp(place) for place in numpy.linspace(0, 1, number)] if number > 1 else [ramp(0.25)]


def newFigure(columns: int, rows: int, width: float, height: float, **sharing: Any) -> tuple[Figure, Any]:
    """A figure without a display, and its panels (rows, columns); `width`, `height` of a panel in inches."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    figure = Figure(figsize=(max(width * columns, 5.6), height * rows + 0.4), layout='constrained')
    FigureCanvasAgg(figure)
    panels = figure.subplots(rows, columns, squeeze=False, **sharing)
    for axes in panels.flat:
        axes.spines[['top', 'right']].set_visible(False)
        axes.grid(True, color='#e8e8e8', lw=0.7)
        axes.set_axisbelow(True)
    return figure, panels


def outerLegend(figure: Figure, panels: Any, columns: int = 6) -> None:
    """One legend for all panels, above them, with what is labelled in any, in at most `columns` columns."""
    found: dict[str, Any] = {}
    for axes in panels:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            found.setdefault(label, handle)
    if found:
        figure.legend(found.values(), found.keys(), loc='outside upper center', ncols=min(len(found), columns), frameon=False)


def save(figure: Figure, path: PathLike) -> None:
    """Write the PNG; it takes the place of an older one only when it is complete."""
    partial = f'{path}.part'
    figure.savefig(partial, format='png', dpi=150, metadata={'Software': None})
    os.replace(partial, path)
