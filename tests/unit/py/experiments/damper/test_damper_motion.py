"""What is read from a record of a vibration (motion) and from O.energy (damperenergy), on signals that are known."""
import cmath
import math

import numpy as np
import pytest

from yade.superquadric.experiments.damper import energy as damperenergy
from yade.superquadric.experiments.damper import motion

FREQUENCY, PERIODS, SAMPLES = 25.0, 24, 100
TIMES = (0.3 + np.arange(PERIODS * SAMPLES)) / (FREQUENCY * SAMPLES)


def wave(multiple, amplitude=1.0, lag=0.0):
    """A sine of a multiple of the drive's frequency."""
    return amplitude * np.sin(2 * math.pi * multiple * FREQUENCY * TIMES - math.radians(lag))


def describe(values):
    velocities = np.gradient(values, TIMES)
    return motion.describe(TIMES, values, velocities, PERIODS, SAMPLES, FREQUENCY, force=2.0)


@pytest.mark.parametrize('lag', (0, 40, 180, 300))
def test_amplitudeAndPhaseLagOfTheFundamental(lag):
    described = describe(3e-3 * (5 + wave(1, 1, lag) + wave(3, 0.5, 70)))
    assert described['amplitude'] == pytest.approx(3e-3, rel=1e-9)
    assert described['receptance'] == pytest.approx(1.5e-3, rel=1e-9)
    assert cmath.exp(1j * math.radians(described['phaseLag'] - lag)).real == pytest.approx(1, abs=1e-12)
    assert described['mean'] == pytest.approx(15e-3, rel=1e-9)
    assert described['fundamentalShare'] == pytest.approx(0.8, rel=1e-9) and described['harmonicShare'] == pytest.approx(1, rel=1e-9)


@pytest.mark.parametrize('period', (1, 2, 3, 5))
def test_subharmonicIsFoundAsALineAndAsThePeriod(period):
    described = describe(wave(1) + (wave(1 / period, 0.3, 20) if period > 1 else 0))
    assert described['period'] == period
    found = {round(frequency / FREQUENCY * period): amplitude for frequency, amplitude in described['lines']}
    # 24 periods do not hold a whole number of five: that line leaks.
    assert found[period] == pytest.approx(1, rel=0.05)
    assert period == 1 or found[1] == pytest.approx(0.3, rel=0.05 if period < 5 else 0.1)
    assert period == 5 or described['harmonicShare'] == pytest.approx(1 if period == 1 else 1 / 1.09, rel=1e-9)


def test_noiseHasNoPeriod():
    noise = np.random.default_rng(1).normal(size=len(TIMES))
    described = describe(np.cumsum(noise) * 0.05 + wave(1))
    assert described['period'] is None and described['harmonicShare'] < 0.8
    assert np.mean(motion.repetition(noise, SAMPLES)) == pytest.approx(1, abs=0.05)  # unrelated with itself


def test_aMotionThatIsNoneIsNotDividedBy():
    described = describe(np.zeros(len(TIMES)))
    assert described['amplitude'] == described['harmonicShare'] == 0 and described['lines'] == []


def test_phasePlaneOfASineFillsPiQuartersOfItsRectangleOneOfImpactsAllOfIt():
    angles = 2 * math.pi * FREQUENCY * TIMES
    assert motion.loopFill(3 + np.sin(angles), 7 * np.cos(angles), PERIODS) == pytest.approx(math.pi / 4, rel=1e-3)
    triangle, square = np.arcsin(np.sin(angles)), np.sign(np.cos(angles))
    assert motion.loopFill(triangle, square, PERIODS) == pytest.approx(1, rel=0.03)
    assert motion.loopFill(np.ones(9), np.ones(9), 1) == 0


def test_accountTakesWhateverSinksThereAre():
    before = {'boxDrive': -1.0, 'gravWork': 0.5, 'kinetic': 0.1, 'elastPotential': 0.0, 'boxKinetic': 0.1, 'boxSpring': 0.3, 'yieldDissip': 0.0,
              'nonconservative': 0.0}
    after = {'boxDrive': -3.0, 'gravWork': 0.4, 'kinetic': 0.2, 'elastPotential': 0.1, 'boxKinetic': 0.0, 'boxSpring': 0.4, 'yieldDissip': 1.0,
             'nonconservative': 0.02, 'rollingDampDissip': 0.5}  # the last came up later
    energy = damperenergy.account(before, after)
    assert energy['work'] == pytest.approx(2) and energy['gravityWork'] == pytest.approx(0.1)
    assert energy['sinks'] == pytest.approx({'yieldDissip': 1.0, 'rollingDampDissip': 0.5})
    assert energy['shares'] == pytest.approx({'yieldDissip': 2 / 3, 'rollingDampDissip': 1 / 3})
    assert energy['stored'] == pytest.approx(0.2)
    assert energy['balanceError'] == pytest.approx((1.5 + 0.2 + 0.02 - 2.1) / 2)
