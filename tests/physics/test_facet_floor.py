"""A cube flat on a floor of triangles: without their borders it is the floor that a wall is."""
import pytest
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, Ig2_Facet_Superquadric_SuperquadricGeom, InteractionLoop

import yade.superquadric as sq
from yade.superquadric.engines import engine

HALF, DEPTH, CELL = 5e-3, 1e-5, 4e-3  # half size of the cube, its overlap, edge of the mesh [m]


def floorOfTriangles(material):
    x, y = Vector3(CELL, 0, 0), Vector3(0, CELL, 0)
    for i in range(-4, 4):
        for k in range(-4, 4):
            corner = i * x + k * y
            for triangle in ((corner, corner + x, corner + y), (corner + x + y, corner + y, corner + x)):
                O.bodies.append(utils.facet(triangle, material=material))


def floorOfOneWall(material):
    O.bodies.append(utils.wall(0, axis=2, material=material))


def cubeOn(floor, borders):
    """Id of a cube that overlaps the floor; nothing has moved yet."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4, normalDamping=0.1)
    floor(material)
    cube = O.bodies.append(sq.superquadric((0.3 * CELL, 0.2 * CELL, HALF - DEPTH), (HALF,) * 3, 8, 8, material=material))
    O.engines = sq.superquadricEngines()
    O.dt = sq.checkTimeStep(0.1 * sq.criticalTimeStep())
    for functor in engine(InteractionLoop).geomDispatcher.functors:
        if isinstance(functor, Ig2_Facet_Superquadric_SuperquadricGeom):
            functor.borders = borders
    return cube


def pushOn(cube):
    O.step()
    return O.forces.f(cube)[2], O.forces.t(cube).norm()


def test_withoutBordersTheMeshPushesLikeTheWall():
    onWall, _ = pushOn(cubeOn(floorOfOneWall, True))
    onMesh, torque = pushOn(cubeOn(floorOfTriangles, False))
    assert onMesh == pytest.approx(onWall, rel=1e-9)
    assert torque < 1e-9 * onMesh * HALF


def test_withBordersEveryTrianglePushes():
    onWall, _ = pushOn(cubeOn(floorOfOneWall, True))
    onMesh, _ = pushOn(cubeOn(floorOfTriangles, True))
    assert onMesh > 3 * onWall  # the documented limit of facets that know nothing of each other


def test_cubeComesToRestOnTheMesh():
    cube = cubeOn(floorOfTriangles, False)
    O.run(20000, wait=True)
    state = O.bodies[cube].state
    assert state.vel.norm() < 1e-9 and state.angVel.norm() < 1e-6
    assert abs(state.pos[0] - 0.3 * CELL) < 1e-9
