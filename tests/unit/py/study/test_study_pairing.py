"""Points on the same beds are compared bed by bed."""
import pandas
import pytest
import syntheticstudy
from judgedstudy import SEEDS, judged
from scipy import stats

from yade.superquadric.statistics import samples
from yade.superquadric.study.findings import judge
from yade.superquadric.study.groupdata import GroupData


def onBeds(values, beds=(1, 2, 3)):
    return pandas.Series(values, index=beds, dtype=float)


def test_differenceOnTheSameBedsIsPaired():
    a, b = onBeds([3.1, 2.9, 3.6]), onBeds([2.2, 2.4, 2.5])
    expected = stats.ttest_rel(a, b)
    found = samples.contrast([a, b], [1, -1])
    assert found.twoSided() == pytest.approx(expected.pvalue) and found.dof == 2
    assert (found.low, found.high) == pytest.approx(tuple(expected.confidence_interval(0.95)))
    assert samples.contrast([a[[3, 1, 2]], b], [1, -1]) == pytest.approx(found)


def test_bedsThatOneLacksAreLeftOut():
    found = samples.contrast([onBeds([3, 4, 9]), onBeds([1, 3], (1, 2))], [1, -1])
    assert (found.estimate, found.dof, found.number) == (1.5, 1, 2)
    chain = [onBeds([1, 2], (1, 2)), onBeds([1, 2], (2, 3)), onBeds([1, 4], (3, 4))]
    assert samples.contrast(chain, [1, 1, -2]).estimate == -2   # no bed is common to all: as if they shared none


def test_pairsOfSeveralBedsAreIndependent():
    """At each of two x both series are on the same beds, others at the other x: Welch's interval of the mean of two paired differences."""
    first, second = (onBeds([3, 4, 6]), onBeds([1, 3, 3])), (onBeds([5, 4, 6], (7, 8, 9)), onBeds([2, 3, 4], (7, 8, 9)))
    found = samples.contrast([*first, *second], [0.5, -0.5, 0.5, -0.5])
    differences = [a - b for a, b in (first, second)]
    assert found == pytest.approx(samples.contrast(list(map(list, differences)), [0.5, 0.5]))


def test_whatBedsHaveInCommonDropsOut():
    """Beds that differ by 30 %, impacts on them by 1 %: what is far within the scatter of the beds is seen."""
    shared, options = {'bedScatter': 0.3, 'scatter': 0.01}, {'series': ('a', 'b'), 'x': (1, 2)}
    truth = lambda s, x: 1000 if s == 'a' else 1050
    above = {'test': 'above', 'series': ['b', 'a']}
    assert judged(above, truth, **shared, **options)['verdict'] == 'supported'
    assert judged(above, truth, scatter=0.3, **options)['verdict'] == 'undecided'
    assert judged({'test': 'agree', 'series': ['a', 'b']}, truth, **shared, **options)['verdict'] == 'supported'


def test_noEffectOfVariantsOnTheSameBeds():
    options = {'x': ('as it is', 'softer', 'harder'), 'series': ('',), 'xName': 'variant', 'bedScatter': 0.3}
    finding = {'test': 'noEffect'}
    same = judged(finding, lambda s, x: 1000, scatter=0.01, **options)
    assert same['verdict'] == 'supported' and 'the largest of 2 differences' in same['text'] and 'compared in pairs' in same['text']
    other = judged(finding, lambda s, x: 1600 if x == 'harder' else 1000, scatter=0.01, **options)
    assert other['verdict'] == 'contradicted' and 'from as it is to harder' in other['text']
    # the scatter of one variant must not be hidden by the others' steadiness: each difference has its own
    assert judged(finding, lambda s, x: 1000, scatter=lambda x: 0.2 if x == 'harder' else 0.001, **options)['verdict'] == 'undecided'
    missing = judged(finding, lambda s, x: 1000, scatter=0.01, missing=('harder',), **options)
    assert missing['verdict'] == 'undecided' and 'There are no runs of harder.' in missing['text']


def test_noEffectNeedsEveryDifference():
    """A point of one run has no scatter of its own: its difference decides nothing, wherever it stands in the list."""
    for x in ('b', 'c'):
        group, rows = syntheticstudy.group('g', lambda s, x: 1000, ('a', 'b', 'c'), ('',), SEEDS, xName='variant', bedScatter=0.3, scatter=0.001)
        _, table = syntheticstudy.study((group, [row for row in rows if f'-{x}-' not in row['run'] or row['seed'] == 1]))
        assert judge({'test': 'noEffect', 'y': 'peak'}, GroupData(group, table))['verdict'] == 'undecided'


def test_anyEffectIsJudgedWithBedsAsBlocks():
    """Of two points that is the paired t test."""
    options = {'x': ('as it is', 'softer'), 'series': ('',), 'xName': 'variant', 'bedScatter': 0.3, 'scatter': 0.01}
    numbers = judged({'test': 'noEffect'}, lambda s, x: 1000, **options)['parts'][0]['numbers']
    assert numbers['pAnyEffect'] == pytest.approx(numbers['largest']['p'])


def test_aBedsValueIsTheMeanOverItsPlaces():
    """And a bed with an unfinished place does not count: it would be a mean over other places."""
    plan, rows = syntheticstudy.group('places', lambda name, x: 1000.0, [1, 2], ['a'], [1, 2])
    more = [{**row, 'run': row['run'] + '-2', 'peak': 3 * row['peak']} for row in rows]
    plan['points'] += [{**point, 'run': point['run'] + '-2'} for point in plan['points']]
    table = syntheticstudy.study((plan, rows + more))[1]
    sample = GroupData(plan, table).sample('peak', 'a', 1)
    expected = {row['bed']: 2 * row['peak'] for row in rows if 'a-1-' in row['run']}
    assert sample.to_dict() == pytest.approx(expected) and len(expected) == 2
    unfinished = table[table['run'] != more[0]['run']]
    assert set(GroupData(plan, unfinished).sample('peak', 'a', 1).index) == {rows[1]['bed']}
    assert GroupData(plan, unfinished).planned == 8
