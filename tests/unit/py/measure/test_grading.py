"""Gradings (grading) against closed forms: percentiles, breakage indices, fractal dimension, gaps."""
import math

import numpy as np
import pytest

from yade.superquadric.measure.grading import DECADE_STEP, FINES, GAP_MASS, Grading, einav, fractal, hardin, steepestPart, widestGap


def powerLaw(dimension, largest=0.04, number=20000):
    """Sizes of `number` particles of equal mass with F = (d/largest)^(3 - dimension); the masses are given beside."""
    shares = (np.arange(number) + 0.5) / number
    return Grading(largest * shares ** (1 / (3 - dimension)), np.ones(number))


def test_finerAndSizeOfFourParticles():
    grading = Grading([0.02, 0.01, 0.03, 0.04], [2, 1, 3, 4])
    assert grading.finer([0.005, 0.01, 0.015, 0.025, 0.04, 0.05]) == pytest.approx([0, 0, 0.1, 0.3, 0.6, 1])
    assert [grading.size(share) for share in (0.05, 0.1, 0.11, 0.3, 0.6, 1)] == [0.01, 0.01, 0.02, 0.02, 0.03, 0.04]
    assert grading.uniformity() == 3


def test_massesAreVolumesByDefault():
    assert Grading([0.01, 0.02]).finer(0.015) == pytest.approx(1 / 9)


@pytest.mark.parametrize('sizes, masses', (([], None), ([0.0, 0.1], None), ([-1.0], None), ([0.1], [1, 2]), ([0.1, 0.2], [1, 0])))
def test_badSizesAndMasses(sizes, masses):
    with pytest.raises(ValueError, match='sizes|masses'):
        Grading(sizes, masses)


def test_hardinOfHalvedParticles():
    """The curve moves by ln 2, over its way to the fines."""
    before, after = Grading([0.03] * 5), Grading([0.015] * 40)
    assert hardin(before, after) == pytest.approx(math.log(2) / math.log(0.03 / FINES), rel=1e-12)
    assert hardin(before, before) == 0


def test_hardinIsTheAreaBetweenTheCurves():
    before, after = powerLaw(1.0), powerLaw(2.2)
    logs = np.linspace(math.log10(FINES), math.log10(0.05), 200001)
    first, last = before.finer(10 ** logs), after.finer(10 ** logs)
    assert hardin(before, after) == pytest.approx(np.sum(last - first) / np.sum(1 - first), rel=1e-3)


def test_finesDoNotCount():
    """Nothing breaks below the fines: crushing them further changes nothing."""
    before = Grading([0.03])
    assert hardin(before, Grading([FINES / 10])) == pytest.approx(1) == pytest.approx(hardin(before, Grading([FINES])))
    with pytest.raises(ValueError, match='before'):
        hardin(Grading([FINES / 2]), before)


def test_einavIsOneAtTheUltimateGrading():
    before = Grading([0.02, 0.04])
    assert einav(before, powerLaw(2.6, number=200000)) == pytest.approx(1, rel=1e-3)
    assert einav(before, before) == 0
    with pytest.raises(ValueError, match='dimension = 3'):
        einav(before, before, 3)


@pytest.mark.parametrize('dimension', (0.5, 1.8, 2.5))
def test_fractalDimensionOfAPowerLaw(dimension):
    fit = fractal(powerLaw(dimension), 0.04)
    assert fit.dimension == pytest.approx(dimension, abs=0.03) and fit.correlation > 0.999
    assert fit.high == 0.04 and fit.low == pytest.approx(0.04 * 1e-3 ** (1 / (3 - dimension)), rel=0.06)


def test_noTailNoDimension():
    assert fractal(Grading([0.03, 0.031]), 0.02) is None and fractal(powerLaw(2), 0.03, low=0.02) is None


def test_aContinuousGradingHasNoGap():
    factor, low, high = widestGap(powerLaw(1.5))
    assert factor < 1.15 and high == pytest.approx(factor * low)


def test_aGapIsFoundAlsoWithALoneGrainInIt():
    small, large = np.linspace(0.005, 0.008, 2000), np.linspace(0.02, 0.03, 2000)
    for lone in ([], [0.0127]):
        sizes = np.concatenate([small, lone, large])
        masses = np.concatenate([np.full(2000, 1.0), [0.5 * GAP_MASS * 4000] * len(lone), np.full(2000, 1.0)])
        factor, low, high = widestGap(Grading(sizes, masses))
        assert factor == pytest.approx(0.02 / 0.008, rel=0.02) and low == pytest.approx(0.008, rel=0.01)


def test_oneSizeHasNoGapAndIsSteep():
    grading = Grading([0.02] * 10)
    assert widestGap(grading)[0] == 1 and steepestPart(grading)[0] == pytest.approx(1)


def test_steepnessOfAnEvenGrading():
    """Two decades, evenly: every interval has its part."""
    sizes = np.geomspace(1e-3, 1e-1, 20001)
    assert steepestPart(Grading(sizes, np.ones(20001)))[0] == pytest.approx(DECADE_STEP / 2, rel=3e-3)


def fragments(cuts):
    """Sizes over the parent's of the blocks into which the points `cuts` (N, 3) cut a unit cube."""
    sides = np.stack([cuts, 1 - cuts], axis=1)
    return np.concatenate([(sides[:, i, 0] * sides[:, j, 1] * sides[:, k, 2]) ** (1 / 3)
                           for i in (0, 1) for j in (0, 1) for k in (0, 1)])


def test_randomCutsLeaveNoGapsAndFixedOnesDo():
    """Two generations: of four equal balls, of eighteen, and of the cut cube; sizes over the first particle's."""
    cube = fragments(np.random.default_rng(3).random((300, 3)) ** 2)
    again = np.concatenate([size * fragments(np.random.default_rng(i).random((1, 3)) ** 2) for i, size in enumerate(cube[:800])])
    whole = Grading(np.concatenate([again, cube[800:]]))
    four, eighteen = (Grading([number ** (-1 / 3)] * number + [number ** (-2 / 3)] * number ** 2) for number in (4, 18))
    assert widestGap(four)[0] == pytest.approx(4 ** (1 / 3), rel=1e-9)
    assert widestGap(eighteen)[0] == pytest.approx(18 ** (1 / 3), rel=1e-9)
    assert widestGap(whole)[0] < 1.1 and steepestPart(whole)[0] < 0.3
    assert steepestPart(four)[0] == pytest.approx(0.5) and steepestPart(eighteen)[0] == pytest.approx(0.5)
