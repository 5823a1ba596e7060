"""The exact distribution of the cut against 10^6 draws, and the tests that stand on it; single particle crushing against both."""
import numpy as np
import pytest

from yade.superquadric.validations import cutdistribution
from yade.superquadric.validations import singlecrushing

PERMILLE = 1.95  # P(sqrt(n) D > 1.95) = 0.1 % (Kolmogorov), of independent values


@pytest.mark.parametrize('exponent', [1, 2, 3])
def test_exactDistributionIsThatOfAMillionDraws(exponent):
    number = 10 ** 6
    one = cutdistribution.draw(np.random.default_rng(exponent), exponent, number)[np.arange(number), np.arange(number) % 8]  # one of each parent: independent
    assert cutdistribution.distance(one, cutdistribution.CutDistribution(exponent)) < PERMILLE / np.sqrt(number)


def test_massDistributionIsThatOfDraws():
    sizes, ratios = cutdistribution.draw(np.random.default_rng(1), 2, 10 ** 5), [1.0]
    for x in (0.3, 0.6, 0.9):
        found = (sizes ** 3 * (sizes <= x)).sum() / (sizes ** 3).sum()
        assert cutdistribution.CutDistribution(2).massOfParents(x, ratios) == pytest.approx(found, abs=5e-3)


def test_drawnFragmentsFillTheirParents():
    sizes = cutdistribution.draw(np.random.default_rng(1), 2, 1000)
    np.testing.assert_allclose((sizes ** 3).sum(axis=1), 1, rtol=1e-12)


def test_agreementTellsExponentsApart():
    parents = singlecrushing.uniformSizes(28e-3, 30e-3, 100, seed=1)
    fragments = singlecrushing.breakEach(parents, 2, seed=1)
    assert fragments.shape == (100, 8)
    np.testing.assert_allclose((fragments ** 3).sum(axis=1), np.array(parents) ** 3, rtol=1e-12)
    assert cutdistribution.agreement(fragments, 2, parents, 30e-3, samples=200)[1] > 0.01
    for wrong in (1, 3):
        assert cutdistribution.agreement(fragments, wrong, parents, 30e-3, samples=200)[1] < 0.01


def test_classesOfParentsAreToldApartOnlyIfTheyDiffer():
    rng = np.random.default_rng(4)
    alike = [cutdistribution.draw(rng, 2, 100) for _ in range(4)]
    assert cutdistribution.sameDistribution(alike, samples=200)[1] > 0.01
    assert cutdistribution.sameDistribution(alike[:3] + [cutdistribution.draw(rng, 3, 100)], samples=200)[1] < 0.02


@pytest.mark.parametrize('call, name', [(lambda: cutdistribution.CutDistribution(0), 'exponent'), (lambda: singlecrushing.uniformSizes(2, 1, 5, 1), 'low'),
                                        (lambda: singlecrushing.uniformSizes(1, 2, 0, 1), 'number'), (lambda: singlecrushing.breakEach([1, -1], 2, 1), 'sizes'),
                                        (lambda: singlecrushing.breakEach([1], 0, 1), 'cutExponent')])
def test_badInputIsNamed(call, name):
    with pytest.raises(ValueError, match=name):
        call()
