"""Contacts of the shapes inside a running YADE: every kind in both orders of the bodies, parked pairs, periodic cells.

References are closed forms of spheres (a superquadric with n1 = n2 = 2 is one) and of blocks; contacts of general shapes are the
subject of the unit tests of pkg/geometry."""
import math

import pytest
from barescene import STILL, R, add, ball, block, emptyScene, engine  # noqa: F401 (emptyScene is a fixture)
from yade import O
from yade.minieigenHP import Matrix3, Quaternion, Vector3
from yade.wrapper import Facet, HollowCylinder, InteractionLoop, Sphere, Superquadric, SuperquadricGeom, Wall

DEPTH = 1e-5


def pairFunctor():
    return engine(InteractionLoop).geomDispatcher.functors[0]


def onlyGeom():
    """One step; the geometry of the only pair, with its ids."""
    O.step()
    interactions = list(O.interactions)
    assert len(interactions) == 1 and interactions[0].isReal
    assert isinstance(interactions[0].geom, SuperquadricGeom)
    return interactions[0].geom, interactions[0].id1, interactions[0].id2


def close(vector, reference, scale):
    assert (Vector3(vector) - Vector3(reference)).norm() <= 1e-9 * scale, (vector, reference)


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
    kind, direction = interaction.geom.warmStart
    assert kind == 'direction' and direction[0] == pytest.approx(1, abs=0.2)

    pairFunctor().resetCounters()
    O.run(5, True)
    counts = pairFunctor().counters()
    assert counts['solves'] == counts['rejectedByDirection'] == 5 and counts['iterations'] == 0

    remembered = interaction.geom.warmStart
    O.save(str(tmp_path / 'scene.yade.gz'))
    O.load(str(tmp_path / 'scene.yade.gz'))
    geom = O.interactions[0, 1].geom
    assert geom.warmStart == remembered and not geom.touching
    O.run(5, True)
    counts = pairFunctor().counters()
    assert counts['solves'] == counts['rejectedByDirection'] == 5


def test_contactPartsIntoAParkedPair():
    neighbours(gap=-DEPTH)
    O.step()
    assert O.interactions[0, 1].isReal and O.interactions[0, 1].geom.warmStart[0] == 'point'
    O.bodies[1].state.pos += Vector3(3 * DEPTH, 0, 0)
    O.step()
    interaction = O.interactions[0, 1]
    assert not interaction.isReal and interaction.phys is None
    assert not interaction.geom.touching and interaction.geom.penetrationDepth < 0 and interaction.geom.warmStart[0] == 'direction'
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
