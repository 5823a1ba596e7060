"""The engines of a superquadric scene, and its time step."""
from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

from yade import O
from yade.wrapper import (
    Bo1_Facet_Aabb,
    Bo1_HollowCylinder_Aabb,
    Bo1_Sphere_Aabb,
    Bo1_Superquadric_Aabb,
    Bo1_Wall_Aabb,
    Body,
    BreakableMat,
    CurvatureMat,
    ElastoplasticMat,
    ForceResetter,
    Ig2_Facet_Sphere_ScGeom,
    Ig2_Facet_Superquadric_SuperquadricGeom,
    Ig2_HollowCylinder_Sphere_SuperquadricGeom,
    Ig2_HollowCylinder_Superquadric_SuperquadricGeom,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Sphere_Superquadric_SuperquadricGeom,
    Ig2_Superquadric_Superquadric_SuperquadricGeom,
    Ig2_Wall_Sphere_ScGeom,
    Ig2_Wall_Superquadric_SuperquadricGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_CurvatureMat_CurvatureMat_CurvaturePhys,
    Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys,
    Law2_ScGeom_CurvaturePhys_HertzMindlin,
    Law2_ScGeom_ElastoplasticPhys_LoadingUnloading,
    NewtonIntegrator,
    Sphere,
    Superquadric,
    SuperquadricInteractionLoop,
)

from .. import checks
from .contactlaws import CURVATURE, ELASTOPLASTIC

LAWS = {CURVATURE: (Ip2_CurvatureMat_CurvatureMat_CurvaturePhys, Law2_ScGeom_CurvaturePhys_HertzMindlin),
        ELASTOPLASTIC: (Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys, Law2_ScGeom_ElastoplasticPhys_LoadingUnloading)}


def superquadricEngines(gravity: Sequence[float] = (0, 0, -9.81), verletDist: float | None = None, damping: float = 0.0,
                        afterForces: Iterable[Any] = (), law: str | None = None) -> list[Any]:
    """The full list of engines, to be assigned to `O.engines`.

    Forces are added up in the order of the bodies' ids (`SuperquadricInteractionLoop`): on one thread a scene that is saved, loaded
    and continued equals one that never stopped, bit for bit.

    :param gravity: [m/s2]
    :param verletDist: margin [m] that the collider adds to the boxes so that it need not run at every step; YADE's
        automatic choice knows spheres only, therefore by default a fifth of the smallest half size in the scene
    :param damping: YADE's non-viscous damping [-]; 0 leaves the dissipation to the contact law
    :param afterForces: engines to run when all contact forces are known and nothing has moved yet (recorders)
    :param law: of the contacts: 'curvature' (Wang & Ji 2018), or 'elastoplastic' (Li et al. 2018; pairs without an
        ElastoplasticMat are elastic under it). By default the latter where a body in the scene has an ElastoplasticMat, other than a
        BreakableMat that does not yield

    Contacts exist between bodies whose material is a CurvatureMat only; YADE aborts the whole process when it meets a pair
    that it has no law for. So the bodies that are in the scene are looked through here; later ones are not.

    :raises ValueError: a value out of range, a body whose material is not a CurvatureMat, or one whose material yields
        under the law that has no yielding
    """
    checkMaterials()
    physics, contactLaw = LAWS[_lawFor(law)]
    margin = 0.2 * min(halfSizes(), default=5e-3) if verletDist is None else checks.notNegative('verletDist', verletDist)
    damping = checks.within('damping', damping, 0, 1, highIncluded=False)
    bounds = [Bo1_Superquadric_Aabb(), Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Facet_Aabb(), Bo1_HollowCylinder_Aabb()]
    return [
        ForceResetter(),
        InsertionSortCollider(bounds, verletDist=margin),
        SuperquadricInteractionLoop(_geometryFunctors(), [physics()], [contactLaw()]),
        *afterForces,
        NewtonIntegrator(gravity=gravity, damping=damping, exactAsphericalRot=True),
    ]


def checkMaterials() -> None:
    """ValueError if a body in the scene that can touch others has a material other than CurvatureMat."""
    for body in O.bodies:
        if body.shape is not None and not body.isClump and not isinstance(body.mat, CurvatureMat):
            kind = 'none' if body.mat is None else type(body.mat).__name__
            raise ValueError(f'body {body.id}: its material is {kind}, but contacts of superquadrics need a CurvatureMat '
                             f'on all bodies')


def _lawFor(law: str | None) -> str:
    """The key of LAWS for the bodies in the scene, `law` itself if it is not None."""
    elastoplastic = [body for body in O.bodies if isinstance(body.mat, ElastoplasticMat)
                     and not (isinstance(body.mat, BreakableMat) and math.isinf(body.mat.yieldStress))]
    if law is None:
        return ELASTOPLASTIC if elastoplastic else CURVATURE
    if checks.oneOf('law', law, LAWS) == CURVATURE:
        for body in elastoplastic:
            if math.isfinite(body.mat.yieldStress):
                raise ValueError(f'law = {law!r}: it knows no yielding, but body {body.id} has an ElastoplasticMat with '
                                 f'yieldStress = {body.mat.yieldStress:g} Pa')
    return law


def _geometryFunctors() -> list[Any]:
    # YADE's correction against granular ratcheting belongs to spheres: it takes the branch vectors for the radii.
    # It is off for spheres as well, so that they follow the same law as superquadrics with n1 = n2 = 2.
    return [
        Ig2_Superquadric_Superquadric_SuperquadricGeom(), Ig2_Sphere_Superquadric_SuperquadricGeom(),
        Ig2_Wall_Superquadric_SuperquadricGeom(), Ig2_Facet_Superquadric_SuperquadricGeom(),
        Ig2_HollowCylinder_Superquadric_SuperquadricGeom(), Ig2_HollowCylinder_Sphere_SuperquadricGeom(),
        Ig2_Sphere_Sphere_ScGeom(avoidGranularRatcheting=False),
        Ig2_Wall_Sphere_ScGeom(noRatch=False), Ig2_Facet_Sphere_ScGeom(),
    ]


def engine(kind: type, engines: Iterable[Any] | None = None) -> Any:
    """The first engine of class `kind` in the scene (or in `engines`)."""
    for candidate in O.engines if engines is None else engines:
        if isinstance(candidate, kind):
            return candidate
    raise ValueError(f'engine = {kind.__name__}: there is none in O.engines; set O.engines = superquadricEngines()')


def solverCounters(reset: bool = False) -> dict[str, int]:
    """What the solvers have met so far in all pairs with a superquadric, walls included, as a dict (see
    `Ig2_Superquadric_Superquadric_SuperquadricGeom.counters`), since the scene was made or loaded, or since the last call with `reset`."""
    total: Counter[str] = Counter()
    for functor in engine(InteractionLoop).geomDispatcher.functors:
        if hasattr(functor, 'counters'):
            total.update(functor.counters())
            if reset:
                functor.resetCounters()
    return dict(total)


def minHalfSize(shape: Any) -> float | None:
    """Smallest half size [m] of a particle's shape; None for walls."""
    if isinstance(shape, Superquadric):
        return min(shape.extents)
    return shape.radius if isinstance(shape, Sphere) else None


def halfSizes() -> list[float]:
    """Smallest half size [m] of every particle in the scene."""
    return [size for size in (minHalfSize(body.shape) for body in O.bodies) if size is not None]


def criticalTimeStep(bodies: Iterable[Body] | None = None) -> float:
    """The smallest Rayleigh time step [s] among `bodies` (default: the scene's): that of Wang & Ji (2018),
    pi Rmin / (0.163 nu + 0.8766) sqrt(density/G) with Rmin = min(a, b, c).

    :raises ValueError: there is no particle with a CurvatureMat
    """
    steps = {}
    for body in O.bodies if bodies is None else bodies:
        size = minHalfSize(body.shape)
        if size is not None and isinstance(body.mat, CurvatureMat):
            key = size, body.mat.young, body.mat.poisson, body.mat.density
            if key not in steps:
                steps[key] = body.mat.criticalTimeStep(size)
    if not steps:
        raise ValueError('bodies: no sphere or superquadric with a CurvatureMat, so there is no critical time step')
    return min(steps.values())


def checkTimeStep(dt: float, bodies: Iterable[Body] | None = None) -> float:
    """`dt` [s] if it does not exceed the critical step of `bodies`, else ValueError. A tenth of it is advisable."""
    dt, critical = checks.positive('dt', dt), criticalTimeStep(bodies)
    if dt > critical:
        raise ValueError(f'dt = {dt!r}: above the critical time step {critical:.4g} s; '
                         f'a tenth of that is advisable')
    return dt
