"""The force on the base over time, as mean and band over the seeds, from the records of the runs."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any

import numpy

from ...pictures.style import COLOURS, MARKERS, newFigure, rampColours
from ...statistics.curves import FEWEST, meanCurve
from ...typealiases import Floats
from ..quantities import xSentence, xText

RECORD = 'force.csv'  # of a run: time series of the impact
SAMPLES = 900       # of the common time axis
BEFORE = 0.1        # ms of the axis before the first touch
QUIET = 0.03        # of the highest mean force in the figure: a line that stays below has ended

Run = tuple[Floats, Floats]  # times and forces


def readRecord(path: str, staticForce: float) -> Run:
    """Time [s] since the impactor's first touch, and force on the base less the static one [N], of a run's force.csv.

    :raises ValueError: no such columns, or the impactor never touches
    """
    with open(path, encoding='utf-8') as file:
        columns = file.readline().strip().split(',')
        missing = {'time', 'baseForce', 'impactorForce'} - set(columns)
        if missing:
            raise ValueError(f'{path}: columns are missing: {", ".join(sorted(missing))}')
        rows = numpy.loadtxt(file, delimiter=',', ndmin=2)
    time, force, touch = (rows[:, columns.index(name)] for name in ('time', 'baseForce', 'impactorForce'))
    touching = numpy.flatnonzero(touch)
    if not len(touching):
        raise ValueError(f'{path}: the impactor never touches')
    return time - time[touching[0]], force - staticForce


def drawCurves(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """The figure: `panels` says what has a panel each, series or x; the other one has the lines.

    :param data: `GroupData`; :param series, values: those to draw; :param records: folder of the impacts' folders
    """
    curves = {(name, x): _load(data.rows(name, x), records) for name in series for x in values}
    curves = {key: runs for key, runs in curves.items() if runs}
    unit = _unit(curves)
    end = _end(curves)
    bySeries = panels == 'series'
    titles, lines = (series, values) if bySeries else (values, series)
    columns = min(len(titles), 3) if len(titles) != 4 else 2
    rows = -(-len(titles) // columns)
    figure, axes = newFigure(columns, rows, 4.4 if columns > 1 else 6.4, 3.6, sharex=True, sharey=True)
    colours: Sequence[Any] = rampColours(len(lines))
    if not bySeries:
        colours = [COLOURS[data.series.index(name) % len(COLOURS)] for name in lines]
    handles = {}
    for panel, title in zip(axes.flat, titles):
        for k, line in enumerate(lines):
            runs = curves.get((title, line) if bySeries else (line, title))
            if runs:
                handles[line] = _drawLine(panel, runs, end, colours[k], MARKERS[k % len(MARKERS)], (k + 0.5) / len(lines))
        panel.set_title(title if bySeries else xSentence(data.xLabel, title), fontsize=11)
        panel.axhline(0, color='black', lw=0.6)
        panel.set_xlim(-BEFORE, end)
    _finish(axes, len(titles), unit)
    _legend(figure, handles, lines, data.xLabel if bySeries else None)
    return figure


def _load(rows: Any, records: str) -> list[Run]:
    """[(times [ms], forces [N])] of a point's beds, each the mean over the places that were hit."""
    return [_meanOver([readRecord(os.path.join(records, run, RECORD), static) for run, static in zip(bed['run'], bed['staticForce'])])
            for _, bed in rows.groupby('bed', sort=False)]


def _meanOver(runs: Sequence[Run]) -> Run:
    """One record for several of the same bed, on the times of the shortest."""
    times = min((time for time, _ in runs), key=lambda time: time[-1])
    return 1e3 * times, numpy.mean([numpy.interp(times, *run) for run in runs], axis=0)


def _unit(curves: dict[Any, list[Run]]) -> str:
    """Turn the forces into kN if they are large enough. Returns the unit."""
    if max(force.max() for runs in curves.values() for _, force in runs) < 500:
        return 'N'
    for key, runs in curves.items():
        curves[key] = [(time, 1e-3 * force) for time, force in runs]
    return 'kN'


def _end(curves: dict[Any, list[Run]]) -> float:
    """The time [ms] when the last of the mean curves has died away, and a little more."""
    longest = max(time[-1] for runs in curves.values() for time, _ in runs)
    times = numpy.linspace(0, longest, 2000)
    means = [numpy.nan_to_num(meanCurve(runs, times)[0]) for runs in curves.values()]
    threshold = QUIET * max(mean.max() for mean in means)
    loud = max(numpy.flatnonzero(numpy.abs(mean) > threshold)[-1] for mean in means if (numpy.abs(mean) > threshold).any())
    return min(longest, 1.1 * times[loud] + BEFORE)


def _drawLine(axes: Any, runs: Sequence[Run], end: float, colour: Any, marker: str, phase: float) -> Any:
    """Mean with its band, or with the runs if they are too few for one; a few markers on the pulse, from `phase` on."""
    times = numpy.linspace(-BEFORE, end, SAMPLES)
    mean, half = meanCurve(runs, times)
    if len(runs) >= FEWEST:
        axes.fill_between(times, mean - half, mean + half, color=colour, alpha=0.2, lw=0)
    elif len(runs) > 1:
        for time, force in runs:
            axes.plot(time, force, color=colour, lw=0.6, alpha=0.5)
    step = SAMPLES // 8
    marked = [i for i in range(int(phase * step), SAMPLES, step) if abs(mean[i]) > QUIET * numpy.nanmax(mean)]
    return axes.plot(times, mean, color=colour, lw=1.6, marker=marker, ms=5, mec='white', mew=0.7, markevery=marked)[0]


def _finish(axes: Any, used: int, unit: str) -> None:
    for panel in axes.flat[used:]:
        panel.set_axis_off()
    columns = axes.shape[1]
    for k, panel in enumerate(axes.flat[:used]):
        panel.tick_params(labelbottom=k + columns >= used)
        if k + columns >= used:
            panel.set_xlabel('time since the first touch [ms]')
        if k % columns == 0:
            panel.set_ylabel(f'force on the base [{unit}]')


def _legend(figure: Any, handles: dict[Any, Any], lines: Iterable[Any], title: str | None) -> None:
    shown = [line for line in lines if line in handles and line != '']
    if shown:
        figure.legend([handles[line] for line in shown], [xText(line) for line in shown], title=title,
                      loc='outside upper center', ncols=min(len(shown), 8), frameon=False)
