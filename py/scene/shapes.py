"""The shapes of particles as plain numbers: half sizes, exponents, volume, bounding sphere. No YADE is needed for them.

A `ParticleShape` says what a particle looks like without making one; `bodies.particleBody` makes the body. Its size is given by the
sphere of equal volume, so that particles of all shapes in a study have the same mass.
"""
from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any, NamedTuple

from .. import checks

if TYPE_CHECKING:
    from yade.wrapper import Body

SHAPES = ('sphere', 'ellipsoid', 'cylinder', 'cube', 'block')
BLOCK_EXPONENT = 8.0  # the paper's largest exponent: its "cube", "block" and the flat ends of its "cylinder"

# The plugin computes volumes and radii with the C library's functions. Python's math has implementations of its own of these two, whose last
# bits may differ, and a bed has to be the same bit for bit wherever its shapes are computed.
_cLibrary = ctypes.CDLL(None)
_lgamma, _hypot = _cLibrary.lgamma, _cLibrary.hypot
_lgamma.argtypes, _hypot.argtypes = [ctypes.c_double], [ctypes.c_double] * 2
_lgamma.restype = _hypot.restype = ctypes.c_double


def unitVolume(n1: float, n2: float) -> float:
    """Volume of the superquadric with half sizes 1 [-]; as `superquadric::volume` in pkg/geometry/MassProperties.cpp."""
    e1, e2 = 2 / checks.exponent('n1', n1), 2 / checks.exponent('n2', n2)
    return 2 * e1 * e2 * _beta(e1 / 2 + 1, e1) * _beta(e2 / 2, e2 / 2)


def _beta(x: float, y: float) -> float:
    return math.exp(_lgamma(x) + _lgamma(y) - _lgamma(x + y))


def boundingRadius(extents: tuple[float, float, float], n1: float, n2: float) -> float:
    """Radius of the smallest sphere about the centre that holds the superquadric of half sizes `extents`, in their unit.

    With X = x^2 ... the squared distance is linear and the equation of the shape a norm with the exponents n/2: the maximum is the dual norm,
    of exponents n/(n-2), of the squared half sizes. As `farthestPoint` in pkg/geometry/Shape.cpp.
    """
    extents = checks.extents('extents', extents)
    dual1, dual2 = (math.inf if n == 2 else n / (n - 2) for n in (checks.exponent('n1', n1), checks.exponent('n2', n2)))
    scale = max(extents)
    x, y, z = ((size / scale) * (size / scale) for size in extents)
    return scale * math.sqrt(_norm(_norm(x, y, dual2), z, dual1))


def _norm(p: float, q: float, m: float) -> float:
    """(p^m + q^m)^(1/m) of positive p and q; the larger one when m is infinite."""
    large, small = max(p, q), min(p, q)
    if math.isinf(m):
        return large
    if m == 2:
        return float(_hypot(p, q))
    return large * math.pow(1 + math.pow(small / large, m), 1 / m)


def equalVolumeExtents(radius: float, n1: float, n2: float, aspect: float = 1.0) -> tuple[float, float, float]:
    """Half sizes (a, a, aspect*a) [m] of the superquadric that has the volume of a sphere of `radius` [m].

    :param n1: exponent along z; :param n2: exponent in the x-y plane; both in [2, 20]
    :param aspect: c/a
    """
    radius, aspect = checks.positive('radius', radius), checks.positive('aspect', aspect)
    n1, n2 = checks.exponent('n1', n1), checks.exponent('n2', n2)
    a = radius * (4 * math.pi / 3 / (aspect * unitVolume(n1, n2))) ** (1 / 3)
    return a, a, aspect * a


class ParticleShape(NamedTuple):
    """Half sizes [m] and exponents of a particle; `asSphere`: made as YADE's own Sphere (the same law serves both)."""

    extents: tuple[float, float, float]
    n1: float
    n2: float
    asSphere: bool

    @property
    def volume(self) -> float:
        """[m3]"""
        a, b, c = self.extents
        return a * b * c * unitVolume(self.n1, self.n2)

    @property
    def boundingRadius(self) -> float:
        """Radius of the smallest sphere about the centre that holds the particle [m]."""
        return self.extents[0] if self.asSphere else boundingRadius(self.extents, self.n1, self.n2)

    def scaled(self, factor: float) -> ParticleShape:
        """The same shape, `factor` times as large."""
        a, b, c = self.extents
        return self._replace(extents=(factor * a, factor * b, factor * c))

    def body(self, center: Any, orientation: Any, material: Any, color: Any = None) -> Body:
        """`bodies.particleBody` of this shape, where YADE is."""
        from .bodies import particleBody
        return particleBody(self, center, orientation, material, color)


def particleShape(name: str, radius: float = 5e-3, aspect: float = 1.0, n1: float | None = None, n2: float | None = None,
                  sphereAsSuperquadric: bool = False) -> ParticleShape:
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
