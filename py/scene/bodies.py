"""Particles: the body helper `superquadric` (the sibling of `yade.utils.sphere`) and the shapes of a study.

A `ParticleShape` says what a particle looks like without making one; `ParticleShape.body` makes the body. Its size
is given by the sphere of equal volume, so that particles of all shapes in a study have the same mass.
"""
import math
from collections import namedtuple
from collections.abc import Iterable

from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import Body, Superquadric

from .. import checks

LARGEST_ID = 2 ** 31 - 1  # YADE's numbers of bodies have 32 bits

SHAPES = ('sphere', 'ellipsoid', 'cylinder', 'cube', 'block')
BLOCK_EXPONENT = 8.0  # the paper's largest exponent: its "cube", "block" and the flat ends of its "cylinder"


def unitVolume(n1, n2):
    """Volume of the superquadric with half sizes 1 [-]."""
    return Superquadric(extents=(1, 1, 1), n1=n1, n2=n2).volume()


def equalVolumeExtents(radius, n1, n2, aspect=1.0):
    """Half sizes (a, a, aspect*a) [m] of the superquadric that has the volume of a sphere of `radius` [m].

    :param n1: exponent along z; :param n2: exponent in the x-y plane; both in [2, 20]
    :param aspect: c/a
    """
    radius, aspect = checks.positive('radius', radius), checks.positive('aspect', aspect)
    n1, n2 = checks.exponent('n1', n1), checks.exponent('n2', n2)
    a = radius * (4 * math.pi / 3 / (aspect * unitVolume(n1, n2))) ** (1 / 3)
    return a, a, aspect * a


class ParticleShape(namedtuple('ParticleShape', 'extents n1 n2 asSphere')):
    """Half sizes [m] and exponents of a particle; `asSphere`: made as YADE's own Sphere (the same law serves both)."""

    __slots__ = ()

    @property
    def volume(self):
        """[m3]"""
        a, b, c = self.extents
        return a * b * c * unitVolume(self.n1, self.n2)

    @property
    def boundingRadius(self):
        """Radius of the smallest sphere about the centre that holds the particle [m]."""
        return self.extents[0] if self.asSphere else self.yadeShape().boundingRadius()

    def yadeShape(self):
        return Superquadric(extents=self.extents, n1=self.n1, n2=self.n2)

    def scaled(self, factor):
        """The same shape, `factor` times as large."""
        return self._replace(extents=tuple(factor * size for size in self.extents))

    def body(self, center, orientation, material, color=None):
        """A body of this shape with its centre at `center` [m], not yet in the scene; see `superquadric` for the others."""
        if self.asSphere:
            body = utils.sphere(checks.vector('center', center), self.extents[0], material=material, color=color)
            body.state.ori = rotation(orientation)
            return body
        return superquadric(center, self.extents, self.n1, self.n2, material, orientation, color=color)


def particleShape(name, radius=5e-3, aspect=1.0, n1=None, n2=None, sphereAsSuperquadric=False):
    """A shape of the paper by its `name`, with the volume of a sphere of `radius` [m].

    ========= ==== ==== ==========================================
    name       n1   n2
    ========= ==== ==== ==========================================
    sphere      2    2   aspect must be 1; YADE's Sphere by default
    ellipsoid   2    2   c/a = aspect, and so on below
    cylinder    8    2
    cube        8    8   aspect must be 1
    block       8    8
    ========= ==== ==== ==========================================

    `n1`, `n2` replace the exponents of the table (a "cube" with n1 = n2 = 4 is on the paper's way to the sphere).
    """
    checks.oneOf('shape', name, SHAPES)
    aspect = checks.positive('aspect', aspect)
    if name in ('sphere', 'cube') and aspect != 1:
        raise ValueError(f'aspect = {aspect!r}: a {name} has aspect 1; use '
                         f'{"ellipsoid" if name == "sphere" else "block"} for others')
    round1, round2 = name in ('sphere', 'ellipsoid'), name in ('sphere', 'ellipsoid', 'cylinder')
    e1 = checks.exponent('n1', n1 if n1 is not None else 2.0 if round1 else BLOCK_EXPONENT)
    e2 = checks.exponent('n2', n2 if n2 is not None else 2.0 if round2 else BLOCK_EXPONENT)
    asSphere = name == 'sphere' and e1 == e2 == 2 and not sphereAsSuperquadric
    extents = (checks.positive('radius', radius),) * 3 if asSphere else equalVolumeExtents(radius, e1, e2, aspect)
    return ParticleShape(extents, e1, e2, asSphere)


def superquadric(center, extents, n1, n2, material=-1, orientation=Quaternion.Identity, fixed=False, wire=False,
                 color=None, highlight=False, mask=1):
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


def numbers(name, ids):
    """`ids` as a list of whole numbers that bodies may have."""
    if isinstance(ids, (str, bytes)) or not isinstance(ids, Iterable):
        raise ValueError(f'{name} = {ids!r}: must be numbers of bodies')
    return [checks.wholeNumber(name, i, 0, LARGEST_ID) for i in ids]


def present(name, ids):
    """`ids` as a list of whole numbers, each of a body that is in the scene."""
    found, bodies = numbers(name, ids), O.bodies
    for i in found:
        if i >= len(bodies) or bodies[i] is None:
            raise ValueError(f'{name}: must be of bodies in the scene, got {checks.shown(i)}')
    return found


def rotation(orientation):
    """The normalised `orientation`; ValueError if it is no rotation."""
    if not isinstance(orientation, Quaternion):
        raise ValueError(f'orientation = {orientation!r}: must be a Quaternion')
    norm = orientation.norm()
    if not (math.isfinite(norm) and norm > 0):
        raise ValueError(f'orientation = {orientation!r}: must be finite and not zero')
    return orientation.normalized()
