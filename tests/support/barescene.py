"""A scene with the functors of the shapes only, and how bodies get into it: the tests of shapes and contacts share it."""
import pytest
from yade import Body, O
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import (
    Bo1_Facet_Aabb,
    Bo1_HollowCylinder_Aabb,
    Bo1_Sphere_Aabb,
    Bo1_Superquadric_Aabb,
    Bo1_Wall_Aabb,
    CurvatureMat,
    ForceResetter,
    Ig2_Facet_Superquadric_SuperquadricGeom,
    Ig2_HollowCylinder_Sphere_SuperquadricGeom,
    Ig2_HollowCylinder_Superquadric_SuperquadricGeom,
    Ig2_Sphere_Superquadric_SuperquadricGeom,
    Ig2_Superquadric_Superquadric_SuperquadricGeom,
    Ig2_Wall_Superquadric_SuperquadricGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_CurvatureMat_CurvatureMat_CurvaturePhys,
    Law2_ScGeom_CurvaturePhys_HertzMindlin,
    NewtonIntegrator,
    Superquadric,
)

R = 5e-3
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
