"""Superquadrics in a periodic cell: a collision across the boundary is the collision inside, also when the cell is sheared,
and a packing of cubes can be compressed and stays in balance."""
import math
import random

import numpy as np
import pytest
from yade import O, utils
from yade.minieigenHP import Matrix3, Quaternion, Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq

MATERIAL = dict(young=1e7, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                tangentialDamping=0.1, rollingFriction=0.01)
SIZE = 0.1  # of the cell [m]


def periodicScene(shear=0.0):
    O.reset()
    O.periodic = True
    O.cell.hSize = Matrix3(SIZE, shear * SIZE, 0, 0, SIZE, 0, 0, 0, SIZE)
    material = CurvatureMat(**MATERIAL)
    O.materials.append(material)
    return material


def start():
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 0.05 * sq.criticalTimeStep()


def collision(shear, cells):
    """Velocities and spins after the oblique collision of a block with a cylinder that is so many cells away, and the
    distances in cells between the bodies in contact."""
    material = periodicScene(shear)
    middle = SIZE * Vector3(0.5 + shear / 2, 0.5, 0.5)
    along = Vector3(0.5, 1.0, 0.3).normalized()
    block = sq.superquadric(middle - 9e-3 * along, (4e-3, 5e-3, 6e-3), 8, 6, material,
                            Quaternion(Vector3(1, 2, 3).normalized(), 0.7))
    image = middle + O.cell.hSize * Vector3(*cells)
    cylinder = sq.superquadric(image + 9e-3 * along, (5e-3, 5e-3, 3e-3), 8, 2, material,
                               Quaternion(Vector3(3, 1, 2).normalized(), 1.3))
    block.state.vel, cylinder.state.vel = along, Vector3(0.2, -0.1, 0.1) - along
    cylinder.state.angVel = Vector3(30, -20, 10)
    ids = O.bodies.append([block, cylinder])
    start()
    distances = set()
    while O.iter < 3000:
        O.step()
        distances.update(tuple(i.cellDist) for i in O.interactions)
    motion = [np.array(vector) for i in ids for vector in (O.bodies[i].state.vel, O.bodies[i].state.angVel)]
    return motion, distances


@pytest.mark.parametrize('shear', [0.0, 0.3])
@pytest.mark.parametrize('cells', [(1, 0, 0), (0, -1, 0), (0, 0, 1), (-3, 5, -1)])
def test_collisionAcrossTheBoundaryEqualsTheOneInside(shear, cells):
    inside, distancesInside = collision(shear, (0, 0, 0))
    across, distancesAcross = collision(shear, cells)
    assert distancesInside == {(0, 0, 0)}
    assert distancesAcross == {tuple(-c for c in cells)}
    assert np.linalg.norm(inside[0] - Vector3(0.5, 1.0, 0.3).normalized()) > 0.1  # they did collide
    for one, other in zip(inside, across):
        assert np.linalg.norm(one - other) < 1e-9 * np.linalg.norm(one)


@pytest.fixture(scope='module')
def packing():
    """64 cubes of random orientations, compressed from a loose lattice to a packing fraction of 0.6."""
    material = periodicScene()
    generator = random.Random(4)
    extents = sq.equalVolumeExtents(5e-3, 8, 8)
    for i in range(64):
        center = Vector3(i % 4 + 0.5, i // 4 % 4 + 0.5, i // 16 + 0.5) * SIZE / 4
        body = sq.superquadric(center, extents, 8, 8, material, sq.randomOrientation(generator))
        body.state.vel = sq.randomOrientation(generator) * Vector3(0, 0, 0.1)
        O.bodies.append(body)
    start()
    O.dt = 0.1 * sq.criticalTimeStep()
    solid = sum(body.state.mass for body in O.bodies) / MATERIAL['density']
    strain = math.log(SIZE ** 3 * 0.6 / solid) / 3
    rate = 5.0
    O.cell.velGrad = -rate * Matrix3.Identity
    O.run(round(strain / rate / O.dt), wait=True)
    O.cell.velGrad = Matrix3.Zero
    O.run(1, wait=True)
    return solid


def momentumParts():
    return np.array([body.state.mass * np.array(body.state.vel) for body in O.bodies])


def test_cubesAreCompressed(packing):
    assert packing / O.cell.volume == pytest.approx(0.6, rel=0.01)
    assert O.interactions.countReal() > 100
    assert any(i.cellDist != Vector3.Zero for i in O.interactions)
    assert np.all(np.isfinite(momentumParts()))
    overlaps = [i.geom.penetrationDepth for i in O.interactions]
    assert max(overlaps) < 0.1 * 2 * 4.1e-3


def test_compressedCubesPushOutwards(packing):
    pressures = -np.diag(np.array(utils.getStress()).reshape(3, 3))
    assert pressures.min() > 0
    assert pressures.max() < 2 * pressures.min()


def test_momentumOfThePackingIsConserved(packing):
    before = momentumParts()
    O.run(1000, wait=True)
    after = momentumParts()
    scale = np.linalg.norm(before, axis=1).sum()
    assert np.linalg.norm(after - before, axis=1).max() > 1e-3 * scale / len(before)  # they push each other
    assert np.linalg.norm(after.sum(axis=0) - before.sum(axis=0)) < 1e-10 * scale
