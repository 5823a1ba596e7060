"""Energy in many contacts at once: the work of gravity on falling balls is all found again in O.energy."""
import math
import random

import pytest
from yade import O, utils
from yade.wrapper import CurvatureMat

import yade.superquadric as sq

RADIUS, WIDTH = 5e-3, 0.06  # [m]


def dropBalls():
    """200 balls in a box of walls, released with gaps in a new scene."""
    O.reset()
    generator = random.Random(1)
    material = CurvatureMat(young=1e9, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                            tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(material)
    walls = [(0, axis, 1) for axis in range(3)] + [(WIDTH, axis, -1) for axis in range(2)]
    O.bodies.append([utils.wall(position, axis=axis, sense=sense, material=material) for position, axis, sense in walls])
    for i in range(200):
        column, row, layer = i % 5, i // 5 % 5, i // 25
        jitter = [generator.uniform(-5e-4, 5e-4) for _ in range(2)]
        centre = 6e-3 + 12e-3 * column + jitter[0], 6e-3 + 12e-3 * row + jitter[1], 6e-3 + 11.5e-3 * layer
        O.bodies.append(utils.sphere(centre, RADIUS, material=material))
    O.engines = sq.superquadricEngines()
    O.trackEnergy = True
    O.dt = 0.1 * sq.criticalTimeStep()


def kineticEnergy():
    states = [body.state for body in O.bodies]
    return sum(s.mass * s.vel.squaredNorm() + s.inertia[0] * s.angVel.squaredNorm() for s in states) / 2


def test_work_of_gravity_is_found_in_the_energies():
    dropBalls()
    O.run(25000, True)
    energies = dict(O.energy.items())
    work = -energies.pop('gravWork')
    energies['kinetic'] = kineticEnergy()
    contacts = [interaction.phys for interaction in O.interactions]
    assert len(contacts) > 100
    assert energies['elastPotential'] == pytest.approx(
        sum(0.4 * phys.hertzStiffness * phys.overlap ** 2.5 + phys.shearEnergy for phys in contacts), rel=1e-12)
    assert all(energies[sink] > 5e-3 * work for sink in ('plastDissip', 'normDampDissip', 'shearDampDissip', 'rollingDissip'))
    assert sum(energies.values()) == pytest.approx(work, rel=2e-3)
