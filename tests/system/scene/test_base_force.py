"""What the base and the wall carry: Newton's second law for the bed as a whole.

Over any time the mean vertical force of base and wall on the particles is their weight plus the change of their momentum
over that time; at rest it is the weight. The base's share is therefore the weight less what the wall carries.
"""
import math
import random

import pytest
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq

GRAVITY = 9.81
RADIUS = 0.018  # of the container [m]
SIZE = 4e-3  # radius of the sphere of a particle's volume [m]


@pytest.fixture(scope='module')
def container():
    """80 rounded cubes that have just fallen into a cylinder with friction."""
    O.reset()
    generator = random.Random(2)
    material = CurvatureMat(young=2e6, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                            tangentialDamping=0.3, rollingFriction=0.01)
    O.materials.append(material)
    result = sq.cylinderContainer(RADIUS, 1.0, material)
    extents = sq.equalVolumeExtents(SIZE, 5, 5)
    spacing = 3.4 * SIZE
    for i in range(80):
        center = Vector3((i % 2 - 0.5) * spacing, 0, (0.6 + i // 2) * spacing)
        O.bodies.append(sq.superquadric(center, extents, 5, 5, material, sq.randomOrientation(generator)))
        O.bodies[-1].state.vel = Vector3(0, 0, -2)
    O.engines = sq.superquadricEngines(gravity=(0, 0, -GRAVITY))
    O.dt = 0.1 * sq.criticalTimeStep()
    run(0.2)
    return result


def run(duration):
    O.run(math.ceil(duration / O.dt), wait=True)


def particles():
    return [body for body in O.bodies if body.dynamic]


def weight():
    return GRAVITY * sum(body.state.mass for body in particles())


def momentum():
    return sum(body.state.mass * body.state.vel[2] for body in particles())


def meanLoads(container, duration):
    """Mean downward forces [N] on base and wall over `duration` [s], and the mean rate of the bed's downward momentum."""
    steps = math.ceil(duration / O.dt)
    base = wall = 0.0
    before = momentum()
    for _ in range(steps):
        O.step()
        base -= O.forces.f(container.baseId)[2]
        wall -= sum(O.forces.f(i)[2] for i in container.sideIds)
    return base / steps, wall / steps, (before - momentum()) / (steps * O.dt)


def test_loadsOfAMovingBedFollowFromItsMomentum(container):
    base, wall, falling = meanLoads(container, 0.01)
    assert base + wall == pytest.approx(weight() - falling, rel=1e-9)


def test_baseCarriesTheWeightLessWhatTheWallCarries(container):
    run(0.2)
    # The base gives way by 2 mm, so that the bed slides along the wall and hangs on it.
    O.bodies[container.baseId].state.vel = Vector3(0, 0, -0.02)
    run(0.1)
    O.bodies[container.baseId].state.vel = Vector3.Zero
    run(0.3)
    base, wall, _ = meanLoads(container, 0.05)
    print(f'weight {weight():.5f} N, base {base:.5f} N, wall {wall:.5f} N')
    assert wall > 0.05 * weight()  # else the wall could be left out unnoticed
    assert base == pytest.approx(weight() - wall, abs=1e-3 * weight())
