"""Restitution of the normal force of Wang & Ji (2018), and the time step that a collision asks for.

With the overlap d, the speed v and the time in units that make 4/3 E* sqrt(R*) and m* one, the normal force gives v' = -d^(3/2) - eta d^(1/4) v,
eta = sqrt(6) Cn. In the time s with ds = d^(1/4) dt and with z = d^(5/4) this is the linear oscillator dv/ds = -z - eta v, dz/ds = 5/4 v
(so the restitution does not depend on the speed). The force is cut where it would pull, at dv/ds = 0; there

    e = exp(-a (pi - 2 arctan a)),   a = eta/sqrt(5 - eta^2).
"""
from __future__ import annotations

import math

from .. import checks

LARGEST_RATIO = 1e3  # of a: e < 0.14 from 7 on, and no less than exp(-2)


def restitutionOf(normalDamping: float) -> float:
    """Restitution coefficient [-] of a central collision for Cn = `normalDamping`, below sqrt(5/6) (the oscillator must swing)."""
    eta = math.sqrt(6) * checks.within('normalDamping', normalDamping, 0, math.sqrt(5 / 6), highIncluded=False)
    return _restitution(eta / math.sqrt(5 - eta ** 2))


def normalDampingFor(restitution: float) -> float:
    """Cn [-] that gives a `restitution` coefficient; ValueError outside (exp(-2), 1], which the law can give.

    By bisection: e falls with a.
    """
    restitution = checks.within('restitution', restitution, _restitution(LARGEST_RATIO), 1)
    low, high = 0.0, LARGEST_RATIO
    while (middle := (low + high) / 2) not in (low, high):
        low, high = (middle, high) if _restitution(middle) > restitution else (low, middle)
    return math.sqrt(5 / 6) * low / math.hypot(1, low)


def collisionDuration(mass: float, radius: float, modulus: float, speed: float) -> float:
    """2.87 (m*^2/(R* E*^2 v))^(1/5) [s]: how long two elastic bodies touch that meet at `speed` [m/s] (Johnson, Contact Mechanics,
    1985, his equation 11.24).

    :param mass: m* [kg]; :param radius: R* [m]; :param modulus: E* [Pa]
    """
    return 2.87 * (mass ** 2 / (radius * modulus ** 2 * speed)) ** 0.2


def _restitution(ratio: float) -> float:
    return math.exp(-ratio * (math.pi - 2 * math.atan(ratio)))
