"""Solid in parts of space: bounds that hold the closed form, parts that add up to the whole, the same from another description of the region."""
import math

import numpy
from fuzzing import anything, coordinate, direction, exponent, fuzz, quaternion, ratio, refused, size, vector
from hypothesis import strategies as st
from yade import O
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat, Superquadric

import yade.superquadric as sq
from yade.superquadric.mesh.regions import BOX_TRIANGLES, Box, Cylinder, HalfSpaces, Mesh
from yade.superquadric.scene.shapes import unitVolume

ROUNDING = 1e-9  # of the volumes at hand
solid = st.tuples(ratio, ratio, ratio, exponent, exponent, quaternion, st.tuples(coordinate, coordinate, coordinate))
corner = st.tuples(*[st.floats(0.05, 2)] * 3)


def bed(solids, scale, away=(0, 0, 0)):
    """Snapshot of the solids, `scale` times as large, a third of their size."""
    rotations = [numpy.array(turn.toRotationMatrix()).reshape(3, 3) for *_, turn, _ in solids]
    return sq.Snapshot(ids=numpy.arange(len(solids)), rotations=numpy.array(rotations).reshape(-1, 3, 3),
                       positions=numpy.array([scale * numpy.array(place) + away for *_, place in solids]).reshape(-1, 3),
                       extents=numpy.array([numpy.array(one[:3]) * scale / 3 for one in solids]).reshape(-1, 3),
                       exponents=numpy.array([one[3:5] for one in solids]).reshape(-1, 2))


def volumes(snapshot):
    """Of the whole particles [m3]."""
    return [math.prod(extents) * unitVolume(*exponents) for extents, exponents in zip(snapshot.extents, snapshot.exponents)]


def ordered(measured, whole):
    """The measured one, whose bounds are in order and no more than there is."""
    assert 0 <= measured.low <= measured.value <= measured.high <= whole * (1 + ROUNDING)
    return measured


def touches(snapshot, box):
    """Whether a particle touches a plane of the box from within or without, to rounding: then it counts as cut, or as whole."""
    for place, turn, extents, exponents in zip(snapshot.positions, snapshot.rotations, snapshot.extents, snapshot.exponents):
        shape = Superquadric(extents=extents.tolist(), n1=exponents[0], n2=exponents[1])
        for axis in range(3):
            reach = shape.support(Vector3(*turn[axis].tolist()))
            if any(abs(abs(plane[axis] - place[axis]) - reach) < 1e-9 * reach for plane in (box.low, box.high)):
                return True
    return False


def boxMesh(box):
    return Mesh(sq.TriangleMesh([[(box.low, box.high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)], BOX_TRIANGLES, 'box'))


@fuzz(weight=3, solids=st.lists(solid, min_size=1, max_size=3), scale=size, low=corner, high=corner, axis=st.integers(0, 2),
      share=st.floats(0.01, 0.99), accuracy=st.sampled_from((0.02, 0.1, 1)))
def test_partsAddUpToTheWhole(solids, scale, low, high, axis, share, accuracy):
    """A box cut in two by a plane; and the box as a mesh, and as half spaces of a larger box, holds as much."""
    snapshot, box = bed(solids, scale), Box([-scale * x for x in low], [scale * x for x in high])
    whole, at = sum(volumes(snapshot)), box.low[axis] + share * (box.high[axis] - box.low[axis])
    left, right = (Box(box.low, [at if i == axis else x for i, x in enumerate(box.high)]),
                   Box([at if i == axis else x for i, x in enumerate(box.low)], box.high))
    measured, *parts = [ordered(sq.solidVolume(snapshot, region, accuracy), whole) for region in (box, left, right)]
    assert sum(part.low for part in parts) <= measured.high + ROUNDING * whole
    assert sum(part.high for part in parts) >= measured.low - ROUNDING * whole
    assert math.isclose(left.volume + right.volume, box.volume, rel_tol=1e-12)
    larger = Box(numpy.array(box.low) - scale, numpy.array(box.high) + scale)
    planes = [(sign * numpy.eye(3)[i] * 3, sign * (box.low, box.high)[sign > 0][i]) for i in range(3) for sign in (-1, 1)]
    for alike in (boxMesh(box), HalfSpaces(planes, larger), HalfSpaces(planes, boxMesh(larger))):
        again = ordered(sq.solidVolume(snapshot, alike, accuracy), whole)
        assert math.isclose(alike.volume, box.volume, rel_tol=1e-9)
        assert abs(again.value - measured.value) <= ROUNDING * whole
        assert touches(snapshot, box) or all(abs(a - b) <= ROUNDING * whole for a, b in zip(again, measured))
    fraction = sq.packingFraction(snapshot, box, accuracy)
    assert all(math.isclose(a * box.volume, b, rel_tol=1e-12) for a, b in zip(fraction, measured))


@fuzz(weight=3, radii=st.tuples(ratio, ratio, ratio), scale=size, turn=quaternion, towards=direction, depth=st.floats(-1.1, 1.1),
      accuracy=st.sampled_from((0.02, 0.1, 1)))
def test_capsOfEllipsoids(radii, scale, turn, towards, depth, accuracy):
    """pi h^2 (3 - h)/3 of a unit sphere's cap of height h, stretched."""
    snapshot = bed([(*radii, 2.0, 2.0, turn, (0, 0, 0))], scale)
    n = numpy.array(towards) / numpy.linalg.norm(towards)
    reach = numpy.linalg.norm(snapshot.extents[0] * (snapshot.rotations[0].T @ n))
    cap = HalfSpaces([(towards, depth * reach)], Box([-100 * scale] * 3, [100 * scale] * 3))
    height = min(max(1 + depth, 0), 2)
    expected, whole = math.prod(snapshot.extents[0]) * math.pi * height ** 2 * (3 - height) / 3, volumes(snapshot)[0]
    _, low, high = ordered(sq.solidVolume(snapshot, cap, accuracy), whole)
    assert low - ROUNDING * whole <= expected <= high + ROUNDING * whole


@fuzz(weight=2, scale=size, inner=st.floats(0.01, 1.5), axis=direction, accuracy=st.sampled_from((0.02, 0.1, 1)))
def test_cylindersThroughSpheres(scale, inner, axis, accuracy):
    """What a cylinder on its axis takes from a sphere: 4/3 pi (R^3 - (R^2 - r^2)^(3/2))."""
    snapshot = bed([(1, 1, 1, 2.0, 2.0, Quaternion.Identity, (0, 0, 0))], 3 * scale)
    along = scale * 3 * numpy.array(axis) / numpy.linalg.norm(axis)
    whole, r = volumes(snapshot)[0], min(inner, 1)
    _, low, high = ordered(sq.solidVolume(snapshot, Cylinder(inner * scale, -along, along), accuracy), whole)
    expected = whole * (1 - (1 - r * r) ** 1.5)
    assert low - ROUNDING * whole <= expected <= high + ROUNDING * whole


HUGE = st.one_of(st.sampled_from((0.0, 1e30, -1e30, 1e-30, 1e9, -1e9, 1e16)), st.floats(-30, 30).map(lambda power: 10.0 ** power))


@fuzz(weight=3, solids=st.lists(solid, min_size=1, max_size=2), power=st.floats(-28, 28), away=st.tuples(HUGE, HUGE, HUGE),
      half=st.tuples(HUGE, HUGE, HUGE), kind=st.integers(0, 3))
def test_extremes(solids, power, away, half, kind):
    """Sizes and places from 1e-30 to 1e30 m: bounds in order, and no more than there is."""
    snapshot = bed(solids, 10 ** power, away)
    low, high = [-abs(x) for x in half], [abs(x) + (x == 0) for x in half]
    box, no = refused(lambda: Box(low, high), 'high')
    if no:
        return
    make = (lambda: box, lambda: Cylinder(high[0], low, high), lambda: HalfSpaces([(away, 1)], box), lambda: boxMesh(box))[kind]
    region, no = refused(make, 'top', 'planes', 'box')
    if not no:
        ordered(sq.solidVolume(snapshot, region, 0.3), sum(volumes(snapshot)))
        refused(lambda: sq.packingFraction(snapshot, region, 0.3), 'region')


def scene():
    O.reset()
    material = CurvatureMat(young=1e8, poisson=0.2, density=2500, frictionAngle=0.4)
    for x in range(3):
        O.bodies.append(sq.superquadric((0.3 * x, 0, 0), (0.1, 0.1, 0.2), 2 + x, 8, material))
    O.bodies.erase(1)


REGION = st.one_of(st.builds(Box, st.just((-1, -1, -1)), st.just((0.1, 1, 1))),
                   st.builds(Cylinder, st.just(0.2), st.just((0, 0, -1)), st.just((0, 0, 1))))


@fuzz(weight=3, ids=st.one_of(st.just([0, 2]), st.lists(st.integers(-2, 4), max_size=3), anything), region=st.one_of(REGION, REGION, anything),
      accuracy=st.one_of(st.just(0.1), anything))
def test_measuresOfAnything(ids, region, accuracy):
    scene()
    measured, no = refused(lambda: sq.solidVolume(ids, region, accuracy), 'ids', 'region', 'accuracy', 'particles')
    fraction, alsoNo = refused(lambda: sq.packingFraction(ids, region, accuracy), 'ids', 'region', 'accuracy', 'particles')
    assert no == alsoNo
    if not no:
        ordered(measured, sum(volumes(sq.Snapshot.ofBodies(ids))))
        assert math.isclose(fraction.value * region.volume, measured.value)


@fuzz(weight=4, low=st.one_of(st.just((-1, -1, -1)), vector), high=st.one_of(st.just((1, 1, 1)), vector), radius=anything,
      planes=st.one_of(st.lists(st.tuples(vector, anything), max_size=3), st.lists(anything, max_size=2), anything), within=anything)
def test_regionsOfAnything(low, high, radius, planes, within):
    box, no = refused(lambda: Box(low, high), 'low', 'high')
    if not no:
        assert math.isclose(box.volume, numpy.prod(numpy.subtract(box.high, box.low)), rel_tol=1e-12)
    cylinder, no = refused(lambda: Cylinder(radius, low, high), 'radius', 'base', 'top')
    if not no:
        assert math.isclose(cylinder.volume, math.pi * float(radius) ** 2 * math.dist(low, high), rel_tol=1e-12)
    cut, no = refused(lambda: HalfSpaces(planes, Box((-1, -1, -1), (1, 1, 1))), 'planes')
    if not no:
        assert 0 <= cut.volume <= 8 * (1 + 1e-12)
        assert all(math.isclose(math.hypot(*normal), 1, rel_tol=1e-12) for normal, _ in cut.planes)
    refused(lambda: HalfSpaces([], within), 'within')
    refused(lambda: Mesh(within), 'surface')
    refused(lambda: Mesh.ofStl(within), 'cannot be read', 'STL', 'path')


@fuzz(weight=2, high=corner, points=st.one_of(st.lists(st.tuples(*[st.floats(-3, 3)] * 3), max_size=5), anything))
def test_pointsInMeshes(high, points):
    """As those in the box that the mesh is; points on its surface count as inside."""
    mesh = boxMesh(Box((0, 0, 0), high))
    inside, no = refused(lambda: mesh.contains(points), 'points')
    if not no:
        rows = numpy.array(points, dtype=float).reshape(-1, 3)
        assert inside.tolist() == [all(0 <= x <= h for x, h in zip(row, high)) for row in rows]
