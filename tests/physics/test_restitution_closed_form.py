"""The closed form of the restitution (py/scene/restitution.py): against the paper's values, and against balls on a wall in YADE.

Wang & Ji, Acta Phys. Sin. 67, 094501 (2018): 0.85 for Cn = 0.05; 0.820 for 0.06 and 0.725 for 0.1 by integration (test_restitution.py).
"""
import math

import pytest
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.scene.restitution import collisionDuration, normalDampingFor, restitutionOf

RADIUS = 1e-3
MATERIAL = dict(young=70e9, poisson=0.33, density=2700, frictionAngle=0)


def rebound(speed, **material):
    """Speed after, and duration of, a ball's blow against a wall: (speed [m/s], duration [s])."""
    O.reset()
    material = CurvatureMat(**{**MATERIAL, **material})
    O.bodies.append([utils.wall(0, axis=2, sense=1, material=material), utils.sphere((0, 0, RADIUS), RADIUS, material=material)])
    ball = O.bodies[1]
    ball.state.vel = Vector3(0, 0, -speed)
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 2e-3 * sq.criticalTimeStep()
    O.run(10, True)
    while O.interactions.countReal():
        O.step()
    return ball.state.vel[2], O.time


@pytest.mark.parametrize('damping, restitution', ((0, 1), (0.05, 0.847), (0.06, 0.820), (0.1, 0.725)))
def test_known_values(damping, restitution):
    assert restitutionOf(damping) == pytest.approx(restitution, abs=5e-4)


@pytest.mark.parametrize('restitution', (1, 0.999, 0.9, 0.5, 0.3, 0.14))
def test_damping_is_the_inverse(restitution):
    assert restitutionOf(normalDampingFor(restitution)) == pytest.approx(restitution, rel=1e-12)


@pytest.mark.parametrize('restitution', (0.9, 0.5, 0.2))
def test_a_ball_rebounds_with_the_restitution_that_was_asked_for(restitution):
    after, _ = rebound(1, normalDamping=normalDampingFor(restitution))
    assert after == pytest.approx(restitution, rel=1e-3)


@pytest.mark.parametrize('restitution', (0.1, 1.001, -1, math.nan, 'much'))
def test_restitution_that_cannot_be_is_refused(restitution):
    with pytest.raises(ValueError, match='restitution = '):
        normalDampingFor(restitution)


@pytest.mark.parametrize('speed', (0.1, 1))
def test_duration_of_an_elastic_blow(speed):
    _, duration = rebound(speed)
    mass, modulus = 2700 * 4 / 3 * math.pi * RADIUS ** 3, 70e9 / 2 / (1 - 0.33 ** 2)
    assert duration == pytest.approx(collisionDuration(mass, RADIUS, modulus, speed), rel=0.01)  # Johnson's 2.87 is rounded
