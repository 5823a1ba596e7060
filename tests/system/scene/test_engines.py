"""The list of engines, what it asks of the scene, and what is read from it."""
import pytest
from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    CurvatureMat,
    ForceResetter,
    FrictMat,
    Ig2_Sphere_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_CurvatureMat_CurvatureMat_CurvaturePhys,
    Ip2_FrictMat_FrictMat_FrictPhys,
    Law2_ScGeom_CurvaturePhys_HertzMindlin,
    Law2_ScGeom_FrictPhys_CundallStrack,
)

import yade.superquadric as sq

R = 5e-3
APART = 2 * R - 1e-5  # distance of two spheres that touch


@pytest.fixture
def material():
    O.reset()
    O.materials.append(CurvatureMat(young=1e9, poisson=0.2, density=2500, frictionAngle=0.4))
    return O.materials[0]


@pytest.mark.parametrize('other', [FrictMat(young=1e9), None])
def test_bodyOfAnotherMaterialIsNamed(material, other):
    O.bodies.append(sq.superquadric((0, 0, 0), (R,) * 3, 2, 2, material))
    O.bodies.append(utils.wall(0.0, 2, material=material))
    sq.superquadricEngines()
    bad = utils.sphere((1, 0, 0), R, material=material)
    bad.material = other
    O.bodies.append(bad)
    with pytest.raises(ValueError, match=f'body 2: its material is {"FrictMat" if other else "none"}.*CurvatureMat'):
        sq.superquadricEngines()


def test_clumpsNeedNoMaterialOfTheirOwn(material):
    O.bodies.appendClumped([utils.sphere((x, 0, 0), R, material=material) for x in (0, R)])
    assert O.bodies[2].isClump and O.bodies[2].mat is None
    sq.superquadricEngines()


def test_solverCountersAddUpBothKindsOfPairs(material):
    """A pair of superquadrics, and a sphere on a superquadric far away from it."""
    for x, first, second in ((0, True, True), (1, True, False)):
        for place, general in (((x, 0, 0), first), ((x, 0, APART), second)):
            O.bodies.append(sq.superquadric(place, (R,) * 3, 2, 2, material) if general
                            else utils.sphere(place, R, material=material))
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 1e-9
    O.run(3, wait=True)
    assert sq.solverCounters()['solves'] == 6


def test_stiffnessOfOtherLawsStaysAsItIs(material):
    """Next to a pair under the contact law of this package, one under YADE's linear law."""
    linear = FrictMat(young=1e7, poisson=0.3, density=2500)
    O.materials.append(linear)
    for x, own in ((0, material), (1, linear)):
        O.bodies.append([utils.sphere((x, 0, z), R, material=own) for z in (0, APART)])
    O.engines = [
        ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
                        [Ip2_FrictMat_FrictMat_FrictPhys(), Ip2_CurvatureMat_CurvatureMat_CurvaturePhys()],
                        [Law2_ScGeom_FrictPhys_CundallStrack(), Law2_ScGeom_CurvaturePhys_HertzMindlin()])]
    O.dt = 1e-9
    O.step()
    curvature, others = O.interactions[0, 1].phys, O.interactions[2, 3].phys
    before = curvature.effectiveModulus, others.kn, others.ks
    sq.scaleStiffness(10)
    assert curvature.effectiveModulus == pytest.approx(10 * before[0])
    assert (others.kn, others.ks) == before[1:]
    assert (material.young, linear.young) == (pytest.approx(1e10), 1e7)
