"""Findings: a statement of a paper, the statistical test that it is put to, and the verdict."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from .. import checks
from ..experiments.quantities import allNumbers
from . import claims, comparisons

if TYPE_CHECKING:
    from .claims import Part
    from .groupdata import GroupData


class Test(NamedTuple):
    """A test of a finding.

    judge: function (data, finding) -> list of `claims.Part`; required, optional: keys of the finding beside those that all have;
    fewest: values of x that it needs; axis: whether x must be numbers.
    """

    judge: Any
    required: Any
    optional: Any
    fewest: Any
    axis: Any


COMMON = ('test', 'y', 'paper')
RANGE = ('from', 'upTo')
LIMITS = ('low', 'high')
NUMBERS = (*RANGE, *LIMITS, 'hc', 'x', 'margin')
TESTS = {
    'falls': Test(claims.falls, (), ('series', *RANGE), 2, True),
    'rises': Test(claims.rises, (), ('series', *RANGE), 2, True),
    'saturates': Test(claims.saturates, ('hc',), ('series', *RANGE), 4, True),
    'ordered': Test(comparisons.ordered, ('series',), RANGE, 1, False),
    'noEffect': Test(comparisons.noEffect, (), ('series', 'margin', *RANGE), 1, False),
    'peaksAt': Test(claims.peaksAt, ('x',), ('series', *RANGE), 3, True),
    'within': Test(claims.within, (), ('series', *LIMITS, *RANGE), 1, False),
    'above': Test(comparisons.above, ('series',), RANGE, 1, False),
    'agree': Test(comparisons.agree, ('series',), ('margin', *RANGE), 1, False),
}
STRENGTH = ('contradicted', 'undecided', 'supported')   # a finding is as strong as the weakest of its parts


def checkFinding(finding: Any, group: Mapping[str, Any]) -> dict[str, Any]:
    """`finding`, its numbers as such, if it can be tested in `group`.

    :param group: {'experiment': `Experiment`, 'series': [names], 'xName': name, 'values': [of x]}
    :raises ValueError: unknown test, key, quantity or series, a missing key, a value that cannot be
    """
    if not isinstance(finding, dict):
        raise ValueError(f'finding = {finding!r}: must be a mapping with test and y')
    for key in ('test', 'y'):
        if key not in finding:
            raise ValueError(f'{key} = None: a finding needs it ({finding!r})')
    test = TESTS[checks.oneOf('test', finding['test'], tuple(TESTS))]
    group['experiment'].checkedQuantity('y', finding['y'])
    known = COMMON + test.required + test.optional
    for key in finding:
        if key not in known:
            raise ValueError(f'{key} = {finding[key]!r}: test {finding["test"]} knows only {", ".join(known)}')
    for key in test.required:
        if key not in finding:
            raise ValueError(f'{key} = None: test {finding["test"]} needs it')
    if not isinstance(finding.get('paper', ''), str):
        raise ValueError(f'paper = {finding["paper"]!r}: must be a sentence')
    _checkSeries(finding, group)
    _checkX(finding, group, test)
    if finding['test'] == 'within':
        _checkLimits(finding)
    if 'margin' in finding:
        checks.above('margin', finding['margin'], 0, 1)
    return {**finding, **{key: checks.finite(key, finding[key]) for key in NUMBERS if key in finding}}


def _checkSeries(finding: Mapping[str, Any], group: Mapping[str, Any]) -> None:
    series = finding.get('series')
    if series is None:
        return
    if not isinstance(series, (list, tuple)) or not series:
        raise ValueError(f'series = {series!r}: must be a list of names')
    for name in series:
        checks.oneOf('series', name, tuple(group['series']))
    if len(set(series)) < len(series):
        raise ValueError(f'series = {series!r}: a name is repeated')
    if finding['test'] in ('above', 'agree') and len(series) != 2:
        raise ValueError(f'series = {series!r}: test {finding["test"]} compares two')
    if finding['test'] == 'ordered' and len(series) < 2:
        raise ValueError(f'series = {series!r}: test ordered needs two at least')


def _checkLimits(finding: Mapping[str, Any]) -> None:
    if not any(key in finding for key in LIMITS):
        raise ValueError('low = None: test within needs low, high or both')
    low, high = (checks.finite(key, finding[key]) if key in finding else default for key, default in zip(LIMITS, (-math.inf, math.inf)))
    if low > high:
        raise ValueError(f'low = {finding["low"]!r}: must not be above high = {finding["high"]!r}')


def _checkX(finding: Mapping[str, Any], group: Mapping[str, Any], test: Test) -> None:
    values = group['values']
    if not allNumbers(values):
        used = [key for key in RANGE if key in finding]
        if test.axis or used:
            key = (used or ['test'])[0]
            raise ValueError(f'{key} = {finding[key]!r}: x must be numbers for it, {group["xName"]} has {values!r}')
        return
    low, high = (checks.finite(key, finding[key]) if key in finding else default
                 for key, default in zip(RANGE, (-math.inf, math.inf)))
    inside = [value for value in values if low <= value <= high]
    if len(inside) < test.fewest:
        key = next((key for key in RANGE if key in finding), 'test')
        raise ValueError(f'{key} = {finding[key]!r}: test {finding["test"]} needs {test.fewest} values of {group["xName"]}, '
                         f'it has {inside!r}')
    if 'hc' in finding:
        checks.above('hc', finding['hc'], min(inside), max(inside))
    if 'x' in finding and not (finding['x'] in inside and min(inside) < finding['x'] < max(inside)):
        raise ValueError(f'x = {finding["x"]!r}: must be one of {inside!r}, with others on both sides')


def judge(finding: Mapping[str, Any], data: GroupData) -> dict[str, Any]:
    """The verdict on a finding.

    :param finding: as `checkFinding` accepts it; :param data: the group's `GroupData`
    :returns: dict with the finding's keys and verdict, summary (which part has which, '' if all agree), text (the numbers in
        words), parts (list of dicts with name, verdict, text, numbers), runs (how many it rests on)
    """
    parts = TESTS[finding['test']].judge(data, finding)
    return {**finding, 'verdict': STRENGTH[min(STRENGTH.index(part.verdict) for part in parts)],
            'summary': _summary(parts), 'text': ' '.join(f'{part.name}: {part.text}' if part.name else part.text for part in parts),
            'runs': sum(len(sample) for name in claims.seriesOf(data, finding)
                        for sample in data.samples(finding['y'], name, finding).values()),
            'parts': [part._asdict() for part in parts]}


def _summary(parts: Sequence[Part]) -> str:
    """Which part has which verdict, where they differ."""
    if len({part.verdict for part in parts}) == 1:
        return ''
    named = {verdict: [part.name for part in parts if part.verdict == verdict] for verdict in reversed(STRENGTH)}
    sentence = ', '.join(f'{verdict} for {" and ".join(names)}' for verdict, names in named.items() if names)
    return sentence[0].upper() + sentence[1:] + '.'
