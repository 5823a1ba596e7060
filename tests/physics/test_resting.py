"""A cube that is dropped on a wall or on another cube comes to rest, flat or leaning on a slope, and stays."""
import math

import pytest
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.validations.restingcube import HALF, REST, STUDY, RestingCube

STEPS = 100000


@pytest.mark.parametrize('n', (8, 20))
@pytest.mark.parametrize('young', (1e8, 1e9))
@pytest.mark.parametrize('floor', ('wall', 'cube'))
def test_a_dropped_cube_comes_to_rest_and_stays(floor, young, n):
    cube = RestingCube(floor, n, young)
    assert cube.settle(200000)
    overlap = cube.overlap()
    drift = cube.watch(STEPS)

    # What is left when it is called at rest carries it by less than a hundredth of its overlap, and dies out.
    assert drift.shift < 0.01 * overlap and drift.turn < 0.01 * overlap / HALF
    assert drift.energy < 1e-3 * REST
    counts = sq.solverCounters()
    assert counts['fallbacks'] == counts['uncertified'] == 0


@pytest.mark.parametrize('floor', ('wall', 'cube'))
def test_at_last_it_does_not_move_at_all(floor):
    cube = RestingCube(floor, young=1e8)
    O.run(200000, wait=True)
    drift = cube.watch(STEPS)

    # The rest speed is below what changes the last digit of a coordinate in one step.
    assert drift.shift == 0
    assert drift.turn < 1e-15
    assert drift.energy < 1e-20


def test_a_tower_comes_to_rest_and_does_not_move_at_all():
    """Four cubes, shifted and tilted against each other a little."""
    O.reset()
    stuff = CurvatureMat(young=1e8, **STUDY)
    O.bodies.append(utils.wall(0, axis=2, material=stuff))
    for i in range(4):
        place = 0.1 * HALF * Vector3(math.cos(2.3 * i), math.sin(2.3 * i), 0) + HALF * Vector3(0, 0, 2.003 * i + 1.003)
        tilt = Quaternion(Vector3(math.cos(i), math.sin(i), 0), 2e-3)
        O.bodies.append(sq.superquadric(place, (HALF,) * 3, 8, 8, material=stuff, orientation=tilt))
    O.engines = sq.superquadricEngines()
    O.dt = 0.1 * sq.criticalTimeStep()

    O.run(STEPS, wait=True)
    places = [Vector3(body.state.pos) for body in O.bodies]
    O.run(STEPS, wait=True)
    assert [body.state.pos for body in O.bodies] == places
    # Each stands on the one below, lower by the overlaps.
    assert [place[2] / HALF for place in places[1:]] == pytest.approx([1, 3, 5, 7], abs=5e-3)


def test_it_stays_on_a_slope_below_the_angle_of_friction():
    slope = 0.3  # the friction: 0.4
    cube = RestingCube('wall', young=1e8, slope=slope)
    assert cube.settle(200000)
    contact, overlap = O.interactions[0, 1], cube.overlap()
    drift = cube.watch(STEPS)

    assert drift.shift < overlap
    assert drift.energy < REST
    # The force goes through the centre along gravity: friction carries its part, from a point that far down the slope.
    assert contact.phys.shearForce.norm() / contact.phys.normalForce.norm() == pytest.approx(slope, rel=1e-3)
    assert (contact.geom.contactPoint - cube.cube.state.pos)[0] == pytest.approx(slope * HALF, rel=1e-2)


def test_without_rolling_friction_it_goes_on_spinning():
    """A single point has no lever against a turn about the normal: only the rolling couple (13) takes that out."""
    cube = RestingCube('wall', young=1e8, rollingFriction=0)
    O.run(100000, wait=True)
    before = cube.cube.state.angVel[2]
    O.run(STEPS, wait=True)

    assert abs(before) > 1e-3
    assert cube.cube.state.angVel[2] == pytest.approx(before, rel=1e-3)


def test_it_slides_down_a_slope_above_the_angle_of_friction():
    cube = RestingCube('wall', young=1e8, slope=0.5)

    assert cube.settle(20000) is None
    assert cube.cube.state.vel[0] > 0
