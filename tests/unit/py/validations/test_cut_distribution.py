"""The exact distribution of the cut against 10^6 draws, and the tests that stand on it."""
import numpy as np
import pytest

from yade.superquadric.validations import cutdistribution

PERMILLE = 1.95  # P(sqrt(n) D > 1.95) = 0.1 % (Kolmogorov), of independent values


@pytest.mark.parametrize('exponent', [1, 2, 3])
def test_exactDistributionIsThatOfAMillionDraws(exponent):
    number = 10 ** 6
    fragments = cutdistribution.draw(np.random.default_rng(exponent), exponent, number)
    one = fragments[np.arange(number), np.arange(number) % 8]  # of each parent: independent
    assert cutdistribution.distance(one, cutdistribution.CutDistribution(exponent)) < PERMILLE / np.sqrt(number)


def test_massDistributionIsThatOfDraws():
    sizes, ratios = cutdistribution.draw(np.random.default_rng(1), 2, 10 ** 5), [1.0]
    for x in (0.3, 0.6, 0.9):
        found = (sizes ** 3 * (sizes <= x)).sum() / (sizes ** 3).sum()
        assert cutdistribution.CutDistribution(2).massOfParents(x, ratios) == pytest.approx(found, abs=5e-3)


def test_drawnFragmentsFillTheirParents():
    sizes = cutdistribution.draw(np.random.default_rng(1), 2, 1000)
    np.testing.assert_allclose((sizes ** 3).sum(axis=1), 1, rtol=1e-12)


@pytest.mark.parametrize('exponent, agrees', [(2, True), (1, False), (3, False)])
def test_agreementTellsExponentsApart(exponent, agrees):
    parents = np.random.default_rng(1).uniform(28e-3, 30e-3, 100)
    fragments = cutdistribution.draw(np.random.default_rng(2), 2, 100) * parents[:, None]
    assert (cutdistribution.agreement(fragments, exponent, parents, 30e-3, samples=200)[1] > 0.01) == agrees


def test_classesOfParentsAreToldApartOnlyIfTheyDiffer():
    rng = np.random.default_rng(4)
    alike = [cutdistribution.draw(rng, 2, 100) for _ in range(4)]
    assert cutdistribution.sameDistribution(alike, samples=200)[1] > 0.01
    assert cutdistribution.sameDistribution(alike[:3] + [cutdistribution.draw(rng, 3, 100)], samples=200)[1] < 0.02


def test_badExponentIsNamed():
    with pytest.raises(ValueError, match='exponent'):
        cutdistribution.CutDistribution(0)
