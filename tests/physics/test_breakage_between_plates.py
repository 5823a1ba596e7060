"""A particle between two plates that approach, as in a crushing test: it breaks when its stress reaches its strength, and the
force then is what the criterion says.
And the strengths of many particles: Weibull's distribution, and its fall with size."""
import math

import numpy as np
import pytest
from yade import O, utils
from yade.minieigenHP import Quaternion
from yade.wrapper import BreakableMat, BreakageEngine

import yade.superquadric as sq

RADIUS = 5e-3
SPEED = 0.05       # of the upper plate [m/s]: its blow swings the particle by some percent of the force at the end
RESOLUTION = 2e-3  # growth of the force in one step, over the force, with a margin


def press(criterion, strength, shape=None):
    """Load a particle until it breaks: the event, and the forces [N] and overlaps [m] at its two plates at the step before, as arrays."""
    O.reset()
    material = BreakableMat(young=1e9, poisson=0.2, density=2500, frictionAngle=0.4, normalDamping=0.3, characteristicStrength=1e30)
    shape = shape or sq.particleShape('sphere', RADIUS)
    half = shape.extents[2]
    body = O.bodies.append(shape.body((0, 0, half), Quaternion.Identity, material))
    O.bodies[body].state.strength = strength
    lower, upper = (O.bodies.append(utils.wall((0, 0, z), axis=2, material=material)) for z in (0, 2 * half))
    O.bodies[upper].state.vel = (0, 0, -SPEED)
    engine = BreakageEngine(criterion=criterion, smallestFragment=0.2 * half, seed=2)
    O.engines = [engine, *sq.superquadricEngines(gravity=(0, 0, 0))]
    O.dt = 0.1 * material.criticalTimeStep(0.1 * half)
    while not engine.eventTimes:
        contacts = [interaction for interaction in O.interactions if interaction.isReal]
        before = [(i.phys.normalForce.norm(), i.phys.overlap) for i in contacts]
        O.step()
        assert O.iter < 1e5
    forces, overlaps = np.array(before).T
    return engine.events()[0], forces, overlaps


def test_forceCriterionBreaksAtStrengthTimesSizeSquared():
    event, forces, _ = press('force', 2e5)
    assert event['size'] == pytest.approx(2 * RADIUS, rel=1e-14) and event['strength'] == 2e5
    assert event['strength'] <= event['value'] < event['strength'] * (1 + RESOLUTION)
    assert max(forces) / event['size'] ** 2 == pytest.approx(event['strength'], rel=RESOLUTION)


def test_octahedralStressOfAPairOfForces():
    """Two forces F at the distance of d less an overlap: sqrt(2)/3 F (d - overlap)/V, which is nearly 0.9 F/d^2 (McDowell & de Bono 2013)."""
    event, forces, overlaps = press('octahedral', 2e5)
    size = event['size']
    expected = math.sqrt(2) / 3 * np.sum(forces * (size - overlaps) / 2) / (math.pi / 6 * size ** 3)
    assert event['strength'] <= event['value'] < event['strength'] * (1 + RESOLUTION)
    assert event['value'] == pytest.approx(expected, rel=RESOLUTION)
    assert event['value'] == pytest.approx(0.9 * np.mean(forces) / size ** 2, rel=0.02)


def test_blockBetweenPlatesBreaks():
    shape = sq.ParticleShape((RADIUS, RADIUS, 0.8 * RADIUS), 6, 6, False)
    event, forces, overlaps = press('octahedral', 2e5, shape)
    expected = math.sqrt(2) / 3 * np.sum(forces * (shape.extents[2] - overlaps / 2)) / shape.volume
    assert event['value'] == pytest.approx(expected, rel=RESOLUTION) and len(event['children']) == 8


def test_fragmentsStayBetweenThePlates():
    press('force', 2e5)
    O.run(2000, True)
    for body in O.bodies:
        if body.state.mass > 0:
            assert 0 < body.state.pos[2] < O.bodies[2].state.pos[2]


def test_strengthsAreWeibulls():
    """Kolmogorov's test (level 0.1 %) of exp(-(d/d0)^3 (s/s0)^m) for two sizes; the medians differ by (d1/d2)^(-3/m)."""
    O.reset()
    number, modulus, material = 2000, 3.5, BreakableMat(characteristicStrength=2e6, referenceSize=0.01, weibullModulus=3.5)
    for i in range(2 * number):
        O.bodies.append(utils.sphere((0.1 * i, 0, 0), 5e-3 if i < number else 2e-3, material=material))
    O.engines = [BreakageEngine(seed=11)]
    O.step()
    strengths = np.array([body.state.strength for body in O.bodies]).reshape(2, number)
    for size, values in zip((0.01, 0.004), np.sort(strengths)):
        exact = 1 - np.exp(-(size / 0.01) ** 3 * (values / 2e6) ** modulus)
        steps = np.arange(number + 1) / number
        assert max((exact - steps[:-1]).max(), (steps[1:] - exact).max()) < 1.95 / math.sqrt(number)
    ratio = np.median(strengths[1]) / np.median(strengths[0])
    assert ratio == pytest.approx((0.004 / 0.01) ** (-3 / modulus), rel=0.05)
