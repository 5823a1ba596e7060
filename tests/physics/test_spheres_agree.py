"""Superquadrics with n1 = n2 = 2 and equal half sizes are spheres: under the same law they move as YADE's Sphere does.

Single collisions are compared number by number. A settled bed is chaotic, so beds from several seeds are compared by
their means: packing fraction and coordination number of the two kinds must agree within the 99.9 % interval of Student's t
for the difference of two means, which must itself be narrow enough to mean something.
"""
import math
import random

import numpy as np
import pytest
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq

MATERIAL = dict(young=1e8, poisson=0.25, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                tangentialDamping=0.2, rollingFriction=0.01)
VELOCITY = Vector3(0.3, -0.2, -1.0)  # [m/s]
SPINS = Vector3(30, -20, 50), Vector3(-10, 40, 20)  # [rad/s]
TURNED = Quaternion(Vector3(1, 2, 3).normalized(), 0.7)


@pytest.fixture
def material():
    O.reset()
    result = CurvatureMat(**MATERIAL)
    O.materials.append(result)
    return result


def particle(kind, center, radius, material):
    if kind == 'sphere':
        return utils.sphere(center, radius, material=material)
    return sq.superquadric(center, (radius,) * 3, 2, 2, material, TURNED)


def start():
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0), verletDist=1e-3)
    O.dt = 0.05 * sq.criticalTimeStep()


def motionAfterContact(ids):
    """Velocities and spins of the bodies once they have touched and parted, and the number of steps in contact."""
    steps = 0
    while steps == 0 or O.interactions.countReal() > 0:
        O.step()
        steps += O.interactions.countReal() > 0
        assert O.iter < 20000, 'the bodies do not meet, or do not part'
    motion = [np.array(vector) for i in ids for vector in (O.bodies[i].state.vel, O.bodies[i].state.angVel)]
    return motion, steps


def assertSameMotion(first, second):
    (motion1, steps1), (motion2, steps2) = first, second
    assert steps1 == steps2 > 20
    for vector1, vector2 in zip(motion1, motion2):
        assert np.linalg.norm(vector1 - vector2) <= 1e-6 * np.linalg.norm(vector1)


def collidePair(kinds, radii, material):
    """The second body falls obliquely onto the first."""
    O.reset()
    O.materials.append(material)
    along = Vector3(0.3, 0.2, 1).normalized()
    bodies = [particle(kinds[0], Vector3.Zero, radii[0], material),
              particle(kinds[1], 1.01 * sum(radii) * along, radii[1], material)]
    bodies[1].state.vel = VELOCITY
    for body, spin in zip(bodies, SPINS):
        body.state.angVel = spin
    ids = O.bodies.append(bodies)
    start()
    return motionAfterContact(ids)


@pytest.mark.parametrize('kinds', [('superquadric', 'superquadric'), ('sphere', 'superquadric'), ('superquadric', 'sphere')])
@pytest.mark.parametrize('radii', [(5e-3, 5e-3), (5e-3, 3e-3), (2e-3, 8e-3)])
def test_pair(material, kinds, radii):
    spheres = collidePair(('sphere', 'sphere'), radii, material)
    assert np.linalg.norm(spheres[0][0]) > 0.01  # the first body was at rest
    assertSameMotion(spheres, collidePair(kinds, radii, material))


def collideWall(kind, material, axis, sense):
    O.reset()
    O.materials.append(material)
    radius = 4e-3
    outward = sense * Vector3.Unit(axis)
    body = particle(kind, 1.01 * radius * outward, radius, material)
    body.state.vel = Vector3(0.3, -0.2, 0.4) - 1.5 * outward
    body.state.angVel = SPINS[0]
    O.bodies.append(utils.wall(0.0, axis, sense=sense, material=material))
    ids = [O.bodies.append(body)]
    start()
    return motionAfterContact(ids)


@pytest.mark.parametrize('axis, sense', [(0, 1), (2, 1), (2, -1)])
def test_wall(material, axis, sense):
    assertSameMotion(collideWall('sphere', material, axis, sense), collideWall('superquadric', material, axis, sense))


def collideCylinder(kind, material):
    O.reset()
    O.materials.append(material)
    sq.cylinderContainer(0.03, 0.1, material)
    body = particle(kind, Vector3(0.021, 0.014, 0.05), 4e-3, material)
    body.state.vel = Vector3(1.0, 0.2, 0.3)
    body.state.angVel = SPINS[0]
    ids = [O.bodies.append(body)]
    start()
    return motionAfterContact(ids)


def test_hollowCylinder(material):
    assertSameMotion(collideCylinder('sphere', material), collideCylinder('superquadric', material))


BED_RADIUS = 0.03  # of the container [m]
SLAB = 0.010, 0.040  # heights between which the packing fraction is measured [m]
SEEDS = 6  # of each kind
STUDENT = 4.587  # two-sided 99.9 % quantile of Student's t with 2 (SEEDS - 1) degrees of freedom


def settledBed(kind, seed, number=200):
    """Packing fraction of the slab and mean coordination number of a bed poured from a loose lattice."""
    O.reset()
    generator = random.Random(seed)
    soft = CurvatureMat(**dict(MATERIAL, young=1e6))
    O.materials.append(soft)
    sq.cylinderContainer(BED_RADIUS, 1.0, soft)
    for center in latticeInCylinder(number, 0.0105):
        jitter = Vector3(*(generator.uniform(-2.5e-4, 2.5e-4) for _ in range(3)))
        body = particle(kind, center + jitter, generator.uniform(4e-3, 5e-3), soft)
        body.state.vel = sq.randomOrientation(generator) * Vector3(0, 0, 0.3)
        O.bodies.append(body)
    O.engines = sq.superquadricEngines(verletDist=1e-3)
    O.dt = 0.1 * sq.criticalTimeStep()
    O.run(math.ceil(0.5 / O.dt), wait=True)
    return packingFraction(), 2 * particleContacts() / number


def latticeInCylinder(number, spacing):
    across = math.floor(BED_RADIUS / spacing)
    layer = [Vector3(x * spacing, y * spacing, 0) for x in range(-across, across + 1) for y in range(-across, across + 1)
             if math.hypot(x, y) * spacing < BED_RADIUS - 5.3e-3]
    return [layer[i % len(layer)] + Vector3(0, 0, (0.6 + i // len(layer)) * spacing) for i in range(number)]


def particles():
    return [body for body in O.bodies if body.dynamic]


def packingFraction():
    low, high = SLAB
    solid = sum(volumeBelow(body, high) - volumeBelow(body, low) for body in particles())
    return solid / (math.pi * BED_RADIUS ** 2 * (high - low))


def volumeBelow(body, height):
    """Volume of a sphere below a horizontal plane [m3]."""
    radius = (3 * body.state.mass / body.mat.density / (4 * math.pi)) ** (1 / 3)
    depth = min(max(height - body.state.pos[2] + radius, 0), 2 * radius)
    return math.pi * depth ** 2 * (radius - depth / 3)


def particleContacts():
    return sum(1 for i in O.interactions if O.bodies[i.id1].dynamic and O.bodies[i.id2].dynamic)


@pytest.fixture(scope='module')
def beds():
    return {kind: np.array([settledBed(kind, 100 * (kind == 'sphere') + seed) for seed in range(SEEDS)])
            for kind in ('sphere', 'superquadric')}


@pytest.mark.parametrize('quantity, name, narrow', [(0, 'packing fraction', 0.03), (1, 'coordination number', 0.5)])
def test_settledBed(beds, quantity, name, narrow):
    spheres, superquadrics = beds['sphere'][:, quantity], beds['superquadric'][:, quantity]
    difference = spheres.mean() - superquadrics.mean()
    halfWidth = STUDENT * math.sqrt((spheres.var(ddof=1) + superquadrics.var(ddof=1)) / SEEDS)
    print(f'{name}: spheres {spheres.mean():.4f} +- {spheres.std(ddof=1):.4f}, superquadrics {superquadrics.mean():.4f} '
          f'+- {superquadrics.std(ddof=1):.4f}, difference {difference:.4f} +- {halfWidth:.4f}')
    assert abs(difference) < halfWidth
    assert halfWidth < narrow


def test_bedIsDense(beds):
    # A bed still in the air, or lost, would agree with another one as well.
    for kind in beds:
        assert np.all(beds[kind][:, 0] > 0.5)
        assert np.all(beds[kind][:, 1] > 4)
