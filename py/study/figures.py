"""Figures of a group: what may be asked for, and the pictures of single quantities over x or by variant."""
from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy

from .. import checks
from ..experiments.quantities import allNumbers, axisLabel, xText
from ..pictures.style import COLOURS, MARKERS, newFigure, outerLegend, save
from ..statistics.samples import typicalValue
from .experiments import QUANTITIES
from .measure import Measure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..experiments.experiment import Experiment
    from ..typealiases import Floats, PathLike
    from .groupdata import GroupData

KINDS = {'trend': ('y', 'x', 'series'), 'variants': ('y', 'x', 'series')}
OF_RECORDS = ('panels', 'x', 'series')   # keys of the kinds that an experiment draws from its records
PANELS = ('series', 'x')
LOG_RATIO = 8       # an axis is logarithmic if its largest value is that many times its smallest
FEWEST = 3          # runs for an interval in a picture: that of two is 13 standard errors wide and hides all else


def checkFigure(name: str, spec: Any, group: Mapping[str, Any]) -> dict[str, Any]:
    """`spec` if it can be drawn for `group`: {'experiment': `Experiment`, 'series': [names], 'xName': name, 'values': [of x]}.

    :raises ValueError: a name that makes no file name, unknown kind, key, quantity, series or x
    """
    kinds = {**dict.fromkeys(group['experiment'].drawings, OF_RECORDS), **KINDS}
    if not isinstance(name, str) or not re.fullmatch(r'[A-Za-z0-9][A-Za-z0-9._-]*', name):
        raise ValueError(f'figure = {name!r}: must be made of letters, digits, ".", "_" and "-", it becomes a file\'s name')
    if not isinstance(spec, dict) or 'kind' not in spec:
        raise ValueError(f'{name} = {spec!r}: a figure needs a kind, one of {", ".join(kinds)}')
    kind = checks.oneOf('kind', spec['kind'], tuple(kinds))
    for key in spec:
        if key != 'kind' and key not in kinds[kind]:
            raise ValueError(f'{key} = {spec[key]!r}: figures of kind {kind} know only {", ".join(kinds[kind])}')
    if kind == 'trend' and not allNumbers(group['values']):
        raise ValueError(f'kind = {kind!r}: x must be numbers for it, {group["xName"]} has {group["values"]!r}; use variants')
    checks.oneOf('panels', spec.get('panels', 'series'), PANELS)
    if 'y' in kinds[kind]:
        for y in _listed('y', spec.get('y')):
            group['experiment'].checkedQuantity('y', y)
    for key, known in (('series', group['series']), ('x', group['values'])):
        for value in _listed(key, spec[key]) if key in spec else ():
            checks.oneOf(key, value, tuple(known))
    return spec


def _listed(key: str, values: Any) -> Sequence[Any]:
    if not isinstance(values, (list, tuple)) or not values:
        raise ValueError(f'{key} = {values!r}: must be a list with an entry at least')
    for value in values:
        if list(values).count(value) > 1:
            raise ValueError(f'{key} = {values!r}: {value!r} is repeated')
    return values


def drawFigure(path: PathLike, spec: Mapping[str, Any], data: GroupData, records: PathLike, experiment: Experiment) -> int:
    """Draw a figure that `checkFigure` accepted.

    :param path: of the PNG; :param data: the group's `GroupData`; :param records: folder of the runs' folders; :param experiment: `Experiment`
    :returns: number of runs in it; 0: nothing was drawn
    """
    series = spec.get('series', data.series)
    values = [x for x in data.values if x in spec.get('x', data.values)]
    used = data.runs[[s in series and x in values for s, x in zip(data.runs['series'], data.runs['x'])]]
    if used.empty:
        return 0
    series = [name for name in series if name in set(used['series'])]
    if spec['kind'] in experiment.drawings:
        figure = experiment.drawings[spec['kind']](data, series, values, spec.get('panels', 'series'), records)
    else:
        figure = (_drawTrend if spec['kind'] == 'trend' else _drawVariants)(data, series, values, spec['y'])
    save(figure, path)
    return len(used)


def isLog(values: Sequence[float]) -> bool:
    """Whether a logarithmic axis suits the values."""
    numbers = numpy.asarray(values, dtype=float)
    return bool(len(numbers) > 1 and numbers.min() > 0 and numbers.max() >= LOG_RATIO * numbers.min())


def _drawTrend(data: GroupData, series: Sequence[str], values: Sequence[Any], quantities: Sequence[str]) -> Figure:
    """`quantities` over x: a panel for each, a line per series, runs as small dots."""
    figure, panels = newFigure(len(quantities), 1, 5.2, 4.3)
    for axes, y in zip(panels[0], quantities):
        for k, name in enumerate(series):
            _drawLine(axes, data, name, values, y, data.series.index(name), k - (len(series) - 1) / 2)
        axes.set(xlabel=data.xLabel, ylabel=axisLabel(QUANTITIES[y]))
        seen = [QUANTITIES[y].factor * value for name in series for x in values for value in data.sample(y, name, x)]
        if y == 'peak' and data.xName == 'thickness':   # towards which P goes as the bed gets thin
            seen.append(QUANTITIES['P0'].factor * data.runs['P0'].mean())
            axes.axhline(seen[-1], color='#666666', ls='--', lw=1.2, label='without a bed, $P_0$')
        if seen:
            _scaleAxes(axes, values, seen)
    outerLegend(figure, panels[0])
    return figure


def _drawLine(axes: Axes, data: GroupData, name: str, values: Sequence[float], y: str, index: int, place: float) -> None:
    """Typical value, interval and runs of a series; `place` moves it aside a little, so that bars do not cover each other."""
    factor, colour = QUANTITIES[y].factor, COLOURS[index % len(COLOURS)]
    marker = MARKERS[index % len(MARKERS)]
    samples = [(x, factor * data.sample(y, name, x)) for x in values]
    samples = [(x, sample) for x, sample in samples if len(sample)]
    if not samples:
        return
    at = _moved(numpy.array([x for x, _ in samples], dtype=float), values, 0.016 * place)
    estimates = [typicalValue(sample) for _, sample in samples]
    means = numpy.array([estimate.mean for estimate in estimates])
    axes.plot(at, means, marker=marker, ms=6.5, lw=1.6, color=colour, mec='white', mew=0.8, label=name or None, zorder=4)
    for x, (_, sample), estimate in zip(at, samples, estimates):
        if len(sample) > 1:
            axes.plot(_moved(numpy.full(len(sample), x), values, 0.005), sample, 'o', ms=2.8, color=colour, alpha=0.5, mew=0, zorder=3)
        if len(sample) >= FEWEST:
            axes.errorbar([x], [estimate.mean], [[estimate.mean - estimate.low], [estimate.high - estimate.mean]],
                          color=colour, lw=1.2, capsize=3, zorder=3.5)


def _moved(places: Floats, values: Sequence[float], share: float) -> Floats:
    if isLog(values):
        return places * (max(values) / min(values)) ** share
    return places + share * (max(values) - min(values))


def _scaleAxes(axes: Axes, values: Sequence[float], seen: Sequence[float]) -> None:
    """Logarithmic axes where the values ask for it; ticks at the x that there are."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter, NullLocator
    if isLog(values):
        axes.set_xscale('log')
    if len(values) <= 9:
        axes.xaxis.set_major_locator(FixedLocator(values))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f'{x:g}'))
    low, high = min(seen), max(seen)
    if isLog(seen):
        axes.set_yscale('log')
        axes.set_ylim(max(low / 3, axes.get_ylim()[0]), min(3 * high, axes.get_ylim()[1]))   # that of three runs may be very wide
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f'{y:g}'))
        axes.yaxis.set_minor_formatter(NullFormatter())
    elif high > low:
        reach = max(high - low, 0.02 * abs(high))
        bottom, top = axes.get_ylim()
        axes.set_ylim(max(bottom, low - reach), min(top, high + reach))


def _drawVariants(data: GroupData, series: Sequence[str], values: Sequence[Any], quantities: Sequence[str]) -> Figure:
    """Typical value and interval of each variant, a row each, with the difference to the first one in words."""
    height = 0.5 + 0.42 * len(values) * len(series)
    figure, panels = newFigure(len(quantities), 1, 6.4, 1.3 + height)
    for column, (axes, y) in enumerate(zip(panels[0], quantities)):
        rows = [(name, x) for name in series for x in values if len(data.sample(y, name, x))]
        for row, (name, x) in enumerate(rows):
            _drawVariant(axes, data, y, name, x, -row, COLOURS[data.series.index(name) % len(COLOURS)])
            first = next(other for other in rows if other[0] == name)
            if (name, x) != first:
                axes.annotate(_differenceText(data, y, name, first[1], x), (1.01, -row), xycoords=('axes fraction', 'data'),
                              va='center', fontsize=9, color='#444444')
            else:
                axes.axvline(QUANTITIES[y].factor * typicalValue(data.sample(y, name, x)).mean, color='#bbbbbb', lw=1, zorder=0)
        axes.set_yticks([-row for row in range(len(rows))],
                        [f'{name}: {xText(x)}' if name else xText(x) for name, x in rows] if column == 0 else [''] * len(rows))
        axes.set(xlabel=axisLabel(QUANTITIES[y]), ylim=(0.6 - len(rows), 0.6))
        axes.set_title('against the first', loc='right', fontsize=9, color='#444444', x=1.01, ha='left')
        axes.tick_params(axis='y', length=0)
    return figure


def _drawVariant(axes: Axes, data: GroupData, y: str, name: str, x: str, row: int, colour: str) -> None:
    sample = QUANTITIES[y].factor * data.sample(y, name, x)
    estimate = typicalValue(sample)
    if len(sample) >= FEWEST:
        axes.plot([estimate.low, estimate.high], [row, row], color=colour, lw=2.2, solid_capstyle='butt', zorder=2)
    axes.plot(sample, numpy.full(len(sample), row - 0.2), 'o', ms=3, color=colour, alpha=0.5, mew=0)
    axes.plot([estimate.mean], [row], MARKERS[0], ms=7.5, color=colour, mec='white', mew=0.9, zorder=3)


def _differenceText(data: GroupData, y: str, name: str, first: str, x: str) -> str:
    """'+12.3 % [-4.5, 29.1]': the difference of a variant to the first one, with its interval; bed by bed where both are on the same beds."""
    samples = [data.sample(y, name, first), data.sample(y, name, x)]
    measure = Measure(y, samples)
    return measure.text(measure.contrast(samples, [-1, 1]))
