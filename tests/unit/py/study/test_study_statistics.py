"""Statistics and findings of a study, on data of known truth."""
import itertools
import math

import numpy
import pytest
from judgedstudy import judged, verdicts
from scipy import stats

from yade.superquadric.experiments.impact.study import IMPACTS
from yade.superquadric.statistics import samples as statistics
from yade.superquadric.statistics.saturation import fitSaturation
from yade.superquadric.study.findings import checkFinding

GROUP = {'experiment': IMPACTS, 'series': ['sphere', 'cube'], 'xName': 'thickness', 'values': [0.008, 0.015, 0.025, 0.045]}
VARIANTS = {'experiment': IMPACTS, 'series': [''], 'xName': 'variant', 'values': ['as it is', 'softer']}


def test_intervalOfAMeanCoversIt():
    random = numpy.random.default_rng(1)
    for number in (2, 3, 5):
        estimates = [statistics.meanInterval(random.normal(7, 2, number)) for _ in range(3000)]
        assert numpy.mean([e.low <= 7 <= e.high for e in estimates]) == pytest.approx(0.95, abs=0.013)


def test_typicalValueOfPositiveOnesIsGeometric():
    sample = [0.5, 1.0, 4.0]
    estimate, logs = statistics.typicalValue(sample), statistics.meanInterval(numpy.log(sample))
    assert estimate.mean == pytest.approx(2 ** (1 / 3)) and estimate.number == 3
    assert 0 < estimate.low == pytest.approx(math.exp(logs.low)) and estimate.high == pytest.approx(math.exp(logs.high))
    assert statistics.typicalValue([-1.0, 2.0]) == statistics.meanInterval([-1.0, 2.0])


def test_singleValueHasNoInterval():
    estimate = statistics.meanInterval([3.0])
    assert estimate.mean == 3 and estimate.number == 1 and math.isnan(estimate.low) and math.isnan(estimate.high)


def test_differenceIsWelchs():
    a, b = [3.1, 2.9, 3.6], [2.2, 2.4, 1.1, 2.0]
    expected = stats.ttest_ind(a, b, equal_var=False)
    found = statistics.contrast([a, b], [1, -1])
    assert found.twoSided() == pytest.approx(expected.pvalue)
    assert (found.low, found.high) == pytest.approx(tuple(expected.confidence_interval(0.95)))
    assert found.above() == pytest.approx(stats.ttest_ind(a, b, equal_var=False, alternative='greater').pvalue)


def test_pooledDifferenceIsStudents():
    a, b = [3.1, 2.9, 3.6], [2.2, 2.4, 1.1, 2.0]
    assert statistics.contrast([a, b], [1, -1], pool=[a, b]).twoSided() == pytest.approx(stats.ttest_ind(a, b).pvalue)


def test_holm():
    assert statistics.holm([0.01, 0.04, math.nan, 0.03]) == pytest.approx([0.03, 0.06, math.nan, 0.06], nan_ok=True)


def test_trendOfTwoGroupsIsMannWhitneys():
    a, b = [1.0, 2.0, 4.0, 4.5], [3.0, 5.0, 6.0, 7.0]
    exact = stats.mannwhitneyu(b, a, alternative='greater', method='exact').pvalue
    assert statistics.trend({1: a, 2: b}).rises == pytest.approx(exact)


def test_perfectTrendHasTheLeastPValue():
    samples = {1: [1.0, 2.0], 2: [3.0, 4.0], 3: [5.0, 6.0]}
    assert statistics.leastP(samples) == pytest.approx(1 / 90)
    assert statistics.trend(samples).rises == pytest.approx(1 / 90)
    assert statistics.trend(samples).falls == 1 and statistics.trend(samples).share == 1


def test_trendCountsAllArrangements():
    """Against all 6!/(2! 3! 1!) arrangements, one by one."""
    x, y = [1, 1, 2, 2, 2, 3], [3.0, 1.0, 2.0, 6.0, 4.0, 5.0]
    rising = lambda order: sum((b > a) - (b < a) for (p, a), (q, b) in itertools.combinations(zip(x, order), 2) if q > p)
    scores = [rising(order) for order in itertools.permutations(y)]
    found = statistics.trend({1: y[:2], 2: y[2:5], 3: y[5:]})
    assert found.rises == pytest.approx(numpy.mean([score >= rising(y) for score in scores]))
    assert found.falls == pytest.approx(numpy.mean([score <= rising(y) for score in scores]))
    assert found.share == pytest.approx(rising(y) / 11)


def test_trendWithEqualValuesIsPermuted():
    """Two equal values at the same x: no pair is undecided, so that the exact p value of different values is near."""
    exact, permuted = (statistics.trend({1: [1.0, second], 2: [2.0, 4.0], 3: [3.0, 5.0]}) for second in (1.5, 1.0))
    assert permuted.rises == pytest.approx(exact.rises, abs=0.02) and permuted.rises != exact.rises
    assert permuted == statistics.trend({1: [1.0, 1.0], 2: [2.0, 4.0], 3: [3.0, 5.0]})
    assert statistics.trend({1: [1.0, 1.0], 2: [1.0, 1.0]})[1:] == (1, 1)


def test_clearTrends():
    assert judged({'test': 'falls'}, lambda s, x: 1000 / x)['verdict'] == 'supported'
    assert judged({'test': 'rises'}, lambda s, x: 1000 / x)['verdict'] == 'contradicted'


def test_weakestPartDecides():
    result = judged({'test': 'falls'}, lambda s, x: 1000 / x if s == 'a' else 1000 * x, series=('a', 'b'))
    assert result['verdict'] == 'contradicted'
    assert result['summary'] == 'Supported for a, contradicted for b.'
    assert [part['verdict'] for part in result['parts']] == ['supported', 'contradicted']


def test_trendThatTurnsIsNotSupported():
    result = judged({'test': 'rises'}, lambda s, x: {1: 100, 2: 1000, 3: 500, 4: 2000}[x], scatter=0.01, seeds=(1, 2, 3, 4, 5))
    assert result['verdict'] == 'undecided' and 'But it falls from 2 to 3' in result['text']


@pytest.mark.slow
def test_noiseIsMostlyUndecided():
    """Directional claims, each direction at 2.5 %. Bounds: 0.05 and 3.3 standard deviations of 120 repetitions."""
    flat = lambda s, x: 1000
    for finding, series in (({'test': 'falls'}, ('a',)), ({'test': 'above', 'series': ['a', 'b']}, ('a', 'b')),
                            ({'test': 'peaksAt', 'x': 2}, ('a',)), ({'test': 'ordered', 'series': ['a', 'b', 'c']}, ('a', 'b', 'c'))):
        shares = verdicts(120, finding, flat, series=series)
        assert shares['undecided'] >= 0.88, (finding, shares)
        assert shares['supported'] <= 0.09, (finding, shares)


def test_rangeOfX():
    truth = lambda s, x: 1000 / x if x <= 4 else 250 * (x - 3)
    assert judged({'test': 'falls', 'upTo': 4}, truth, x=range(1, 9))['verdict'] == 'supported'
    assert judged({'test': 'rises', 'from': 4}, truth, x=range(1, 9))['verdict'] == 'supported'
    assert judged({'test': 'falls'}, truth, x=range(1, 9))['verdict'] != 'supported'


BED = (0.008, 0.015, 0.025, 0.045, 0.06, 0.08, 0.095)


def levelling(bend, exponent=1.2):
    return lambda s, x: 1000 * (0.025 / min(x, bend)) ** exponent


@pytest.mark.parametrize('bend', [0.03, 0.05])
def test_saturationFindsTheBend(bend):
    random, inside, widths = numpy.random.default_rng(2), 0, []
    for _ in range(40):
        fit = fitSaturation({x: numpy.log(levelling(bend)('', x)) + 0.05 * random.standard_normal(3) for x in BED})
        inside += fit.low <= bend <= fit.high
        widths.append(fit.high - fit.low)
    assert inside >= 34 and numpy.median(widths) < 0.5 * bend


def test_saturationIsExactWithoutScatter():
    curve = numpy.exp(-numpy.minimum(BED, 0.05) / 0.02)
    fit = fitSaturation({x: numpy.log([y, y, y]) for x, y in zip(BED, curve)})
    assert fit.bend == pytest.approx(0.05, rel=0.02) and fit.shape == 'straight'


def test_saturationVerdicts():
    finding = {'test': 'saturates', 'hc': 0.05}
    assert judged(finding, levelling(0.05), x=BED)['verdict'] == 'supported'
    assert judged(finding, levelling(0.025), x=BED)['verdict'] == 'contradicted'
    assert judged(finding, levelling(0.08), x=BED, scatter=0.02)['verdict'] == 'contradicted'
    flat = judged(finding, lambda s, x: 1000, x=BED)
    assert flat['verdict'] == 'undecided' and 'no significant trend' in flat['text']


@pytest.mark.slow
def test_fallWithoutEndHasNoPlateau():
    """A power law through all x must not be taken for a plateau; 40 data sets, 2.5 % of which may err."""
    found = [judged({'test': 'saturates', 'hc': 0.085}, levelling(1), x=BED, seed=seed) for seed in range(40)]
    resolved = [result['parts'][0]['numbers']['resolved'] for result in found]
    assert sum(resolved) <= 5
    assert all('do not resolve a plateau' in result['text'] for result, was in zip(found, resolved) if not was)


def test_ordered():
    truth = lambda s, x: {'a': 700, 'b': 1000, 'c': 1400}[s] / x
    finding = {'test': 'ordered', 'series': ['a', 'b', 'c']}
    assert judged(finding, truth, series=('a', 'b', 'c'))['verdict'] == 'supported'
    assert judged({**finding, 'series': ['c', 'b', 'a']}, truth, series=('a', 'b', 'c'))['verdict'] == 'contradicted'
    crossing = judged(finding, lambda s, x: truth(s, x) * (1.6 if s == 'a' and x == 4 else 1), series=('a', 'b', 'c'))
    assert crossing['verdict'] != 'supported' and 'the other way round at 4' in crossing['text']


def test_peaksAt():
    truth = lambda s, x: 1000 / (1 + abs(math.log(x)))
    x = (0.4, 0.6, 0.8, 1, 1.5, 2)
    assert judged({'test': 'peaksAt', 'x': 1}, truth, x=x)['verdict'] == 'supported'
    assert judged({'test': 'peaksAt', 'x': 1}, lambda s, x: 1000 * x, x=x)['verdict'] == 'contradicted'
    assert judged({'test': 'peaksAt', 'x': 1}, truth, x=x, missing=(1,))['verdict'] == 'undecided'


def test_agreement():
    finding = {'test': 'agree', 'series': ['a', 'b']}
    same, options = lambda s, x: 1000 / x, {'series': ('a', 'b'), 'scatter': 0.03}
    assert judged(finding, same, **options)['verdict'] == 'supported'
    assert judged({**finding, 'margin': 0.001}, same, **options)['verdict'] == 'undecided'
    assert judged(finding, lambda s, x: same(s, x) * (1.4 if s == 'a' else 1), **options)['verdict'] == 'contradicted'


def test_differencesThatCancelAreNoAgreement():
    truth = lambda s, x: 1000 * (1.09 if (s == 'a') == (x == 1) else 1)
    result = judged({'test': 'agree', 'series': ['a', 'b']}, truth, series=('a', 'b'), x=(1, 2), scatter=0.02)
    ratios = [numbers['ratio'] for numbers in result['parts'][0]['numbers']['at'].values()]
    assert max(ratios) > 1.1 and result['parts'][0]['numbers']['pWithin'] < 0.01
    assert result['verdict'] == 'undecided', result['text']


def test_noEffect():
    options = {'series': ('a', 'b'), 'x': (1, 2, 3)}
    assert judged({'test': 'noEffect', 'from': 2}, lambda s, x: 1000 if x > 1 else 3000, scatter=0.02, **options)['verdict'] == 'supported'
    assert judged({'test': 'noEffect'}, lambda s, x: 1000 if x > 1 else 3000, scatter=0.02, **options)['verdict'] == 'contradicted'
    assert judged({'test': 'noEffect'}, lambda s, x: 1000, scatter=0.3, **options)['verdict'] == 'undecided'
    named = judged({'test': 'noEffect'}, lambda s, x: 1000, x=('as it is', 'softer'), series=('',), xName='variant', scatter=0.02)
    assert named['verdict'] == 'supported'


@pytest.mark.slow
def test_equivalenceIsRarelyClaimedAtItsMargin():
    """A true difference of just the margin may be called none in 5 % of cases."""
    finding = {'test': 'agree', 'series': ['a', 'b'], 'margin': 0.1}
    shares = verdicts(150, finding, lambda s, x: 1100 if s == 'a' else 1000, series=('a', 'b'))
    assert shares['supported'] <= 0.11


@pytest.mark.parametrize('limits, verdict', [
    ({'low': 900}, 'supported'), ({'high': 1100}, 'contradicted'), ({'low': 900, 'high': 4100}, 'supported'), ({'low': 1500}, 'contradicted'),
    ({'high': 1100, 'upTo': 1}, 'supported'), ({'low': 1500, 'from': 2, 'upTo': 2}, 'supported')])
def test_within(limits, verdict):
    found = judged({'test': 'within', **limits}, lambda s, x: 1000 * x, scatter=0.01)
    assert found['verdict'] == verdict and found['runs'] == 3 * len(found['text'].split(' at ')[1:])


def test_withinIsUndecidedWhereSeedsDisagree():
    found = judged({'test': 'within', 'low': 1000}, lambda s, x: 1000, scatter=0.05, seed=3)
    assert found['verdict'] == 'undecided' and found['parts'][0]['numbers']['outside']


def test_oneSeed():
    """Trends need no scatter within an x; differences take the one common to all points, or none."""
    options = {'seeds': (1,), 'x': (1, 2, 3, 4, 5, 6)}
    assert judged({'test': 'falls'}, lambda s, x: 1000 / x, **options)['verdict'] == 'supported'
    few = judged({'test': 'falls'}, lambda s, x: 1000 / x, seeds=(1,), x=(1, 2, 3))
    assert few['verdict'] == 'undecided' and 'So few runs cannot show a trend' in few['text']
    single = judged({'test': 'above', 'series': ['a', 'b']}, lambda s, x: 1000 if s == 'a' else 100, series=('a', 'b'), **options)
    assert single['verdict'] == 'undecided' and 'no interval' in single['text']


def test_missingRuns():
    part = judged({'test': 'falls'}, lambda s, x: 1000 / x, series=('a', 'b'), missing=[('b', x) for x in (2, 3, 4)])
    assert part['runs'] == 15 and [p['verdict'] for p in part['parts']] == ['supported', 'undecided']
    for finding in ({'test': 'falls'}, {'test': 'saturates', 'hc': 2.5}, {'test': 'peaksAt', 'x': 2}, {'test': 'noEffect'},
                    {'test': 'above', 'series': ['a', 'b']}, {'test': 'agree', 'series': ['a', 'b']}):
        nothing = judged(finding, lambda s, x: 1000, series=('a', 'b'), missing=(1, 2, 3, 4))
        assert nothing['verdict'] == 'undecided' and nothing['runs'] == 0 and nothing['text']


@pytest.mark.parametrize('finding, message', [
    ('falls', "finding = 'falls': must be a mapping"),
    ({'y': 'peak'}, 'test = None: a finding needs it'),
    ({'test': 'falls'}, 'y = None: a finding needs it'),
    ({'test': 'sinks', 'y': 'peak'}, "test = 'sinks': must be one of falls, "),
    ({'test': 'falls', 'y': 'shape'}, "y = 'shape': must be one of peak, "),
    ({'test': 'falls', 'y': 'peak', 'hc': 1}, 'hc = 1: test falls knows only test, y'),
    ({'test': 'saturates', 'y': 'peak'}, 'hc = None: test saturates needs it'),
    ({'test': 'saturates', 'y': 'peak', 'hc': 1}, 'hc = 1: must lie between 0.008 and 0.045'),
    ({'test': 'saturates', 'y': 'peak', 'hc': 0.02, 'from': 0.01}, 'from = 0.01: test saturates needs 4 values of thickness'),
    ({'test': 'falls', 'y': 'peak', 'upTo': 'high'}, "upTo = 'high': must be a number"),
    ({'test': 'falls', 'y': 'peak', 'series': ['ball']}, "series = 'ball': must be one of sphere, cube"),
    ({'test': 'falls', 'y': 'peak', 'series': []}, r'series = \[\]: must be a list of names'),
    ({'test': 'above', 'y': 'peak', 'series': ['cube']}, r"series = \['cube'\]: test above compares two"),
    ({'test': 'ordered', 'y': 'peak', 'series': ['cube', 'cube']}, 'a name is repeated'),
    ({'test': 'peaksAt', 'y': 'peak', 'x': 0.008}, 'x = 0.008: must be one of .* with others on both sides'),
    ({'test': 'noEffect', 'y': 'peak', 'margin': 0}, 'margin = 0: must lie between 0 and 1'),
    ({'test': 'within', 'y': 'peak'}, 'low = None: test within needs low, high or both'),
    ({'test': 'within', 'y': 'peak', 'low': 2, 'high': 1}, 'low = 2: must not be above high = 1'),
    ({'test': 'within', 'y': 'peak', 'low': 'none'}, "low = 'none': must be a number"),
    ({'test': 'falls', 'y': 'peak', 'paper': 3}, 'paper = 3: must be a sentence')])
def test_badFindings(finding, message):
    with pytest.raises(ValueError, match=message):
        checkFinding(finding, GROUP)


@pytest.mark.parametrize('finding', [{'test': 'falls', 'y': 'peak'}, {'test': 'noEffect', 'y': 'peak', 'from': 1}])
def test_namesAreNoAxis(finding):
    with pytest.raises(ValueError, match='x must be numbers for it, variant has'):
        checkFinding(finding, VARIANTS)
