"""Validation 1 of Wang & Ji (2018): a cylinder on a plane against (15) and (16)."""
import pytest

from yade.superquadric.validations import cylinderimpact

RADIUS = cylinderimpact.DIAMETER / 2


def errors(angle, n1):
    measured, expected = cylinderimpact.impact(angle, n1)
    return abs(measured.velocity - expected.velocity) / cylinderimpact.SPEED, abs(measured.spin - expected.spin) * RADIUS / cylinderimpact.SPEED


@pytest.mark.parametrize('n1', [8.0, 12.0, 20.0])
@pytest.mark.parametrize('angle', range(0, 91, 5))
def testReboundMatchesRigidBodyWithRealLeverArm(angle, n1):
    velocity, spin = errors(angle, n1)
    assert velocity <= 0.02
    assert spin <= 0.02


@pytest.mark.parametrize('angle', [0, 90])
def testFlatImpactRestitutesLikeASphere(angle):
    measured, _ = cylinderimpact.impact(angle)
    assert measured.velocity == pytest.approx(0.85, abs=0.02 * 0.85)  # the paper, section 3.1
    assert abs(measured.spin) * RADIUS <= 0.02 * cylinderimpact.SPEED


def testConvergesToIdealCylinder():
    """The edge of an n1 = 8 cylinder is rounded; with n1 the lever arm, and with it the rebound, nears the sharp one's."""
    def ideal(angle):
        return cylinderimpact.closedForm(cylinderimpact.idealLever(angle), cylinderimpact.MASS, cylinderimpact.INERTIA)

    def distance(n1):
        return sum(abs(cylinderimpact.impact(angle, n1)[0].velocity - ideal(angle).velocity) for angle in range(5, 90, 10))

    at8, at12, at20 = distance(8.0), distance(12.0), distance(20.0)
    assert at20 < at12 < at8
    assert at20 < 0.55 * at8  # the corner's distance falls as 1/n1


def testClosedFormIsThePapers():
    """(16) in its printed form, with the ideal cylinder's numbers at 45 degrees."""
    lever = cylinderimpact.idealLever(45)
    rebound = cylinderimpact.closedForm(lever, cylinderimpact.MASS, cylinderimpact.INERTIA)
    spin = cylinderimpact.MASS * cylinderimpact.SPEED * 1.85 * lever / (cylinderimpact.INERTIA + cylinderimpact.MASS * lever ** 2)
    assert rebound.spin == pytest.approx(spin, rel=1e-12)
    assert rebound.velocity == pytest.approx(-(spin * lever - 0.85 * cylinderimpact.SPEED), rel=1e-12)
