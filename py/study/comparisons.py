"""The tests of differences between series, and of their absence; levels and parts as in `claims`."""
from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations, pairwise, product
from typing import TYPE_CHECKING, Any, TypeAlias

import pandas
from scipy import stats

from ..experiments.quantities import counted, xText
from ..statistics.samples import Contrast, holm
from .claims import ALPHA, Part, smallest, verdict
from .experiments import QUANTITIES
from .measure import Measure, pText

if TYPE_CHECKING:
    from ..typealiases import Floats
    from .groupdata import GroupData

Point: TypeAlias = tuple[str, Any]  # name of the series, x

MARGIN = 0.1        # differences up to 10 % are none, unless the finding says otherwise


def above(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    high, low = finding['series']
    return [_comparison(data, finding, high, low, 1, everywhere=False)]


def ordered(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    pairs = list(pairwise(finding['series']))
    return [_comparison(data, finding, high, low, len(pairs), everywhere=True) for low, high in pairs]


def _comparison(data: GroupData, finding: Mapping[str, Any], high: str, low: str, parts: int, everywhere: bool) -> Part:
    """Is `high` above `low`? By the mean difference over all x that have both.

    Supported if that is significant and no x shows significantly (after Holm) the opposite; with `everywhere` the means must have
    the order claimed at every x. Contradicted if the mean difference or one x shows significantly the opposite.
    """
    title = f'{high} above {low}'
    pairs = _shared(data, finding, high, low)
    if not pairs:
        return Part(title, 'undecided', 'no x has runs of both.', {})
    measure = Measure(finding['y'], [sample for _, *both in pairs for sample in both])
    total = _overall(measure, pairs)
    single = [(x, measure.contrast([a, b], [1, -1])) for x, a, b in pairs]
    higher, lower = holm([one.above() for _, one in single]), holm([one.below() for _, one in single])
    against = 2 * smallest([total.below(), *lower])   # the opposite in two ways, so that each counts twice
    reversed_ = [x for (x, one), p in zip(single, lower) if 2 * p < ALPHA / 2 / parts]
    wrong = [x for x, one in single if one.estimate <= 0]
    decided = verdict(total.above() if not reversed_ else 1, against, parts)
    if decided == 'supported' and everywhere and wrong:
        decided = 'undecided'
    clear = [x for (x, _), p in zip(single, higher) if p < ALPHA / 2]
    text = (f'{QUANTITIES[finding["y"]].name} differs by {measure.text(total)} in the mean over {len(pairs)} value{"s" * (len(pairs) > 1)} of '
            f'{data.xName}, {pText(total.twoSided())}; by itself (Holm) it is clear at {_list(clear)} of {_list(x for x, *_ in pairs)}')
    text += f'; the means are the other way round at {_list(wrong)}' if wrong else ''
    text += f', significantly at {_list(reversed_)}' if reversed_ else ''
    return Part(title, decided, f'{text}; {_count(pairs)}.',
                {'overall': measure.numbers(total), 'at': {xText(x): measure.numbers(one) for x, one in single}})


def agree(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    """Supported if the mean difference over all x lies within the margin by two one-sided tests and no x is significantly outside;
    contradicted if it, or a single x (after Holm), is significantly outside. Differences that cancel in the mean are no agreement: at no x
    may that of the means be beyond the margin."""
    first, second = finding['series']
    title, share = f'{first} and {second}', finding.get('margin', MARGIN)
    pairs = _shared(data, finding, first, second)
    if not pairs:
        return [Part(title, 'undecided', 'no x has runs of both.', {})]
    measure = Measure(finding['y'], [sample for _, *both in pairs for sample in both])
    margin, total = measure.margin(share), _overall(measure, pairs)
    single = [(x, measure.contrast([a, b], [1, -1])) for x, a, b in pairs]
    farther = holm([_outside(one, margin) for _, one in single])
    beyond = [x for (x, _), p in zip(single, farther) if 2 * p < ALPHA / 2]
    within = _within(total, margin)
    decided = _equivalence(within, 2 * smallest([_outside(total, margin), *farther]))   # two ways to be outside
    text = (f'{QUANTITIES[finding["y"]].name} differs by {measure.text(total)} in the mean over {len(pairs)} value{"s" * (len(pairs) > 1)} of '
            f'{data.xName} (no difference: {pText(total.twoSided())}); within {100 * share:g} %: {pText(within)}')
    text += f'; clearly farther apart at {_list(beyond)}' if beyond else ''
    widest = max(single, key=lambda item: abs(item[1].estimate))
    if decided == 'supported' and abs(widest[1].estimate) > margin:
        decided = 'undecided'
    text += f'; the largest single difference is {measure.text(widest[1])} at {xText(widest[0])}; {_count(pairs)}.'
    return [Part(title, decided, text, {'margin': share, 'pWithin': within, 'overall': measure.numbers(total),
                                        'at': {xText(x): measure.numbers(one) for x, one in single}})]


def noEffect(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    """Supported if all differences (between all points; of variants, to the first one of the series) lie within the margin, by two
    one-sided tests each; all must, so none is corrected, and no planned point may lack runs. Contradicted if one is significantly
    (after Holm) outside."""
    series, share = finding.get('series', data.series), finding.get('margin', MARGIN)
    points = {(name, x): sample for name in series for x, sample in data.samples(finding['y'], name, finding).items()}
    compared = _compared(data, series, points)
    if not compared:
        return [Part('', 'undecided', f'{len(points)} points with runs are too few.', {})]
    measure = Measure(finding['y'], list(points.values()))
    margin = measure.margin(share)
    pairs = [(a, b, measure.contrast([points[b], points[a]], [1, -1], pooled=True)) for a, b in compared]
    a, b, widest = max(pairs, key=lambda pair: abs(pair[2].estimate))
    within = max((_within(pair[2], margin) for pair in pairs), key=lambda p: math.inf if math.isnan(p) else p)   # one nan is nan
    decided = _equivalence(within, smallest(holm([_outside(pair[2], margin) for pair in pairs])))
    anyEffect = _variance(measure, points)
    runs = sum(map(len, points.values()))
    text = (f'the largest of {len(pairs)} differences in {QUANTITIES[finding["y"]].name}, from {_pointName(a)} to {_pointName(b)}, is '
            f'{measure.text(widest)}; all within {100 * share:g} %: {pText(within)}; any effect at all (analysis of variance): {pText(anyEffect)}; '
            f'{counted(runs)}{", compared in pairs where they are on the same bed" if measure.shared else ""}.')
    if len({x for _, x in points}) == 1:
        text += f' All are at one {data.xName}: whether that matters is not seen.'
    missing = [point for point in product(series, data.plannedIn(finding)) if point not in points]
    if missing:
        decided = 'undecided' if decided == 'supported' else decided
        text += f' There are no runs of {", ".join(map(_pointName, missing))}.'
    return [Part('', decided, text, {'margin': share, 'pWithin': _number(within), 'pAnyEffect': _number(anyEffect),
                                     'largest': measure.numbers(widest)})]


def _compared(data: GroupData, series: Sequence[str], points: Mapping[Point, Any]) -> list[tuple[Point, Point]]:
    """The pairs of points that `noEffect` compares."""
    if data.numeric:
        return list(combinations(points, 2))
    groups = [[point for point in points if point[0] == name] for name in series]
    return [(group[0], other) for group in groups for other in group[1:]]


def _shared(data: GroupData, finding: Mapping[str, Any], first: str, second: str) -> list[tuple[Any, Any, Any]]:
    """[(x, sample of the first series, of the second)] where both have runs."""
    a, b = (data.samples(finding['y'], name, finding) for name in (first, second))
    return [(x, a[x], b[x]) for x in a if x in b]


def _overall(measure: Measure, pairs: Sequence[tuple[Any, Any, Any]]) -> Contrast:
    """Mean over all x of the difference first - second."""
    samples = [sample for _, *both in pairs for sample in both]
    return measure.contrast(samples, [1 / len(pairs), -1 / len(pairs)] * len(pairs))


def _within(difference: Contrast, margin: float) -> float:
    """p value of two one-sided tests: small if the difference lies within the margin."""
    ends = difference.below(margin), difference.above(-margin)
    return math.nan if any(map(math.isnan, ends)) else max(ends)


def _outside(difference: Contrast, margin: float) -> float:
    """One-sided p value: small if the difference lies beyond the margin on its side."""
    return difference.above(margin) if difference.estimate > 0 else difference.below(-margin)


def _equivalence(within: float, outside: float) -> str:
    if outside < ALPHA / 2:
        return 'contradicted'
    return 'supported' if within < ALPHA else 'undecided'


def _variance(measure: Measure, points: Mapping[Point, Any]) -> float:
    """p value of an analysis of variance over the points, with the beds as blocks where points share them; nan without scatter."""
    samples = [measure.of(sample) for sample in points.values()]
    if measure.shared:
        return _blockVariance(pandas.DataFrame(samples).dropna(axis=1).to_numpy())
    if sum(map(len, samples)) <= len(samples) or not any(sample.std() > 0 for sample in samples):
        return math.nan
    return float(stats.f_oneway(*samples).pvalue)


def _blockVariance(values: Floats) -> float:
    """p value of 'all rows of `values` (points, beds) are alike' with the columns as blocks; nan if no two beds are common to all."""
    rows, columns = values.shape
    if columns < 2:
        return math.nan
    effects = values.mean(axis=1) - values.mean()
    rest = ((values - values.mean(axis=0) - effects[:, None]) ** 2).sum() / (columns - 1)
    return float(stats.f.sf(columns * (effects ** 2).sum() / rest, rows - 1, (rows - 1) * (columns - 1))) if rest > 0 else math.nan


def _number(value: Any) -> float | None:
    return None if math.isnan(value) else value


def _pointName(point: Point) -> str:
    name, x = point
    return f'{name} {xText(x)}'.strip()


def _list(values: Iterable[Any]) -> str:
    return ', '.join(map(xText, values)) or 'none'


def _count(pairs: Sequence[Any]) -> str:
    return counted(sum(len(sample) for _, *both in pairs for sample in both))
