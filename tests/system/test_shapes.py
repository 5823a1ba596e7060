"""The shapes and their contact geometry inside a running YADE: validation, save and load, bounding boxes, every kind of contact in
both orders of the bodies, parked pairs, periodic cells.

References are closed forms of spheres (a superquadric with n1 = n2 = 2 is one) and of blocks; contacts of general shapes are the
subject of the unit tests of pkg/geometry."""
import itertools
import math

import pytest
from yade import O, Body
from yade.minieigenHP import Matrix3, Quaternion, Vector3
from yade.wrapper import (
    Bo1_Facet_Aabb, Bo1_HollowCylinder_Aabb, Bo1_Sphere_Aabb, Bo1_Superquadric_Aabb, Bo1_Wall_Aabb, CurvatureMat, Facet, ForceResetter,
    HollowCylinder, Ig2_Facet_Superquadric_SuperquadricGeom, Ig2_HollowCylinder_Sphere_SuperquadricGeom,
    Ig2_HollowCylinder_Superquadric_SuperquadricGeom, Ig2_Sphere_Superquadric_SuperquadricGeom, Ig2_Superquadric_Superquadric_SuperquadricGeom,
    Ig2_Wall_Superquadric_SuperquadricGeom, InsertionSortCollider, InteractionLoop, Ip2_CurvatureMat_CurvatureMat_CurvaturePhys,
    Law2_ScGeom_CurvaturePhys_HertzMindlin, NewtonIntegrator, Sphere, Superquadric, SuperquadricGeom, Wall)

NAN, INF = float('nan'), float('inf')
R = 5e-3
DEPTH = 1e-5
STILL = 1e-9  # a time step in which nothing moves


@pytest.fixture(autouse=True)
def emptyScene():
    O.reset()
    O.materials.append(CurvatureMat(young=1e9, poisson=0.2, density=2500, frictionAngle=0.4))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider(
            [Bo1_Superquadric_Aabb(), Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Facet_Aabb(), Bo1_HollowCylinder_Aabb()],
            verletDist=0.1 * R, label='collider'),
        InteractionLoop(
            [Ig2_Superquadric_Superquadric_SuperquadricGeom(label='pairs'), Ig2_Sphere_Superquadric_SuperquadricGeom(),
             Ig2_Wall_Superquadric_SuperquadricGeom(), Ig2_Facet_Superquadric_SuperquadricGeom(),
             Ig2_HollowCylinder_Superquadric_SuperquadricGeom(), Ig2_HollowCylinder_Sphere_SuperquadricGeom()],
            [Ip2_CurvatureMat_CurvatureMat_CurvaturePhys()], [Law2_ScGeom_CurvaturePhys_HertzMindlin()]),
        NewtonIntegrator(damping=0, gravity=(0, 0, 0)),
    ]
    O.dt = STILL


def engine(kind):
    return next(e for e in O.engines if isinstance(e, kind))


def pairFunctor():
    return engine(InteractionLoop).geomDispatcher.functors[0]


def add(shape, position=(0, 0, 0), orientation=Quaternion.Identity, dynamic=True):
    """Append a body with the mass of a 1 g unit and return its id."""
    body = Body()
    body.shape = shape
    body.material = O.materials[0]
    body.state.pos, body.state.ori = position, orientation
    body.state.mass, body.state.inertia = 1e-3, Vector3(1e-8, 1e-8, 1e-8)
    body.aspherical = True
    if not dynamic:
        body.state.blockedDOFs = 'xyzXYZ'
    return O.bodies.append(body)


def ball(radius=R):
    return Superquadric(extents=(radius,) * 3, n1=2, n2=2)


def block(*extents):
    return Superquadric(extents=extents, n1=8, n2=8)


def onlyGeom():
    """One step; the geometry of the only pair, with its ids."""
    O.step()
    interactions = list(O.interactions)
    assert len(interactions) == 1 and interactions[0].isReal
    assert isinstance(interactions[0].geom, SuperquadricGeom)
    return interactions[0].geom, interactions[0].id1, interactions[0].id2


def close(vector, reference, scale):
    assert (Vector3(vector) - Vector3(reference)).norm() <= 1e-9 * scale, (vector, reference)


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
    assert list(shape.inertia(density)) == pytest.approx([mass / 5 * (b * b + c * c), mass / 5 * (a * a + c * c), mass / 5 * (a * a + b * b)], rel=1e-12)
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


# --- contacts, by the contract: normal from body 1 to body 2, depth, the point midway


def checkRound(geom, reversedOrder, normal, point, wall):
    """A ball of radius R (body 2 in the functor's order) with a wall or another ball of radius R."""
    assert geom.touching
    assert geom.penetrationDepth == pytest.approx(DEPTH, rel=1e-9)
    close(geom.normal, -Vector3(normal) if reversedOrder else normal, 1)
    close(geom.contactPoint, point, R)
    first = (0, 0, 0) if wall else (1 / R, R, R)
    sides = [(geom.curvature1, geom.sectionRadius1, geom.smallestHalfSize1), (geom.curvature2, geom.sectionRadius2, geom.smallestHalfSize2)]
    for side, expected in zip(sides, [first, (1 / R, R, R)]):
        assert list(side) == pytest.approx(expected, rel=1e-7)
    assert (geom.refR1, geom.refR2) == pytest.approx((R, R), rel=1e-12)


@pytest.mark.parametrize('order', [0, 1])
def test_superquadricAndSuperquadric(order):
    bodies = [(0, 0, 0), (0, 0, 2 * R - DEPTH)]
    for position in bodies[::-1] if order else bodies:
        add(ball(), position, Quaternion((1, 2, 3), 1.0))
    geom, id1, id2 = onlyGeom()
    checkRound(geom, O.bodies[id1].state.pos[2] > 0, (0, 0, 1), (0, 0, R - DEPTH / 2), wall=False)


# The wall-like or round partner of a ball, with the ball's place, the normal towards the ball and the contact point.
TRIANGLE = [(-1, -1, 0), (1, -1, 0), (0, 2, 0)]
PARTNERS = {
    'sphere': (lambda: Sphere(radius=R), (0, 0, 0), (0, 0, 2 * R - DEPTH), (0, 0, 1), (0, 0, R - DEPTH / 2)),
    'wall': (lambda: Wall(axis=1), (7, 8, 9), (0, 8 - R + DEPTH, 0), (0, -1, 0), (0, 8 + DEPTH / 2, 0)),
    'wallOneSided': (lambda: Wall(axis=2, sense=1), (0, 0, 1), (0, 0, 1 + R - DEPTH), (0, 0, 1), (0, 0, 1 - DEPTH / 2)),
    'facet': (lambda: Facet(vertices=TRIANGLE), (0, 0, 1), (0, 0, 1 - R + DEPTH), (0, 0, -1), (0, 0, 1 + DEPTH / 2)),
    'cylinder': (lambda: HollowCylinder(radius=4 * R, height=8 * R), (1, 0, 0), (1, -3 * R - DEPTH, R), (0, 1, 0), (1, -4 * R - DEPTH / 2, R)),
}


@pytest.mark.parametrize('partner', PARTNERS)
@pytest.mark.parametrize('order', [0, 1])
def test_superquadricAndOthers(partner, order):
    make, position, place, normal, point = PARTNERS[partner]
    bodies = [lambda: add(make(), position, dynamic=False), lambda: add(ball(), place)]
    for insert in bodies[::-1] if order else bodies:
        insert()
    geom, id1, id2 = onlyGeom()
    assert isinstance(O.bodies[id2].shape, Superquadric)
    checkRound(geom, False, normal, point, wall=partner != 'sphere')


@pytest.mark.parametrize('order', [0, 1])
def test_cylinderAndSphere(order):
    bodies = [lambda: add(HollowCylinder(radius=4 * R, height=8 * R), dynamic=False), lambda: add(Sphere(radius=R), (0, 3 * R + DEPTH, R))]
    for insert in bodies[::-1] if order else bodies:
        insert()
    geom, id1, id2 = onlyGeom()
    assert isinstance(O.bodies[id2].shape, Sphere)
    checkRound(geom, False, (0, -1, 0), (0, 4 * R + DEPTH / 2, R), wall=True)


@pytest.mark.parametrize('make', [ball, lambda: Sphere(radius=R)])
@pytest.mark.parametrize('place', [(3 * R + DEPTH, 0, 4.001 * R), (3.5 * R, 3.5 * R, 0), (5 * R - DEPTH, 0, 0)])
def test_cylinderHoldsOnlyInsideAndBetweenItsEnds(make, place):
    """Beyond an end; in a corner of the bounding box; on the outer side."""
    add(HollowCylinder(radius=4 * R, height=8 * R), dynamic=False)
    add(make(), place)
    O.step()
    assert O.interactions.countReal() == 0


@pytest.mark.parametrize('place, touching', [((0, 0, R - DEPTH), True), ((0, 0, -R + DEPTH), False)])
def test_oneSidedWall(place, touching):
    add(Wall(axis=2, sense=1), dynamic=False)
    add(ball(), place)
    O.step()
    assert O.interactions.countReal() == touching


def test_flatFaces():
    """Two blocks face to face: the depth is the distance the faces went in, the section radius that of the face's size."""
    add(block(R, 2 * R, R), (0, 0, 0))
    add(block(R, 2 * R, 3 * R), (0, 0, 4 * R - DEPTH))
    geom, id1, id2 = onlyGeom()
    assert geom.penetrationDepth == pytest.approx(DEPTH, rel=1e-6)
    assert (geom.smallestHalfSize1, geom.smallestHalfSize2) == (R, R)
    assert (geom.sectionRadius1, geom.sectionRadius2) == pytest.approx((math.sqrt(2) * R, math.sqrt(2) * R), rel=1e-6)
    assert geom.curvature1 < 0.01 / R and geom.curvature2 < 0.01 / R


# --- pairs that do not touch


def neighbours(gap=0.1 * R):
    """Two blocks whose bounding spheres overlap, which are the given gap apart."""
    add(block(R, R, R))
    add(block(R, R, R), (2 * R + gap, 0, 0))


def test_parkedPair(tmp_path):
    neighbours()
    O.step()
    assert O.interactions.countReal() == 0 and list(O.interactions) == []
    interaction = O.interactions[0, 1]
    assert not interaction.isReal and interaction.phys is None and not interaction.geom.touching
    assert interaction.geom.warmKind == 2
    assert interaction.geom.warmValue[0] == pytest.approx(1, abs=0.2)

    pairFunctor().resetCounters()
    O.run(5, True)
    counts = pairFunctor().counters()
    assert counts['solves'] == counts['rejectedByDirection'] == 5 and counts['iterations'] == 0

    warm = Vector3(interaction.geom.warmValue)
    O.save(str(tmp_path / 'scene.yade.gz'))
    O.load(str(tmp_path / 'scene.yade.gz'))
    geom = O.interactions[0, 1].geom
    assert (geom.warmKind, geom.warmValue, geom.touching) == (2, warm, False)
    O.run(5, True)
    counts = pairFunctor().counters()
    assert counts['solves'] == counts['rejectedByDirection'] == 5


def test_contactPartsIntoAParkedPair():
    neighbours(gap=-DEPTH)
    O.step()
    assert O.interactions[0, 1].isReal and O.interactions[0, 1].geom.warmKind == 1
    O.bodies[1].state.pos += Vector3(3 * DEPTH, 0, 0)
    O.step()
    interaction = O.interactions[0, 1]
    assert not interaction.isReal and interaction.phys is None
    assert not interaction.geom.touching and interaction.geom.penetrationDepth < 0 and interaction.geom.warmKind == 2
    for i in (0, 1):
        assert O.forces.f(i) == Vector3(0, 0, 0)
    O.bodies[1].state.pos -= Vector3(3 * DEPTH, 0, 0)
    O.step()
    interaction = O.interactions[0, 1]
    assert interaction.isReal and interaction.geom.touching and interaction.iterMadeReal == O.iter - 1
    assert O.forces.f(1)[0] > 0


@pytest.mark.parametrize('partner', PARTNERS)
def test_otherContactsPart(partner):
    make, position, place, normal, _ = PARTNERS[partner]
    add(make(), position, dynamic=False)
    add(ball(), place)
    O.step()
    assert O.interactions.countReal() == 1
    O.bodies[1].state.pos += 3 * DEPTH * Vector3(normal)
    O.step()
    assert O.interactions.countReal() == 0 and O.forces.f(1) == Vector3(0, 0, 0)
    O.bodies[1].state.pos -= 3 * DEPTH * Vector3(normal)
    O.step()
    assert O.interactions.countReal() == 1 and O.forces.f(1).dot(Vector3(normal)) > 0


def test_userMayForceAnInteraction():
    from yade.utils import createInteraction
    neighbours()
    O.step()
    createInteraction(0, 1)
    assert O.interactions[0, 1].isReal and not O.interactions[0, 1].geom.touching
    O.step()
    assert not O.interactions[0, 1].isReal


def test_countersAreSummedAndReset():
    neighbours(gap=-DEPTH)
    O.run(3, True)
    counts = pairFunctor().counters()
    assert counts['solves'] == 3 and counts['coldStarts'] == 1 and counts['uncertified'] == 0
    pairFunctor().resetCounters()
    assert not any(pairFunctor().counters().values())


# --- periodic cells


@pytest.mark.parametrize('shear', [0, 0.3])
def test_periodicContactEqualsTheFreeOne(shear):
    """A pair of turned blocks in space, and the same pair whose second block enters from the cell's other side."""
    def pairAt(first, second):
        add(block(R, R, 2 * R), first, Quaternion((1, 2, 3), 0.5))
        add(block(R, 2 * R, R), second, Quaternion((3, 1, 2), 1.1))
        for body, spin in zip(O.bodies, (2, -1)):
            body.state.vel, body.state.angVel = spin * Vector3(0.1, 0.2, 0.3), spin * Vector3(3, 2, 1)

    def measured():
        geom, id1, id2 = onlyGeom()
        assert (id1, id2) == (0, 1)
        numbers = [geom.penetrationDepth, geom.curvature1, geom.curvature2, geom.sectionRadius1, geom.sectionRadius2]
        vectors = [geom.normal, geom.contactPoint - O.bodies[0].state.pos, geom.shearInc]
        return numbers, vectors + [Vector3(x(i)) for x in (O.forces.f, O.forces.t) for i in (0, 1)]

    engines, material = O.engines, O.materials[0]
    size = 0.05
    first, apart = Vector3(0.4 * R, 0.3 * R, 0.2 * R), Vector3(-1.8 * R, -0.6 * R, -0.8 * R)
    pairAt(first, first + apart)
    numbers, vectors = measured()
    assert numbers[0] > 0 and min(v.norm() for v in vectors) > 0

    O.reset()
    O.materials.append(material)
    O.engines = engines
    O.dt = STILL
    O.periodic = True
    O.cell.hSize = Matrix3(size, shear * size, 0, 0, size, 0, 0, 0, size)
    pairAt(first, first + apart + O.cell.hSize * Vector3(1, 1, 1))
    periodicNumbers, periodicVectors = measured()
    assert any(O.interactions[0, 1].cellDist)
    assert periodicNumbers == pytest.approx(numbers, rel=1e-8)
    for periodic, free in zip(periodicVectors, vectors):
        close(periodic / free.norm(), free / free.norm(), 10)
