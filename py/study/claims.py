"""The tests of trends and of limits: each takes the data of a group and gives a verdict for each series.

Level: 5 %, two-sided, so a directional claim is supported at 2.5 %. A finding is supported if all its parts are: no correction is
due. It is contradicted if one of them is, so each may be at the level over their number only.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from ..experiments.quantities import counted, inUnit, xText
from ..statistics.samples import Contrast, holm, leastP, trend
from ..statistics.saturation import FEWEST, Saturation, fitSaturation
from .experiments import QUANTITIES
from .measure import Measure, pText

if TYPE_CHECKING:
    from .groupdata import GroupData

Samples: TypeAlias = Mapping[float, Any]  # x: values, as a pandas Series over their beds

ALPHA = 0.05
WIDEST = 2.0    # an interval of the bend that spans more than this factor supports no claim where it is


class Part(NamedTuple):
    """The verdict on a part of a finding: name of the series or pair, verdict, text, numbers for machines."""

    name: str
    verdict: str
    text: str
    numbers: dict[str, Any]


def verdict(for_: float, against: float, parts: int) -> str:
    """The verdict by one-sided p values of the claim and of its opposite, one of `parts` parts; nan decides nothing."""
    if for_ < ALPHA / 2:
        return 'supported'
    return 'contradicted' if against < ALPHA / 2 / parts else 'undecided'


def seriesOf(data: GroupData, finding: Mapping[str, Any]) -> list[str]:
    return finding.get('series', data.series)


def falls(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    return [_trendPart(data, finding, name, -1) for name in seriesOf(data, finding)]


def rises(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    return [_trendPart(data, finding, name, 1) for name in seriesOf(data, finding)]


def _trendPart(data: GroupData, finding: Mapping[str, Any], name: str, sign: int) -> Part:
    samples = data.samples(finding['y'], name, finding)
    if len(samples) < 2:
        return Part(name, 'undecided', f'{_runs(samples)} at {len(samples)} values of {data.xName} are too few.', {})
    measure = Measure(finding['y'], list(samples.values()))
    result = trend(samples)
    first, last = min(samples), max(samples)
    change = measure.contrast([samples[last], samples[first]], [1, -1])
    for_, against = (result.rises, result.falls) if sign > 0 else (result.falls, result.rises)
    decided = verdict(for_, against, len(seriesOf(data, finding)))
    turns = _turns(samples, measure, sign)
    if decided == 'supported' and turns:
        decided = 'undecided'
    text = (f'{_named(finding["y"])} goes from {measure.value(samples[first])} at {xText(first)} to {measure.value(samples[last])} at '
            f'{xText(last)}, by {measure.text(change)}; Jonckheere-Terpstra {pText(min(1, 2 * min(for_, against)))}, {_runs(samples)}.')
    if 2 * leastP(samples) > ALPHA:
        text += ' So few runs cannot show a trend, be it as clear as can be.'
    text += ''.join(f' But it {"falls" if sign > 0 else "rises"} from {xText(a)} to {xText(b)}: {measure.text(step)}.' for a, b, step in turns)
    return Part(name, decided, text, {'pRises': result.rises, 'pFalls': result.falls, 'share': result.share,
                                      'change': measure.numbers(change), 'turns': [[a, b] for a, b, _ in turns]})


def _turns(samples: Samples, measure: Measure, sign: int) -> list[tuple[float, float, Contrast]]:
    """Steps (x, next x, contrast) that significantly go against the trend, corrected after Holm for their number."""
    steps = [(a, b, measure.contrast([samples[b], samples[a]], [1, -1])) for a, b in pairwise(sorted(samples))]
    corrected = holm([step.below() if sign > 0 else step.above() for _, _, step in steps])
    return [step for step, p in zip(steps, corrected) if p < ALPHA / 2]


def saturates(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    return [_saturationPart(data, finding, name) for name in seriesOf(data, finding)]


def _saturationPart(data: GroupData, finding: Mapping[str, Any], name: str) -> Part:
    samples = data.samples(finding['y'], name, finding)
    measure = Measure(finding['y'], list(samples.values()))
    if len(samples) < FEWEST:
        return Part(name, 'undecided', f'{_runs(samples)} at {len(samples)} values of {data.xName}: the model needs {FEWEST}.', {})
    both = trend(samples)
    fit = fitSaturation({x: measure.of(sample) for x, sample in samples.items()})
    if fit is None:
        return Part(name, 'undecided', f'{_runs(samples)}: no scatter to judge the fit by.', {})
    if min(both.rises, both.falls) >= ALPHA / 2:
        return Part(name, 'undecided', f'{_named(finding["y"])} has no significant trend with {data.xName} at all '
                    f'({pText(2 * min(both.rises, both.falls))}, {_runs(samples)}): there is no bend to be found.', {})
    earlier, later = (float((1 + (side).sum()) / (1 + len(fit.replicates)))
                      for side in (fit.replicates >= finding['hc'], fit.replicates <= finding['hc']))
    inside = fit.resolved and fit.low <= finding['hc'] <= fit.high <= WIDEST * fit.low
    decided = verdict(0 if inside else 1, min(earlier, later), len(seriesOf(data, finding)))
    return Part(name, decided, _saturationText(data, finding, samples, measure, fit),
                {'hc': fit.bend, 'low': fit.low, 'high': fit.high, 'shape': fit.shape, 'resolved': fit.resolved, 'misfit': fit.misfit})


def _saturationText(data: GroupData, finding: Mapping[str, Any], samples: Samples, measure: Measure, fit: Saturation) -> str:
    largest, claimed = max(samples), finding['hc']
    shape = fit.shape if fit.shape == 'power law' else 'exponential' if measure.log else 'straight line'
    text = (f'{_named(finding["y"])} is constant from {data.xName} = {fit.bend:.3g} [{fit.low:.3g}, {fit.high:.3g}] on (before: {shape}; '
            f'{_runs(samples)}); the claim: {claimed:g}.')
    if not fit.resolved:
        text += f' The data do not resolve a plateau: the interval reaches the largest value, {largest:g}.'
    beyond = [x for x in samples if x >= claimed]
    if len(beyond) > 1:
        change = measure.contrast([samples[largest], samples[min(beyond)]], [1, -1])
        text += f' From {min(beyond):g} to {largest:g} it changes by {measure.text(change)}.'
    return text


def peaksAt(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    return [_peakPart(data, finding, name) for name in seriesOf(data, finding)]


def _peakPart(data: GroupData, finding: Mapping[str, Any], name: str) -> Part:
    """Supported if y(x) is above the mean of all others, y rises up to x and falls from there, each at 2.5 %, and no mean is higher."""
    samples, x = data.samples(finding['y'], name, finding), finding['x']
    others = [place for place in samples if place != x]
    if x not in samples or not (others and min(others) < x < max(others)):
        return Part(name, 'undecided', f'runs are missing at {x:g} or on one of its sides.', {})
    measure = Measure(finding['y'], list(samples.values()))
    top = measure.contrast([samples[x], *(samples[o] for o in others)], [1, *(-1 / len(others) for _ in others)])
    left = trend({place: sample for place, sample in samples.items() if place <= x})
    right = trend({place: sample for place, sample in samples.items() if place >= x})
    rivals = {o: measure.contrast([samples[o], samples[x]], [1, -1]) for o in others}
    beaten = smallest(holm([rival.above() for rival in rivals.values()]))
    highest = max(samples, key=lambda place: measure.of(samples[place]).mean())
    claim = max(smallest([top.above()]), left.rises, right.falls) if highest == x else 1
    # the opposite in three ways, so that each counts threefold
    against = 3 * min(beaten, left.falls, right.rises)
    text = (f'{_named(finding["y"])} at {x:g} differs from the mean of all others by {measure.text(top)}; towards {x:g} it rises with '
            f'{pText(left.rises)} (one-sided), beyond it falls with {pText(right.falls)}; the highest mean is that at {xText(highest)}; ')
    text += 'next to it: ' + ', '.join(f'{measure.text(rivals[o])} at {o:g}' for o in (
        max(o for o in others if o < x), min(o for o in others if o > x))) + f'; {_runs(samples)}.'
    return Part(name, verdict(claim, against, len(seriesOf(data, finding))), text,
                {'top': measure.numbers(top), 'pLeft': left.rises, 'pRight': right.falls, 'highest': highest,
                 'rivals': {f'{o:g}': measure.numbers(rival) for o, rival in rivals.items()}})


def within(data: GroupData, finding: Mapping[str, Any]) -> list[Part]:
    return [_withinPart(data, finding, name) for name in seriesOf(data, finding)]


def _withinPart(data: GroupData, finding: Mapping[str, Any], name: str) -> Part:
    """Supported if all runs lie between the limits, contradicted if at some x none does: no statistics, a count."""
    samples = data.samples(finding['y'], name, finding)
    if not samples:
        return Part(name, 'undecided', 'no runs.', {})
    low, high = finding.get('low', -math.inf), finding.get('high', math.inf)
    inside = {x: [low <= value <= high for value in sample] for x, sample in samples.items()}
    decided = 'supported' if all(map(all, inside.values())) else 'undecided' if all(map(any, inside.values())) else 'contradicted'
    values = '; '.join(f'{", ".join(inUnit(QUANTITIES[finding["y"]], value) for value in sample)} at {xText(x)}' for x, sample in samples.items())
    return Part(name, decided, f'{_named(finding["y"])} is {values}; {_runs(samples)}.', {'outside': [x for x in inside if not all(inside[x])]})


def smallest(values: Iterable[float]) -> float:
    """Smallest p value that is one; 1 if there is none."""
    return min([p for p in values if not math.isnan(p)], default=1)


def _runs(samples: Samples) -> str:
    return counted(sum(map(len, samples.values())))


def _named(y: str) -> str:
    return QUANTITIES[y].name
