"""The finite elements: the radial return, Hertz with plasticity off, a contact that yields. They need getfem (tools/packages/fem)."""
import numpy
import pytest

from yade.superquadric.plasticity import cases, hertz, mesh
from yade.superquadric.plasticity.returnmapping import Material

YOUNG, POISSON, YIELD = 7e10, 0.33, 3e8
METAL = {'young': YOUNG, 'poisson': POISSON, 'yieldStress': YIELD, 'stressStrain': [[0.0, YIELD], [0.01, 1.2 * YIELD], [0.5, 2 * YIELD]]}
COARSE = cases.QUICK._replace(fineness=0.4, steps=12)
HERTZ = 0.02   # the accuracy that the identification asks for


def uniaxial(material, strain):
    """Stress rows of a bar drawn to the axial plastic plus elastic `strain`, its other stresses zero (Newton over the lateral strain)."""
    lateral, state = -POISSON * strain, material.virgin(1)
    for _ in range(50):
        stress, tangent, _ = material.respond(numpy.array([[lateral, strain, lateral, 0.0]]), state)
        lateral -= stress[0, 0] / (tangent[0, 0, 0] + tangent[0, 0, 2])
    return stress[0]


def test_rings_of_two_bodies_match_and_lie_on_their_surfaces():
    elementSizes = mesh.elementSizes(2e-5, 4e-4, 0.5)
    surfaces = mesh.surfaceRadii(elementSizes, [9e-3, 4e-3])
    inner, outer = surfaces[4e-3], surfaces[9e-3]
    assert inner[-1] == 4e-3 and outer[-1] == 9e-3 and numpy.array_equal(inner, outer[:len(inner)])
    assert numpy.all(numpy.diff(outer) > 0)
    fine = outer < elementSizes.fineRadius
    assert numpy.diff(outer[fine]) == pytest.approx(elementSizes.ratio * outer[fine][:-1])
    for radius, surface in ((5e-3, inner), (10e-3, outer), (numpy.inf, outer)):
        r, z = mesh.nodes(radius, surface, elementSizes.sectors)
        assert r.shape == (len(surface), elementSizes.sectors + 1)
        assert r[:, 0] == pytest.approx(0, abs=1e-18) and numpy.all(z >= -1e-18)
        assert r[:, -1] == pytest.approx(surface, rel=1e-12)
        if numpy.isfinite(radius):
            assert numpy.hypot(r[:, -1], radius - z[:, -1]) == pytest.approx(numpy.full(len(surface), radius), rel=1e-12)


@pytest.mark.parametrize('plastic, stress', [(0.004, 1.08 * YIELD), (0.01, 1.2 * YIELD), (0.255, 1.6 * YIELD), (0.9, 2 * YIELD)])
def test_bar_follows_the_stress_strain_curve(plastic, stress):
    material = Material(YOUNG, POISSON, METAL['stressStrain'])
    found = uniaxial(material, plastic + stress / YOUNG)
    assert found[1] == pytest.approx(stress, rel=1e-9)
    assert abs(found[[0, 2, 3]]).max() < 1e-6 * stress


def test_tangent_is_the_derivative_of_the_stress():
    rng = numpy.random.default_rng(3)
    material = Material(YOUNG, POISSON, METAL['stressStrain'])
    _, _, state = material.respond(0.01 * rng.standard_normal((200, 4)), material.virgin(200))
    strain = 0.03 * rng.standard_normal((200, 4))
    _, tangent, after = material.respond(strain, state)
    assert (after.hardening > state.hardening).sum() > 150
    assert numpy.all(after.hardening >= state.hardening)
    for k in range(4):
        step = numpy.zeros(4)
        step[k] = 1e-8
        difference = (material.respond(strain + step, state)[0] - material.respond(strain - step, state)[0]) / 2e-8
        assert numpy.abs(difference - tangent[:, :, k]).max() < 1e-5 * YOUNG


def test_unloading_is_elastic():
    material = Material(YOUNG, POISSON, METAL['stressStrain'])
    stress, _, state = material.respond(numpy.array([[0.0, 0.01, 0.0, 0.004]]), material.virgin(1))
    back = numpy.array([[0.0, 0.0095, 0.0, 0.004]])
    unloaded, tangent, same = material.respond(back, state)
    assert numpy.array_equal(same.hardening, state.hardening)
    assert unloaded - stress == pytest.approx((back - [[0.0, 0.01, 0.0, 0.004]]) @ material.elasticity, abs=1e-6)
    assert numpy.array_equal(tangent[0], material.elasticity)


@pytest.mark.parametrize('name', ['5-5', '5-plate'])
def test_hertz_with_plasticity_off(name):
    """Force over overlap, and half-width, within 2 % of Hertz, from below yield to the largest load of an identification."""
    case = cases.Case(name, METAL, COARSE, plastic=False)
    curve = cases.runElastic(case)
    force, halfWidth = hertz.errors(curve)
    assert len(curve.force) >= 6 and curve.overlap[-1] > 0.02 * curve.radius
    assert numpy.abs(force).max() < HERTZ
    assert numpy.abs(halfWidth).max() < HERTZ
    assert max(body.state.hardening.max() for body in case.contact.bodies) == 0


def test_contact_that_yields():
    """Hertz below yield, softer and with a larger disc beyond; the mean pressure grows towards 3 times the flow stress, but not over it."""
    case = cases.Case('5-5', METAL, COARSE._replace(largest=0.1))
    loads = [case.contact.press(approach) for approach in case.approaches(14)]
    curve = case.curve(loads)
    force, _ = hertz.errors(curve)
    before = curve.overlap < 0.9 * curve.yieldPoint.overlap
    assert before.sum() >= 2 and numpy.abs(force[before]).max() < 0.01
    assert -0.5 < force[-1] < -0.2
    pressure = curve.force[-1] / (numpy.pi * curve.halfWidth[-1]**2)
    assert 2 * YIELD < pressure < 3 * 1.3 * YIELD
    top = case.contact.load()
    down = case.contact.press(top.approach - 0.1 * (top.approach - case.yieldPoint.overlap))
    assert down.force < 0.95 * top.force
    again = case.contact.press(top.approach)
    assert again.force == pytest.approx(top.force, rel=1e-3)   # reloading comes back to where it left
    assert case.contact.failures == 0


def test_no_length_in_the_equations():
    """Twice as large bodies at twice the approach: four times the force, to rounding."""
    small, large = (cases.Case(name, METAL, COARSE) for name in ('5-5', '10-10'))
    approaches = small.approaches(12)[:4]
    forces = [(small.contact.press(approach).force, large.contact.press(2 * approach).force) for approach in approaches]
    assert [4 * one for one, _ in forces] == pytest.approx([other for _, other in forces], rel=1e-6)


def test_contact_that_cannot_yield_is_refused():
    with pytest.raises(ValueError, match=r'yieldStress = 5000000000\.0: the contact does not yield before'):
        cases.Case('5-5', {**METAL, 'yieldStress': 5e9}, COARSE)
