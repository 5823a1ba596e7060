"""Tessellations of any shape: closed, within their bound of the surface, of a volume within it too; written as STL they enclose as much."""
import math
import os

import numpy
import pytest
from fuzzing import anything, exponent, fuzz, quaternion, ratio, refused, size
from hypothesis import strategies as st
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, Sphere, Superquadric

import yade.superquadric as sq

extents = st.tuples(size, ratio, ratio).map(lambda s: (s[0], s[0] * s[1], s[0] * s[2]))
shape = st.one_of(st.builds(lambda extents, n1, n2: Superquadric(extents=extents, n1=n1, n2=n2), extents, exponent, exponent),
                  size.map(lambda radius: Sphere(radius=radius)))
relative = st.floats(-2.5, 1).map(lambda power: 10.0 ** power)  # error over the smallest half size


def volume(shape):
    return 4 / 3 * math.pi * shape.radius ** 3 if isinstance(shape, Sphere) else shape.volume()


def least(shape):
    return shape.radius if isinstance(shape, Sphere) else min(shape.extents)


def gauge(shape, x):
    return Vector3(*x).norm() / shape.radius if isinstance(shape, Sphere) else shape.gauge(Vector3(*x))


def enclosed(surface, error):
    """Volume [m3]; and at most that of what lies within the `error` [m] of a convex one, by Steiner's formula: the integral of the mean curvature is
    no more than a box's."""
    a, b, c = (surface.points[surface.triangles[:, i]] for i in range(3))
    inner, area = float(numpy.sum(a * numpy.cross(b, c)) / 6), float(numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2)
    return inner, inner + error * (area + math.pi * error * float(numpy.ptp(surface.points, axis=0).sum()) + 4 / 3 * math.pi * error ** 2)


@fuzz(weight=3, shape=shape, share=relative)
def test_tessellations(shape, share):
    """Points on the surface, a closed surface that faces outward, and a volume that is no more than the error too small."""
    error = share * least(shape)
    found = sq.tessellation(shape, error)
    assert 0 < found.error <= error * (1 + 1e-12)
    assert all(abs(gauge(shape, x) - 1) < 1e-12 for x in found.points[::1 + len(found.points) // 50].tolist())
    assert numpy.abs(numpy.linalg.norm(found.normals, axis=1) - 1).max() < 1e-12
    assert sq.TriangleMesh(found.points, found.triangles).check() == 'outward'
    inner, outer = enclosed(found, found.error)
    assert inner <= volume(shape) * (1 + 1e-12) and volume(shape) <= outer * (1 + 1e-12)


@fuzz(weight=3, shape=st.one_of(shape, anything), error=anything)
def test_tessellationsOfAnything(shape, error):
    found, no = refused(lambda: sq.tessellation(shape, error), 'shape', 'error')
    if not no:
        assert len(found.points) <= 1e6 and found.error <= float(error)


@pytest.fixture(scope='module')
def file(tmp_path_factory):
    return str(tmp_path_factory.mktemp('particles') / 'particles.stl')


@fuzz(shapes=st.lists(st.tuples(st.tuples(ratio, ratio, ratio), exponent, exponent, quaternion), max_size=3),
      scale=st.sampled_from((1e-6, 1e-3, 1, 1e6)), error=st.one_of(st.floats(0.02, 0.3), anything), ids=st.one_of(st.none(), st.none(), anything))
def test_particlesToStl(file, shapes, scale, error, ids):
    """Each particle a closed surface: their volumes, as read again, add up to the particles' to the error; nothing is written of what is refused."""
    if os.path.exists(file):
        os.remove(file)
    O.reset()
    material = CurvatureMat(young=1e8, poisson=0.2, density=2500, frictionAngle=0.4)
    for i, (extents, n1, n2, turn) in enumerate(shapes):
        O.bodies.append(sq.superquadric((50 * i * scale, 0, 0), [scale * x for x in extents], n1, n2, material, turn))
    given = list(range(len(shapes))) if ids is None else ids
    _, no = refused(lambda: sq.particlesToStl(file, given, scale * error if isinstance(error, float) else error), 'ids', 'error')
    assert os.path.exists(file) != no
    if no or ids is not None:
        return
    inner, outer = enclosed(sq.readStl(file), scale * error * (1 + 1e-3))
    whole = sum(body.shape.volume() for body in O.bodies)
    assert inner <= whole * (1 + 1e-3) and whole <= outer * (1 + 1e-3)  # single precision
