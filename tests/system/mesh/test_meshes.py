"""STL files as containers of facets: what is refused, which way they push, and particles that rain into a hopper and stay there."""
import math
import random

import numpy as np
import pytest
from stlfiles import cube, revolved
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat, Facet

import yade.superquadric as sq


def newScene():
    O.reset()
    material = CurvatureMat(young=1e6, poisson=0.3, density=2500, frictionAngle=0.4, normalDamping=0.2, tangentialDamping=0.2, rollingFriction=0.005)
    O.materials.append(material)
    return material


def stl(tmp_path, surface):
    path = tmp_path / 'container.stl'
    sq.writeStl(path, surface)
    return path


def lidless(surface):
    """Without the triangles that face upwards."""
    corners = surface.points[surface.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return sq.TriangleMesh(surface.points, surface.triangles[normals[:, 2] <= 0], 'lidless')


def test_whatIsWrittenIsRead(tmp_path):
    read = sq.readStl(stl(tmp_path, cube(0.5)))
    assert len(read.points) == 8 and read.check() == 'outward'
    assert np.array_equal(read.points[read.triangles], cube(0.5).points[cube(0.5).triangles])


def test_placing(tmp_path):
    turn = Quaternion(Vector3(0, 0, 1), math.pi / 2)
    read = sq.readStl(stl(tmp_path, cube(2.0)), scale=1e-3, position=(1, 2, 3), orientation=turn)
    assert read.points.min(axis=0) == pytest.approx([0.998, 2, 3], abs=1e-12)
    assert read.points.max(axis=0) == pytest.approx([1, 2.002, 3.002], abs=1e-12)


def test_facetsAreTheTriangles(tmp_path):
    ids = sq.stlContainer(stl(tmp_path, cube()), newScene(), scale=0.1)
    assert len(ids) == 12 and all(isinstance(O.bodies[i].shape, Facet) for i in ids)
    assert sum(O.bodies[i].shape.area for i in ids) == pytest.approx(6 * 0.1 ** 2)


@pytest.mark.parametrize('damage, complaint', (
    (lambda s: sq.TriangleMesh(s.points, s.triangles[1:]), '3 edges with one triangle only'),
    (lambda s: sq.TriangleMesh(s.points, np.vstack([s.triangles, s.triangles[:1]])), '3 edges shared by more than two triangles'),
    (lambda s: sq.TriangleMesh(s.points, np.vstack([s.triangles[:1, ::-1], s.triangles[1:]])), '3 edges whose two triangles face opposite ways'),
    (lambda s: sq.TriangleMesh(s.points, np.vstack([s.triangles, [[0, 0, 1]]])), '1 triangles without an area'),
    (lambda s: sq.TriangleMesh(np.vstack([s.points, s.points + 0.3]), np.vstack([s.triangles, s.triangles + 8])),
     'pairs of triangles that go through each other'),
    (lambda s: sq.TriangleMesh(np.where(s.points == 1, np.nan, s.points), s.triangles), 'coordinates that are not finite')))
def test_defectsAreRefusedBeforeAnythingIsAdded(tmp_path, damage, complaint):
    path, material = stl(tmp_path, damage(cube())), newScene()
    with pytest.raises(ValueError, match=f'^{path}: .*{complaint}.*first at'):
        sq.stlContainer(path, material)
    assert len(O.bodies) == 0


def test_badInput(tmp_path):
    material, path = newScene(), stl(tmp_path, cube())
    with pytest.raises(ValueError, match='scale = 0'):
        sq.stlContainer(path, material, scale=0)
    with pytest.raises(ValueError, match='nothing.stl: cannot be read'):
        sq.stlContainer(tmp_path / 'nothing.stl', material)
    with pytest.raises(ValueError, match='cut short'):
        path.write_bytes(path.read_bytes()[:-60])
        sq.stlContainer(path, material)
    with pytest.raises(ValueError, match='triangles must be indices of points'):
        sq.TriangleMesh(np.zeros((3, 3)), [[0, 1, 3]]).check()
    with pytest.raises(ValueError, match='points: must be rows of three numbers'):
        sq.TriangleMesh(np.zeros(3), [[0, 1, 2]])
    assert len(O.bodies) == 0


def test_openContainersOnRequest(tmp_path):
    path, material = stl(tmp_path, lidless(cube())), newScene()
    with pytest.raises(ValueError, match='4 edges with one triangle only'):
        sq.stlContainer(path, material)
    assert len(sq.stlContainer(path, material, closed=False)) == 10


@pytest.mark.parametrize('inward', [False, True])
@pytest.mark.parametrize('axis, side', [(2, -1), (2, 1), (0, 1), (1, -1)])
def test_facesPushBackInside(tmp_path, inward, axis, side):
    """A cube pressed onto a face from within is pushed straight back with the force of a wall, whichever way the file's triangles face."""
    size, half, depth = 0.125, 0.01, 1e-5  # a size that single precision holds
    surface = cube(size)
    path, material = stl(tmp_path, sq.TriangleMesh(surface.points, surface.triangles[:, ::-1] if inward else surface.triangles)), newScene()
    sq.stlContainer(path, material)
    place = Vector3(0.041, 0.047, 0.043)
    place[axis] = size / 2 + side * (size / 2 - half + depth)
    body = O.bodies.append(sq.superquadric(place, (half,) * 3, 8, 8, material=material))
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 1e-9
    O.step()
    force, expected = O.forces.f(body), pushOfAWall(half, depth)
    assert -side * force[axis] == pytest.approx(expected, rel=1e-6)
    assert force.norm() == pytest.approx(expected, rel=1e-6)


def pushOfAWall(half, depth):
    material = newScene()
    O.bodies.append(utils.wall(0, axis=2, material=material))
    body = O.bodies.append(sq.superquadric((0, 0, half - depth), (half,) * 3, 8, 8, material=material))
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 1e-9
    O.step()
    return O.forces.f(body)[2]


def test_particlesStayInTheHopper(tmp_path):
    """Cubes, ellipsoids and spheres fall through a funnel and its neck into the mould below, and come to rest: one open mesh, not convex."""
    material = newScene()
    profile = [(0, -0.14), (0.03, -0.14), (0.05, -0.11), (0.05, -0.09), (0.035, -0.075), (0.06, -0.03), (0.06, 0.2)]
    bin = revolved(profile, 12)
    closed = sq.regions.Mesh(revolved(profile + [(0, 0.2)], 12))
    ids = sq.stlContainer(stl(tmp_path, bin), material, closed=False)
    assert len(ids) == 12 * (1 + 2 * 5)
    shapes = [sq.particleShape(name, 7e-3, aspect) for name, aspect in (('cube', 1), ('ellipsoid', 1.5), ('sphere', 1))] * 14
    rain = sq.Container(None, (), None, 0.07, 0.07, 0.5)
    particles, _ = sq.rainFilling(shapes, rain, material, seed=1)
    O.engines = sq.superquadricEngines(gravity=(0, 0, -9.81))
    O.dt = sq.checkTimeStep(0.1 * sq.criticalTimeStep())
    kinetic = []
    while O.time < 1.2:
        O.run(1000, wait=True)
        kinetic.append(sum(O.bodies[i].state.mass * O.bodies[i].state.vel.squaredNorm() / 2 for i in particles))
    snapshot = sq.Snapshot.ofBodies(particles)
    assert kinetic[-1] < 1e-4 * max(kinetic)
    assert closed.contains(snapshot.positions).all()
    assert np.sum(snapshot.positions[:, 2] < -0.09) >= 8  # in the mould, below the neck
    whole, inside = sum(shape.volume for shape in shapes), sq.solidVolume(particles, closed)
    assert whole * 0.998 < inside.value <= inside.high <= whole * (1 + 1e-12)  # but for what is pressed into the walls


@pytest.mark.parametrize('triangles', ([[0.9, 1, 2]], [[0, 1, float('nan')]], [[0, 1, 2 ** 40]], np.array([[0, 1, 2 ** 32]])))
def test_placesOfPointsAreWholeNumbers(triangles):
    with pytest.raises(ValueError, match='triangles: must be rows of three'):
        sq.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles)


def test_particlesToStl(tmp_path):
    material = newScene()
    rng = random.Random(4)
    shapes = [sq.particleShape('cube', 5e-3), sq.particleShape('sphere', 5e-3), sq.particleShape('cylinder', 5e-3, 2.0)]
    ids = [O.bodies.append(shape.body(Vector3(0.03 * i, 0, 0), sq.randomOrientation(rng), material)) for i, shape in enumerate(shapes)]
    path, error = tmp_path / 'particles.stl', 2e-5
    sq.particlesToStl(path, ids, error)
    read = sq.readStl(path)
    assert read.check() == 'outward'
    volume, whole = sq.regions.Mesh(read).volume, sum(shape.volume for shape in shapes)
    areas = sum(np.linalg.norm(np.cross(b - a, c - a)) / 2 for a, b, c in read.points[read.triangles])
    assert whole - 1.01 * error * areas < volume < whole
    with pytest.raises(ValueError, match='no particle among them'):
        sq.particlesToStl(path, [], error)
