"""Floors of triangles: they push like the wall that they stand for, however they are cut."""
import pytest
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat, Ig2_Facet_Superquadric_SuperquadricGeom, InteractionLoop

import yade.superquadric as sq
from yade.superquadric.scene.engines import engine

HALF, DEPTH, SIDE = 5e-3, 1e-5, 32e-3  # half size of the cube, its overlap, edge of the floor [m]


def floorOfTriangles(cells):
    """A floor of 2 cells^2 facets."""
    def build(material):
        cell = SIDE / cells
        x, y = Vector3(cell, 0, 0), Vector3(0, cell, 0)
        for i in range(cells):
            for k in range(cells):
                corner = Vector3(-SIDE / 2, -SIDE / 2, 0) + i * x + k * y
                for triangle in ((corner, corner + x, corner + y), (corner + x + y, corner + y, corner + x)):
                    O.bodies.append(utils.facet(triangle, material=material))
    return build


def floorOfOneWall(material):
    O.bodies.append(utils.wall(0, axis=2, material=material))


def cubeOn(floor, place=(1.2e-3, 0.8e-3), friction=0.4):
    """Id of a cube that overlaps the floor; nothing has moved yet."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=friction, normalDamping=0.1)
    floor(material)
    cube = O.bodies.append(sq.superquadric((*place, HALF - DEPTH), (HALF,) * 3, 8, 8, material=material))
    O.engines = sq.superquadricEngines()
    O.dt = sq.checkTimeStep(0.1 * sq.criticalTimeStep())
    return cube


def pushOn(cube):
    O.step()
    return O.forces.f(cube)[2], O.forces.t(cube).norm()


@pytest.mark.parametrize('cells', [1, 4, 8])  # 2, 32 and 128 triangles
@pytest.mark.parametrize('place', [(1.2e-3, 0.8e-3), (0, 0), (4e-3, 0), (2e-3, 2e-3)])  # inside, on vertices, on an edge
def test_meshPushesLikeTheWall(cells, place):
    onWall, _ = pushOn(cubeOn(floorOfOneWall, place))
    onMesh, torque = pushOn(cubeOn(floorOfTriangles(cells), place))
    assert onMesh == pytest.approx(onWall, rel=1e-9)
    assert torque < 1e-9 * onMesh * HALF


def test_cubeComesToRestOnTheMesh():
    cube = cubeOn(floorOfTriangles(8))
    O.run(20000, wait=True)
    state = O.bodies[cube].state
    assert state.vel.norm() < 1e-9 and state.angVel.norm() < 1e-6
    assert abs(state.pos[0] - 1.2e-3) < 1e-9


def heightsOfASlidingCube(floor):
    """Heights [m] of a frictionless cube that rocks a little while it slides over the floor."""
    cube = cubeOn(floor, friction=0)
    state = O.bodies[cube].state
    state.ori = Quaternion(Vector3(1, 2, 0), 1e-3)
    state.vel = Vector3(0.3, 0.11, 0)
    heights = []
    for _ in range(60):
        O.run(16, wait=True)
        heights.append(state.pos[2])
    assert 9e-3 < state.pos[0] < 14e-3  # it crossed seams and is still far from the rim
    return heights


def test_slidingOverSeamsIsLikeSlidingOnTheWall():
    onWall, onMesh = heightsOfASlidingCube(floorOfOneWall), heightsOfASlidingCube(floorOfTriangles(8))
    assert onMesh == pytest.approx(onWall, abs=1e-4 * DEPTH)


def test_solverCountsAndNeighboursCanBeAskedFor():
    cubeOn(floorOfTriangles(4))
    functor = next(f for f in engine(InteractionLoop).geomDispatcher.functors if isinstance(f, Ig2_Facet_Superquadric_SuperquadricGeom))
    O.step()
    counts = functor.counters()
    assert counts['solves'] > 0 and counts['uncertified'] == 0 and counts['fallbacks'] == 0
    functor.findNeighbours()
    functor.resetCounters()
    assert not any(functor.counters().values())
