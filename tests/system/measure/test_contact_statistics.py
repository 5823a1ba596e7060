"""Contact numbers and forces (contactstatistics): of given numbers, and of spheres pressed together in a row."""
import numpy as np
import pytest
from yade import O, utils
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.measure import contactstatistics
from yade.superquadric.measure.contactstatistics import Contacts

GIVEN = Contacts(np.array([0, 1, 2, 2, 4]), np.array([0.0, 1.0, 2.0, 2.0, 5.0]))


def test_distributionOfNumbers():
    numbers, shares = contactstatistics.numberDistribution(GIVEN)
    assert list(numbers) == [0, 1, 2, 3, 4] and shares == pytest.approx([0.2, 0.2, 0.4, 0, 0.2])
    numbers, shares = contactstatistics.numberDistribution(contactstatistics.withoutRattlers(GIVEN))
    assert shares == pytest.approx([0, 0, 2 / 3, 0, 1 / 3])


def test_densityOfForcesIntegratesToTheShareWithinTheEdges():
    edges = np.array([0, 0.5, 1, 1.5, 2])
    density = contactstatistics.forceDistribution(GIVEN, edges)  # the mean is 2: 0, 0.5, 1, 1, 2.5
    assert density == pytest.approx(np.array([1, 1, 2, 0]) / 5 / 0.5)
    assert np.sum(density * np.diff(edges)) == pytest.approx(0.8)


def test_nothingIsNotDividedBy():
    nothing = Contacts(np.zeros(0, dtype=int), np.zeros(0))
    idle = Contacts(np.zeros(3, dtype=int), np.zeros(3))
    assert list(contactstatistics.forceDistribution(nothing, np.arange(3))) == [0, 0]
    assert list(contactstatistics.forceDistribution(idle, np.arange(3))) == [0, 0]
    assert len(contactstatistics.numberDistribution(nothing)[1]) == 0
    assert contactstatistics.describe(nothing)['rattlerShare'] == 0
    assert contactstatistics.describe(idle)['rattlerShare'] == 1


def test_describe():
    described = contactstatistics.describe(GIVEN)
    assert described['rattlerShare'] == pytest.approx(0.4) and described['meanNumber'] == pytest.approx(1.8)
    assert described['meanNumberWithoutRattlers'] == pytest.approx(8 / 3) and described['meanForceWithoutRattlers'] == pytest.approx(3)


def test_rowOfSpheresOnAWall():
    """A wall, two spheres that overlap with it and each other, one that is near and does not touch, one that lies apart."""
    O.reset()
    material = CurvatureMat(young=1e9, poisson=0.2, density=2500, frictionAngle=0.4)
    O.materials.append(material)
    O.bodies.append(utils.wall(0, 2, sense=1, material=material))
    ids = O.bodies.append([utils.sphere((x, 0, z), 0.01, material=material)
                           for x, z in ((0, 0.00999), (0, 0.02996), (0, 0.04997), (0.1, 0.05))])
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 1e-9
    O.step()
    contacts = contactstatistics.ofBodies(ids)
    forces = [i.phys.normalForce.norm() for i in sorted(O.interactions.all(onlyReal=True), key=lambda i: (i.id1, i.id2))]
    assert len(forces) == 2 and min(forces) > 0
    assert list(contacts.numbers) == [2, 1, 0, 0]
    assert contacts.forces == pytest.approx([sum(forces) / 2, forces[1], 0, 0], rel=1e-12)
