"""Surfaces of any triangles: judged as their edges and a hull's closed form say, written and read again, or refused by name."""
import math
import os

import numpy
import pytest
from fuzzing import anything, finite, fuzz, number, quaternion, refused, size, vector
from hypothesis import assume
from hypothesis import strategies as st
from scipy.spatial import ConvexHull
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, Facet

import yade.superquadric as sq

LARGEST_SINGLE = float(numpy.finfo('f4').max)
grid = st.tuples(*[st.integers(-1, 1)] * 3)
soup = st.tuples(st.lists(grid, min_size=3, max_size=7), st.lists(st.tuples(*[st.integers(0, 6)] * 3), max_size=9))
cloud = st.lists(st.tuples(*[st.floats(-1, 1)] * 3), min_size=4, max_size=14)
MADE_OF = 'points', 'triangles', 'name'


@pytest.fixture(scope='module', autouse=True)
def elsewhere(tmp_path_factory):
    """Files of any name go into a folder of their own."""
    before = os.getcwd()
    os.chdir(tmp_path_factory.mktemp('meshes'))
    yield
    os.chdir(before)


def edges(triangles):
    """{directed edge: how many triangles go along it}"""
    found = {}
    for triangle in numpy.asarray(triangles).tolist():
        for i in range(3):
            edge = triangle[i], triangle[(i + 1) % 3]
            found[edge] = found.get(edge, 0) + 1
    return found


def volume(surface):
    """By the divergence theorem [m3]."""
    a, b, c = (surface.points[surface.triangles[:, i]] for i in range(3))
    return float(numpy.sum(a * numpy.cross(b, c)) / 6)


def hull(points):
    """The convex hull as a `TriangleMesh` that faces outward, and its volume by another program; the example is dropped if it is nearly flat."""
    table = numpy.array(points)
    assume(len(table) > 3 and numpy.linalg.svd(table - table.mean(axis=0))[1][-1] > 1e-2)
    found = ConvexHull(table)
    triangles = found.simplices.copy()
    corners = table[triangles]
    across = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assume(numpy.linalg.norm(across, axis=1).min() > 1e-6)
    inward = numpy.einsum('ij,ij->i', across, found.equations[:, :3]) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return sq.TriangleMesh(table, triangles, 'hull'), found.volume


@fuzz(weight=4, points=st.one_of(st.lists(vector, max_size=4), anything), triangles=st.one_of(st.lists(vector, max_size=3), anything),
      name=st.one_of(st.just('mine'), anything), closed=st.one_of(st.booleans(), anything))
def test_surfacesOfAnything(points, triangles, name, closed):
    surface, no = refused(lambda: sq.TriangleMesh(points, triangles, name), *MADE_OF)
    if not no:
        assert surface.points.shape[1] == surface.triangles.shape[1] == 3
        refused(lambda: surface.check(closed), surface.name, 'triangles', 'closed')


@fuzz(weight=4, what=soup, closed=st.booleans())
def test_soupsAreJudgedByTheirEdges(what, closed):
    """A surface that is accepted has each edge once, and once the other way where it is closed; then the sign of its volume is the way it faces."""
    surface, no = refused(lambda: sq.TriangleMesh(*what, 'soup'), *MADE_OF)
    facing, no = (surface, no) if no else refused(lambda: surface.check(closed), 'soup', 'triangles')
    if no:
        return
    used = edges(surface.triangles)
    isClosed = all(edge[::-1] in used for edge in used)
    assert set(used.values()) <= {1} and (isClosed or not closed)
    assert used and facing == (('outward' if volume(surface) > 0 else 'inward') if isClosed else 'open')


@fuzz(weight=2, points=cloud, scale=st.one_of(size, st.floats(-100, 100).map(lambda power: 10.0 ** power)), inward=st.booleans(),
      missing=st.integers(0, 3))
def test_hulls(points, scale, inward, missing):
    """Of any size: outward, inward, or open where a triangle is missing; the volume is that of the program that made the hull."""
    outward, expected = hull(points)
    triangles = outward.triangles[:, ::-1] if inward else outward.triangles
    surface = sq.TriangleMesh(scale * outward.points, triangles, 'hull')
    assert surface.check() == ('inward' if inward else 'outward')
    if 1e-30 < expected * scale ** 3 < 1e30:
        assert math.isclose(sq.regions.Mesh(surface).volume, expected * scale ** 3, rel_tol=1e-9)
    opened = sq.TriangleMesh(surface.points, numpy.delete(triangles, missing, axis=0), 'hull')
    assert opened.check(closed=False) == 'open'
    assert refused(opened.check, 'hull: 3 edges with one triangle only')[1]


@fuzz(weight=3, points=st.lists(st.tuples(number, number, number), min_size=3, max_size=5),
      triangles=st.lists(st.tuples(*[st.integers(-1, 6)] * 3), min_size=1, max_size=5), path=st.sampled_from(('a.stl', '7', 'ü b', 'no/folder')))
def test_whatIsWrittenIsRead(points, triangles, path):
    """To single precision; what that cannot hold is refused and no file is written."""
    if os.path.exists(path):
        os.remove(path)
    surface = sq.TriangleMesh(points, triangles)
    _, no = refused(lambda: sq.writeStl(path, surface), 'points', 'triangles', also=FileNotFoundError)
    good = 0 <= surface.triangles.min() and surface.triangles.max() < len(points)
    if good:
        size = numpy.abs(surface.points[surface.triangles])
        good = not numpy.any((LARGEST_SINGLE < size) & (size < math.inf))
    assert no == (not good or path == 'no/folder')
    assert not os.path.exists(f'{path}.part') and os.path.exists(path) != no
    if not no:
        read, written = sq.readStl(path), surface.points[surface.triangles].astype('f4')
        found, whole = read.points[read.triangles], numpy.isfinite(written).all(axis=2)
        assert numpy.array_equal(found[whole], written[whole]) and numpy.array_equal(numpy.isfinite(found).all(axis=2), whole)


@fuzz(weight=2, path=anything, surface=st.one_of(st.just(sq.TriangleMesh(numpy.eye(3), [[0, 1, 2]])), anything))
def test_writingAnythingAnywhere(path, surface):
    """Nothing half written is left behind; a missing folder is the system's own error."""
    if isinstance(path, str) and ('/' in path or '..' in path):
        path = path.replace('/', '').replace('..', '')
    before = sorted(os.listdir())
    _, no = refused(lambda: sq.writeStl(path, surface), 'path', 'surface', also=OSError)
    if no:
        assert sorted(os.listdir()) == before
    else:
        assert len(sq.readStl(path).triangles) == 1
        os.remove(path)


@fuzz(weight=2, points=cloud, scale=st.one_of(size, anything), position=vector, turn=st.one_of(quaternion, anything))
def test_placing(points, scale, position, turn):
    surface, _ = hull(points)
    sq.writeStl('placed.stl', surface)
    read, no = refused(lambda: sq.readStl('placed.stl', scale, position, turn), 'scale', 'position', 'orientation')
    if no:
        return
    plain = sq.readStl('placed.stl')
    expected = [float(scale) * (turn * Vector3(*x)) + Vector3(*map(float, position)) for x in plain.points.tolist()]
    assert numpy.abs(read.points - expected).max() <= 1e-13 * max(5e-324, float(numpy.abs(expected).max()), float(scale))
    assert numpy.array_equal(read.triangles, plain.triangles)


@fuzz(weight=2, points=cloud, missing=st.booleans(), closed=st.one_of(st.booleans(), anything), scale=st.one_of(st.just(1e-3), finite, anything),
      material=st.one_of(st.none(), anything))
def test_containers(points, missing, closed, scale, material):
    """Of an accepted one every triangle is a facet; a refused one leaves the scene as it was."""
    surface, _ = hull(points)
    sq.writeStl('container.stl', sq.TriangleMesh(surface.points, surface.triangles[missing:]))
    O.reset()
    O.materials.append(CurvatureMat(young=1e8, poisson=0.2, density=2500, frictionAngle=0.4))
    given = O.materials[0] if material is None else material
    ids, no = refused(lambda: sq.stlContainer('container.stl', given, closed, scale), 'container.stl', 'closed', 'scale', 'material',
                      also=(IndexError, KeyError, OverflowError, RuntimeError))  # YADE's own, of the material
    if no:
        assert len(O.bodies) == 0
    else:
        assert len(ids) == len(O.bodies) == len(surface.triangles) - missing and all(isinstance(O.bodies[i].shape, Facet) for i in ids)
