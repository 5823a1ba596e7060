"""Particles as bodies of YADE: `superquadric` (the sibling of `yade.utils.sphere`), and a body of a `shapes.ParticleShape`."""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import Body, Superquadric

from .. import checks

if TYPE_CHECKING:
    from .shapes import ParticleShape

LARGEST_ID = 2 ** 31 - 1  # YADE's numbers of bodies have 32 bits


def particleBody(shape: ParticleShape, center: Sequence[float], orientation: Quaternion, material: Any, color: Any = None) -> Body:
    """A body of that `ParticleShape` with its centre at `center` [m], not yet in the scene; see `superquadric` for the others."""
    if shape.asSphere:
        body = utils.sphere(checks.vector('center', center), shape.extents[0], material=material, color=color)
        body.state.ori = rotation(orientation)
        return body
    return superquadric(center, shape.extents, shape.n1, shape.n2, material, orientation, color=color)


def superquadric(center: Sequence[float], extents: Sequence[float], n1: float, n2: float, material: Any = -1,
                 orientation: Quaternion = Quaternion.Identity, fixed: bool = False, wire: bool = False,
                 color: Any = None, highlight: bool = False, mask: int = 1) -> Body:
    """Create a superquadric particle; mass and inertia from the closed forms, in YADE's way of `utils.sphere`.

    `Body.aspherical` is set where the principal moments differ: a body of isotropic inertia (sphere, cube) is
    integrated exactly, and faster, by YADE's integrator for spheres.

    Mass and inertia belong to the sizes given here: a later change of `shape.extents` leaves them as they are, they have to be
    set by hand then. In a periodic cell with an imposed velocity gradient YADE adds the cell's own rotation to bodies that are
    not aspherical.

    :param center: position of the centre [m]
    :param extents: half sizes (a, b, c) along the body's axes [m]
    :param n1: exponent along the body's z; :param n2: exponent in its x-y plane; both in [2, 20]
    :param material: a material, its id or its label, as in `utils.sphere`; contacts need a CurvatureMat on both bodies
    :param orientation: Quaternion that turns the body's axes into the scene's; it is normalised
    :returns: Body, not yet in the scene
    :raises ValueError: a half size that is not positive and finite, an exponent out of range, a center that is not three
        numbers, an orientation that is no rotation
    """
    extents = checks.extents('extents', extents)
    n1, n2 = checks.exponent('n1', n1), checks.exponent('n2', n2)
    center, orientation = Vector3(*checks.vector('center', center)), rotation(orientation)
    body = Body()
    body.shape = Superquadric(extents=extents, n1=n1, n2=n2, color=color if color else utils.randomColor(),
                              wire=wire, highlight=highlight)
    inertia = body.shape.inertia(1.0)
    utils._commonBodySetup(body, body.shape.volume(), inertia, material, pos=center, fixed=fixed)
    body.state.ori = body.state.refOri = orientation
    body.aspherical = max(inertia) - min(inertia) > 1e-9 * max(inertia)
    body.mask = mask
    return body


def numbers(name: str, ids: Any) -> list[int]:
    """`ids` as a list of whole numbers that bodies may have."""
    if isinstance(ids, (str, bytes)) or not isinstance(ids, Iterable):
        raise ValueError(f'{name} = {ids!r}: must be numbers of bodies')
    return [checks.wholeNumber(name, i, 0, LARGEST_ID) for i in ids]


def present(name: str, ids: Any) -> list[int]:
    """`ids` as a list of whole numbers, each of a body that is in the scene."""
    found, bodies = numbers(name, ids), O.bodies
    for i in found:
        if i >= len(bodies) or bodies[i] is None:
            raise ValueError(f'{name}: must be of bodies in the scene, got {checks.shown(i)}')
    return found


def rotation(orientation: Any) -> Quaternion:
    """The normalised `orientation`; ValueError if it is no rotation."""
    if not isinstance(orientation, Quaternion):
        raise ValueError(f'orientation = {orientation!r}: must be a Quaternion')
    norm = orientation.norm()
    if not (math.isfinite(norm) and norm > 0):
        raise ValueError(f'orientation = {orientation!r}: must be finite and not zero')
    return orientation.normalized()
