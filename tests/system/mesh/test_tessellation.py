"""Particles as triangles, from Python."""
import numpy
import pytest
from yade.wrapper import Facet, Sphere, Superquadric

from yade.superquadric import tessellation


def volume(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    return numpy.einsum('ij,ij->', a, numpy.cross(b, c)) / 6


@pytest.mark.parametrize('shape', [Superquadric(extents=(1, 2, 3), n1=8, n2=4), Superquadric(extents=(2e-6, 1e-6, 1e-6), n1=20, n2=2)])
def test_arraysOfASuperquadric(shape):
    error = 1e-3 * min(shape.extents)
    mesh = tessellation(shape, error)
    assert 0 < mesh.error <= error
    assert mesh.points.shape == mesh.normals.shape and mesh.triangles.shape == (2 * len(mesh.points) - 4, 3)
    assert sorted(set(mesh.triangles.flat)) == list(range(len(mesh.points)))
    for point, normal in zip(mesh.points[::7], mesh.normals[::7]):
        assert shape.gauge(point.tolist()) == pytest.approx(1, abs=1e-14)
        assert shape.support(normal.tolist()) == pytest.approx(normal @ point, rel=1e-12)
    assert shape.volume() * 0.99 < volume(mesh) < shape.volume()


def test_aSphereIsTheSuperquadricOfExponentsTwo():
    mesh = tessellation(Sphere(radius=0.5), 1e-4)
    assert numpy.linalg.norm(mesh.points, axis=1) == pytest.approx(0.5, rel=1e-14)
    assert mesh.normals == pytest.approx(2 * mesh.points, abs=1e-14)
    # The body is within the error of the mesh: the volumes differ by less than the sphere's area times that.
    assert 0 < numpy.pi / 6 - volume(mesh) < numpy.pi * mesh.error


@pytest.mark.parametrize('error, reason', [(0, 'positive'), (-1, 'positive'), (float('nan'), 'finite'), ('fine', 'number'), (1e-12, 'larger')])
def test_refusedErrors(error, reason):
    with pytest.raises(ValueError, match=f'error .*{reason}'):
        tessellation(Superquadric(extents=(1, 1, 1), n1=4, n2=4), error)


def test_refusedShapes():
    with pytest.raises(ValueError, match='shape = .*Facet.*Superquadric or a Sphere'):
        tessellation(Facet(), 1e-3)


def test_theClassItselfRefusesTheSame():
    for error in (0, -1, float('inf'), 1e-12):
        with pytest.raises(ValueError, match='error must be'):
            Superquadric().tessellation(error)
