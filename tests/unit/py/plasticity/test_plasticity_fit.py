"""The fit on curves that follow the law, closed forms of the contact, and the unloading branches."""
import numpy
import pytest

from yade.superquadric.plasticity import fit, hertz, unloading
from yade.superquadric.plasticity.curves import Curve

MODULUS = 4e10
CONSTANTS = (1.5, 0.2, -0.03, 2.2)
RADII = (2.5e-3, 10e-3 / 3, 5e-3, 10e-3)


def lawCurve(radius, constants=CONSTANTS, noise=0.0, seed=1):
    """A Curve on which the law holds over both half-widths (the true one is 1.1 sqrt(R d) + a shift that keeps ay)."""
    point = hertz.yieldPoint(2.65e8, MODULUS, radius)
    scaled = numpy.geomspace(0.7, 9, 60)
    overlap = scaled**2 * point.overlap
    plastic = point.force * fit.force(constants, radius / fit.REFERENCE_RADIUS, numpy.maximum(0, scaled - 1))
    force = numpy.where(scaled > 1, plastic, hertz.force(MODULUS, radius, overlap))
    force *= 1 + noise * numpy.random.default_rng(seed).standard_normal(len(force))
    return Curve(f'{radius}', radius, point, MODULUS, overlap, force, point.contactRadius * (1 + 1.1 * (scaled - 1)))


def test_fit_finds_the_constants():
    found = fit.fit(fit.points([lawCurve(radius) for radius in RADII]))
    assert [found.constants[name] for name in fit.CONSTANTS] == pytest.approx(CONSTANTS, rel=1e-6)
    assert found.rms < 1e-9 and found.largest < 1e-8


def test_fit_over_the_true_half_width():
    """(a - ay)/ay is 1.1 times as large, hence G smaller by 1.1^H."""
    found = fit.fit(fit.points([lawCurve(radius) for radius in RADII], lambda curve: curve.halfWidth))
    assert found.constants['exponent'] == pytest.approx(CONSTANTS[3], rel=1e-6)
    assert found.constants['m0'] == pytest.approx(CONSTANTS[0] / 1.1**CONSTANTS[3], rel=1e-6)


def test_intervals_cover_the_truth():
    """95 % intervals of 100 noisy sets: hardly ever do fewer than 85 hold the exponent (binomial: 1e-4)."""
    sets = [fit.fit(fit.points([lawCurve(radius, noise=0.02, seed=100 * k + i) for i, radius in enumerate(RADII)])) for k in range(100)]
    held = sum(one.intervals['exponent'][0] <= CONSTANTS[3] <= one.intervals['exponent'][1] for one in sets)
    assert 85 <= held
    assert all(one.intervals['m1'][0] < one.constants['m1'] < one.intervals['m1'][1] for one in sets)


def test_factor_without_radius():
    curves = [lawCurve(radius, (2.0, 0, 0, 2.0)) for radius in RADII]
    found = fit.fit(fit.points(curves), degree=0)
    assert (found.constants['m0'], found.constants['m1'], found.constants['m2']) == (pytest.approx(2.0), 0, 0)
    assert found.intervals['m1'] == (0, 0)


def test_too_few_radii_are_refused():
    with pytest.raises(ValueError, match='2 effective radii: too few to fit 4 constants'):
        fit.fit(fit.points([lawCurve(RADII[0]), lawCurve(RADII[1])]))


def test_collapse_measures_how_far_curves_lie_apart():
    same = [lawCurve(radius, (2.0, 0, 0, 2.0)) for radius in RADII[:2]]
    assert fit.collapse(fit.points(same)) < 1e-12
    doubled = same[1]._replace(force=same[1].force * 1.2)
    assert fit.collapse(fit.points([same[0], doubled])) == pytest.approx(0.1 / 1.1, rel=1e-6)


def test_yield_point_is_on_the_elastic_curve():
    """(5)-(7) against Hertz: p0 = 3 f/(2 pi a^2) is 1.6 sigma_y there."""
    point = hertz.yieldPoint(2.65e8, MODULUS, 2.5e-3)
    assert hertz.force(MODULUS, 2.5e-3, point.overlap) == pytest.approx(point.force)
    assert hertz.halfWidth(MODULUS, 2.5e-3, point.force) == pytest.approx(point.contactRadius)
    assert 3 * point.force / (2 * numpy.pi * point.contactRadius**2) == pytest.approx(1.6 * 2.65e8)
    assert point.force == pytest.approx(numpy.pi**3 * 2.5e-3**2 * (1.6 * 2.65e8)**3 / (6 * MODULUS**2))


def test_unloading_of_a_hertz_contact_is_complete():
    """Without plasticity all three branches are Hertz's own, and everything is given back."""
    radius = 2.5e-3
    overlap = numpy.linspace(1e-7, 1e-5, 400)
    curve = Curve('elastic', radius, hertz.yieldPoint(2.65e8, MODULUS, radius), MODULUS, overlap, hertz.force(MODULUS, radius, overlap),
                  numpy.sqrt(radius * overlap))
    down = curve._replace(overlap=overlap[::-20], force=curve.force[::-20], halfWidth=curve.halfWidth[::-20])
    for branch in (unloading.lawBranch(down), unloading.originalBranch(down)):
        assert branch.radius == pytest.approx(radius)
        assert abs(branch.residual) < 1e-12
    found = unloading.compare(curve, down)
    assert abs(found.residual) < 1e-6 and found.lawReturned == pytest.approx(1, abs=1e-4) and found.returned == pytest.approx(1, abs=1e-2)


def test_flattened_branch_returns_what_it_should():
    """A branch with a disc twice Hertz's: half the way back, from the same force."""
    radius, force = 2.5e-3, 50.0
    way = (3 * force / (4 * MODULUS * numpy.sqrt(radius)))**(2 / 3)
    disc = 2 * numpy.sqrt(radius * way)
    curve = Curve('flat', radius, hertz.yieldPoint(2.65e8, MODULUS, radius), MODULUS, numpy.array([1e-4]), numpy.array([force]), numpy.array([disc]))
    branch = unloading.discBranch(curve, disc)
    assert branch.residual == pytest.approx(1e-4 - way / 2)
    assert unloading.force(branch, MODULUS, 1e-4) == pytest.approx(force)


@pytest.mark.parametrize('largest', [1.5, 9.0, 100.0])
def test_restitution_by_the_law_against_its_closed_form(largest):
    """G = 2, H = 2, where the residual overlap grows all the way: work of loading and elastic energy in closed form, in units of fy dy."""
    w = numpy.sqrt(largest) - 1
    force = 1 + 2 * w**2
    work = 2 / 5 + w * (2 + w) + 4 * w**3 * (1 / 3 + w / 4)
    elastic = 2 / 5 * force * (force / numpy.sqrt(largest))   # dmax - dR = 3 f/(4 E* a)
    assert unloading.lawRestitution((2, 0, 0, 2), 1, largest) == pytest.approx(numpy.sqrt(elastic / work), rel=1e-5)


def test_restitution_where_the_law_pauses():
    """Constants that would lie above Hertz beyond yield: nothing is lost there."""
    assert unloading.lawRestitution((20, 0, 0, 1.0), 1, 2.0) == pytest.approx(1, abs=1e-5)
