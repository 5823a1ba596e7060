"""The elastoplastic normal force in YADE: four paths, and what a collision loses.

References: Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39(8), 2018, equations (4)-(11), with the unloading of
docs/theory.md; Johnson, Contact Mechanics, sections 4.2 and 11.4-11.5: Hertz's collision, and a restitution that falls
as the speed to the power -1/4 where the mean pressure stays as it is.
"""
import math

import pytest
from elastoplasticcollision import (
    ALUMINIUM,
    KINDS,
    PARTNERS,
    RADIUS,
    Collision,
    Prescribed,
    booked,
    effectiveModulus,
    elasticDuration,
    yieldOverlap,
    yieldSpeed,
)
from yade import O

import yade.superquadric as sq
from yade.superquadric.validations.elastoplasticimpact import limitExponent, powerLaw, pressedPath, restitution, yieldPoint

EXACT = 1e-12  # relative: the same formula, other order of the operations
FINE = 4000    # steps a collision, with which the work is known to 1e-7 (the kink at yield and the turning point cost most)


def hertz(material, radius, overlap):
    return 4 / 3 * effectiveModulus(material) * math.sqrt(radius) * max(0, overlap) ** 1.5


def loadingForce(material, radius, overlap):
    """(4) and (10)."""
    dy = yieldOverlap(material, radius)
    if overlap <= dy:
        return hertz(material, radius, overlap)
    return hertz(material, radius, dy) * (1 + material.m0 * (math.sqrt(overlap / dy) - 1) ** material.exponent)


def unloadingForce(material, radius, largest, overlap):
    """Hertz with the disc of contact that loading left behind: through (10) at the largest overlap."""
    length = 3 * loadingForce(material, radius, largest) / (4 * effectiveModulus(material) * math.sqrt(radius * largest))
    return loadingForce(material, radius, largest) * (max(0, overlap - largest + length) / length) ** 1.5


def speedOf(part, partner):
    """`part` times the speed that just reaches yield [m/s]."""
    scene = Collision('Sphere', partner, (0, 0, -1))
    return part * yieldSpeed(scene.material, scene.radius, scene.mass)


@pytest.mark.parametrize('partner', PARTNERS)
@pytest.mark.parametrize('kind', KINDS)
def test_below_yield_a_collision_is_hertz(kind, partner):
    scene = Collision(kind, partner, (0, 0, -speedOf(0.99, partner)))
    forces = []
    scene.run(lambda contact: forces.append((contact.phys.normalForce[2], contact.geom.penetrationDepth)))
    assert max(abs(force / hertz(scene.material, scene.radius, overlap) - 1) for force, overlap in forces) < 1e-6
    assert scene.restitution() == pytest.approx(1, abs=1e-6)
    assert len(forces) * O.dt == pytest.approx(elasticDuration(scene.material, scene.radius, scene.mass, scene.speed), rel=3e-3)
    assert booked()['yieldDissip'] == 0


@pytest.mark.parametrize('damping, expected', ((0.05, 0.847), (0.06, 0.820), (0.1, 0.725)))
def test_a_damped_elastic_collision_has_the_restitution_of_the_other_law(damping, expected):
    scene = Collision('Sphere', 'wall', (0, 0, -1), yieldStress=math.inf, normalDamping=damping).run()
    assert scene.restitution() == pytest.approx(expected, abs=5e-4)
    assert sq.normalDampingFor(expected) == pytest.approx(damping, rel=5e-3)


@pytest.mark.parametrize('wanted', (1, 0.9, 0.5, 0.2))
def test_damping_for_a_wanted_restitution(wanted):
    damping = sq.normalDampingFor(wanted)
    scene = Collision('Sphere', 'wall', (0, 0, -0.3), yieldStress=math.inf, normalDamping=damping, steps=FINE).run()
    assert scene.restitution() == pytest.approx(wanted, abs=1e-4)


@pytest.mark.parametrize('kind', KINDS)
def test_a_prescribed_overlap_follows_the_four_paths(kind):
    scene = Prescribed(kind)
    dy = yieldOverlap(scene.material, scene.radius)
    place, largest = 0, 0
    for end in (0.9, 0.1, 10, 4, 9.9, 20, 0.5, 19):
        step = (end * dy - place) / 50
        for _ in range(50):
            phys = scene.move(by=(0, 0, -step))
            place += step
            largest = max(largest, place)
            if place == largest:
                expected = loadingForce(scene.material, scene.radius, place)
            else:
                expected = unloadingForce(scene.material, scene.radius, largest, place)
            smallest = hertz(scene.material, scene.radius, 0.1 * dy)
            assert phys.normalForce[2] == pytest.approx(expected, rel=1e-6, abs=1e-6 * smallest)  # overlaps are differences of places
        assert (phys.residualOverlap > 0) == (largest > dy)
        if phys.residualOverlap > 0:
            assert phys.largestOverlap == pytest.approx(largest, rel=1e-7)
            assert phys.curveRadius == pytest.approx(scene.radius, rel=EXACT)
    assert phys.kn == pytest.approx(1.5 * phys.normalForce[2] / (place - phys.residualOverlap), rel=1e-6)


def test_a_contact_that_has_parted_forgets_its_dent():
    scene = Prescribed()
    dy = yieldOverlap(scene.material, scene.radius)
    scene.move(by=(0, 0, -10 * dy))
    assert scene.move(by=(0, 0, 9.9 * dy)).normalForce[2] == 0  # in the dent
    O.bodies[1].state.pos += (0, 0, dy)
    O.step()
    assert O.interactions.countReal() == 0
    phys = scene.move(by=(0, 0, -1.4 * dy))
    assert phys.residualOverlap == 0
    assert phys.normalForce[2] == pytest.approx(hertz(scene.material, scene.radius, 0.5 * dy), rel=1e-6)


@pytest.mark.parametrize('partner', PARTNERS)
@pytest.mark.parametrize('kind', KINDS)
@pytest.mark.parametrize('part', (1.5, 30))
def test_a_collision_loses_the_area_of_its_loop(part, kind, partner):
    scene = Collision(kind, partner, (0, 0, -speedOf(part, partner)), steps=FINE)
    before = scene.kineticEnergy()
    path = [(0, 0)]
    scene.run(lambda contact: path.append((contact.geom.penetrationDepth, contact.phys.normalForce[2])))
    lost = before - scene.kineticEnergy()
    area = sum((end[0] - start[0]) * (start[1] + end[1]) / 2 for start, end in zip(path, path[1:]))
    assert lost > 0.3 * before
    assert booked()['yieldDissip'] == pytest.approx(lost, abs=1e-6 * before)
    assert area == pytest.approx(lost, abs=1e-6 * before)


@pytest.mark.parametrize('kind, partner, exponent', [(kind, partner, 2) for kind in KINDS for partner in PARTNERS] +
                         [('Sphere', 'wall', 1.6), ('Sphere', 'wall', 2.4)])
def test_far_above_yield_the_restitution_falls_as_johnsons_power(kind, partner, exponent):
    """With H = 2 the force beyond yield grows as the area of contact: a constant mean pressure, as Johnson supposes, hence -1/4."""
    soft = dict(yieldStress=1e6, exponent=exponent)
    scene = Collision(kind, partner, (0, 0, -1), **soft)
    slowest = 1e4 * yieldSpeed(scene.material, scene.radius, scene.mass)
    speeds = [slowest * 10 ** (i / 5) for i in range(6)]
    restitutions = [Collision(kind, partner, (0, 0, -speed), steps=300, **soft).run().restitution() for speed in speeds]
    law = powerLaw(speeds, restitutions)
    assert limitExponent(2) == -0.25
    # What is left of the limit is that of (a - ay)/ay against a/ay.
    assert law.exponent == pytest.approx(limitExponent(exponent), abs=0.007)
    assert law.halfWidth < 0.002
    if exponent == 2:
        # e^2 = 4/5 G (dy/d)^(1/2) where v^2 = G fy d^2/(m dy).
        dy, factor = yieldOverlap(scene.material, scene.radius), ALUMINIUM['m0']
        depth = speeds[-1] * math.sqrt(scene.mass * dy / (factor * hertz(scene.material, scene.radius, dy)))
        assert restitutions[-1] == pytest.approx(math.sqrt(0.8 * factor) * (dy / depth) ** 0.25, rel=0.02)


def test_the_script_of_this_law_sees_the_same():
    """elastoplasticimpact, behind scripts/elastoplastic_collision.py, against the scenes of this file."""
    properties = dict(ALUMINIUM, exponent=2)
    scene = Collision('Sphere', 'wall', (0, 0, -0.5), steps=FINE, exponent=2).run()
    point = yieldPoint(scene.material, RADIUS)
    assert point.overlap == pytest.approx(yieldOverlap(scene.material, RADIUS), rel=EXACT)
    assert point.speed == pytest.approx(yieldSpeed(scene.material, RADIUS, scene.mass), rel=1e-9)
    assert restitution(properties, RADIUS, 0.5) == pytest.approx(scene.restitution(), abs=2e-4)
    loading, unloading = pressedPath(properties, RADIUS, (5 * point.overlap, 0), points=10)
    assert loading[-1][1] == pytest.approx(loadingForce(scene.material, RADIUS, 5 * point.overlap), rel=1e-6)
    assert unloading[0] == loading[-1] and unloading[-1] == (0, 0)
    overlap, force = unloading[2]
    assert force == pytest.approx(unloadingForce(scene.material, RADIUS, 5 * point.overlap, overlap), rel=1e-6)


def test_a_harder_partner_leaves_the_yielding_to_the_softer_one():
    scene = Prescribed()
    harder = O.materials[O.materials.append(scene.material.__class__(**{**scene.material.dict(), 'id': -1, 'yieldStress': 500e6, 'm0': 1.1}))]
    force = scene.move(by=(0, 0, -1e-6)).normalForce[2]
    assert force == pytest.approx(loadingForce(scene.material, scene.radius, 1e-6), rel=1e-6)
    for body in (0, 1):
        scene = Prescribed()
        O.bodies[body].mat = harder
        assert scene.move(by=(0, 0, -1e-6)).normalForce[2] == force
