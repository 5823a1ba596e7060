"""The shapes inside a running YADE: validation, save and load, bounding boxes."""
import itertools
import math

import pytest
from barescene import R, add, block, emptyScene, engine  # noqa: F401 (emptyScene is a fixture)
from yade import O
from yade.minieigenHP import Matrix3, Quaternion, Vector3
from yade.wrapper import HollowCylinder, InsertionSortCollider, Superquadric

NAN, INF = float('nan'), float('inf')


# --- attributes


@pytest.mark.parametrize('name, value', [('extents', (1, 0, 1)), ('extents', (1, NAN, 1)), ('n1', 1.99), ('n1', 20.01), ('n2', NAN), ('n2', INF)])
def test_refusedValuesLeaveTheShapeAsItWas(name, value):
    shape = Superquadric(extents=(1, 2, 3), n1=4, n2=6)
    volume = shape.volume()
    bad = value[1] if name == 'extents' else value
    with pytest.raises(ValueError, match=f'{name}.*{bad}'):
        setattr(shape, name, value)
    with pytest.raises(ValueError, match=name):
        shape.updateAttrs({name: value})
    with pytest.raises(ValueError, match=name):
        Superquadric(**{name: value})
    assert (shape.extents, shape.n1, shape.n2, shape.volume()) == (Vector3(1, 2, 3), 4, 6, volume)


@pytest.mark.parametrize('name, value', [('radius', 0), ('radius', -1), ('radius', INF), ('height', 0), ('height', NAN)])
def test_refusedValuesLeaveTheCylinderAsItWas(name, value):
    cylinder = HollowCylinder(radius=2, height=3)
    with pytest.raises(ValueError, match=f'{name}.*{value}'):
        setattr(cylinder, name, value)
    with pytest.raises(ValueError, match=name):
        HollowCylinder(**{name: value})
    assert (cylinder.radius, cylinder.height) == (2, 3)
    assert HollowCylinder(radius=1, height=INF).height == INF


def test_readingExtentsGivesACopy():
    shape = block(1, 2, 3)
    shape.extents[0] = -1
    assert shape.extents == Vector3(1, 2, 3)


def test_badArgumentsOfMethods():
    shape = block(1, 2, 3)
    for method, bad in ((shape.supportPoint, (0, 0, 0)), (shape.meanCurvature, (0, 0, 0)), (shape.gauge, (NAN, 0, 0)),
                        (shape.inertia, -1), (shape.boxHalfExtents, Quaternion(0, 0, 0, 0))):
        with pytest.raises(ValueError, match='must be'):
            method(bad)


def test_methodsOnAnEllipsoid():
    a, b, c, density = 1., 2., 3., 2500.
    shape = Superquadric(extents=(a, b, c), n1=2, n2=2)
    mass = density * 4 / 3 * math.pi * a * b * c
    assert shape.volume() * density == pytest.approx(mass, rel=1e-12)
    assert shape.getVolume() == shape.volume() and HollowCylinder().getVolume() == 0
    assert list(shape.inertia(density)) == pytest.approx(
        [mass / 5 * (b * b + c * c), mass / 5 * (a * a + c * c), mass / 5 * (a * a + b * b)], rel=1e-12)
    assert shape.function((0, 0, 2 * c)) == pytest.approx(4, rel=1e-12)
    assert shape.gauge((0, 2 * b, 0)) == pytest.approx(2, rel=1e-12)
    assert shape.support((1, 1, 0)) == pytest.approx(math.hypot(a, b), rel=1e-12)
    assert shape.gauge(shape.supportPoint((1, 1, 0))) == pytest.approx(1, rel=1e-12)
    assert shape.meanCurvature((0, 0, 1)) == pytest.approx((c / a**2 + c / b**2) / 2, rel=1e-12)
    assert shape.boundingRadius() == pytest.approx(c, rel=1e-12)
    assert list(shape.boxHalfExtents(Quaternion((0, 0, 1), math.pi / 2))) == pytest.approx([b, a, c], rel=1e-12)


def test_shapesAreSavedAndLoaded(tmp_path):
    add(Superquadric(extents=(1, 2, 3), n1=3.3, n2=7, color=(1, 0, 0), wire=True))
    add(HollowCylinder(radius=4, height=INF))
    volume = O.bodies[0].shape.volume()
    O.save(str(tmp_path / 'scene.yade.gz'))
    O.reset()
    O.load(str(tmp_path / 'scene.yade.gz'))
    shape, cylinder = O.bodies[0].shape, O.bodies[1].shape
    assert (shape.extents, shape.n1, shape.n2, shape.color, shape.wire) == (Vector3(1, 2, 3), 3.3, 7, Vector3(1, 0, 0), True)
    assert shape.volume() == volume
    assert (cylinder.radius, cylinder.height) == (4, INF)


# --- bounding boxes


def test_boxHoldsABodySpinningInPlace():
    """The collider runs again after translations only, so one box must last however the body turns."""
    shape = block(R, 0.5 * R, 2 * R)
    body = O.bodies[add(shape)]
    steps, turns = 100, 1.5
    O.dt = 1e-4
    body.state.angVel = body.state.angMom = Vector3(0, 0, 0)
    axis = Vector3(1, 2, 3).normalized()
    body.aspherical = False
    body.state.angVel = turns * 2 * math.pi / (steps * O.dt) * axis
    O.step()
    runs = engine(InsertionSortCollider).numAction
    start, sticksOut, turned = shape.boxHalfExtents(body.state.ori), 0, 0
    for _ in range(steps):
        before = body.state.ori
        O.step()
        turned += (before.conjugate() * body.state.ori).toAxisAngle()[1]
        half = shape.boxHalfExtents(body.state.ori)
        sticksOut = max(sticksOut, max(half[i] - start[i] for i in range(3)))
        for i in range(3):
            assert body.bound.min[i] <= body.state.pos[i] - half[i] and body.state.pos[i] + half[i] <= body.bound.max[i]
    assert turned > 2 * math.pi and engine(InsertionSortCollider).numAction == runs
    # Otherwise the test could not fail: the box of the first orientation, with the collider's margin, does not last.
    assert sticksOut > 1.1 * engine(InsertionSortCollider).verletDist


def test_spinningBladeHitsItsNeighbour():
    """Two blades side by side that touch only once one of them has turned, without any translation before."""
    add(block(0.2 * R, 0.2 * R, 2 * R), (0, 0, 0))
    add(block(0.2 * R, 0.2 * R, 0.2 * R), (1.9 * R, 0, 0))
    O.bodies[0].aspherical = False
    O.bodies[0].state.angVel = Vector3(0, 1000, 0)
    O.dt = 1e-6
    O.run(int(math.pi / 2 / 1000 / O.dt), True)
    assert O.bodies[1].state.vel.norm() > 0


def test_boxInAShearedCell():
    O.periodic = True
    O.cell.hSize = Matrix3(0.1, 0.05, 0.02, 0, 0.1, -0.03, 0, 0, 0.1)
    body = O.bodies[add(block(R, R, 2 * R), (0.05, 0.06, 0.04), Quaternion((1, 1, 0), 0.7))]
    O.step()
    radius = body.shape.boundingRadius()
    corners = [O.cell.unshearPt(body.state.pos + radius * Vector3(*d).normalized()) for d in itertools.product((-2, -1, 0, 1, 2), repeat=3) if any(d)]
    for i in range(3):
        assert body.bound.min[i] <= min(c[i] for c in corners) and max(c[i] for c in corners) <= body.bound.max[i]
        # As tight as it can be, up to the collider's margin.
        row = Vector3(*(O.cell.unshearPt(Vector3.Unit(j))[i] for j in range(3))).norm()
        assert body.bound.max[i] - body.bound.min[i] == pytest.approx(2 * (radius * row + engine(InsertionSortCollider).verletDist), rel=1e-12)


def test_boxOfTheCylinder():
    tilted = O.bodies[add(HollowCylinder(radius=2, height=6), (1, 2, 3), Quaternion((1, 0, 0), math.pi / 6), dynamic=False)]
    endless = O.bodies[add(HollowCylinder(radius=2, height=INF), dynamic=False)]
    engine(InsertionSortCollider).verletDist = 0
    O.step()
    half = (2, 2 * math.cos(math.pi / 6) + 3 * math.sin(math.pi / 6), 2 * math.sin(math.pi / 6) + 3 * math.cos(math.pi / 6))
    assert list(tilted.bound.max - tilted.state.pos) == pytest.approx(half, rel=1e-12)
    assert list(tilted.state.pos - tilted.bound.min) == pytest.approx(half, rel=1e-12)
    assert list(endless.bound.max) == [2, 2, INF] and list(endless.bound.min) == [-2, -2, -INF]
