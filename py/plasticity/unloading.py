"""How well the law's unloading fits the finite elements: Hertz's with the disc of contact that loading has left, from (dmax, f) down to dR:

    f = 4/3 E* sqrt(R') (d - dR)^(3/2)

With the disc of radius a it is R' (dmax - dR) = a^2, so dmax - dR = 3 f/(4 E* a). The law in YADE (pkg/mechanics/ElastoplasticContact.hpp) takes
a^2 = R dmax; the paper's text leaves the original R in the place of R'.
"""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy
from scipy import integrate

from . import fit

if TYPE_CHECKING:
    from .curves import Curve

STEPS = 4001   # of the law's curve


class Branch(NamedTuple):
    """Radius R' and residual overlap dR, both [m]."""

    radius: float
    residual: float


class Comparison(NamedTuple):
    """One unloading. ratio: R/R0; largest: dmax/dy; halfWidth: a^2/(R dmax) of the finite elements; residual: dR/dmax; law,
    original, disc: the same of branches with a^2 = R dmax, with the original R, with the finite elements' a; returned: energy that unloading gives
    back over the work of loading, lawReturned: the law's branch over the same work."""

    case: str
    ratio: float
    largest: float
    halfWidth: float
    residual: float
    law: float
    original: float
    disc: float
    returned: float
    lawReturned: float


def lawBranch(curve: Curve) -> Branch:
    """The Branch with a^2 = R dmax; `curve` is a curves.Curve that begins at dmax."""
    return discBranch(curve, numpy.sqrt(curve.radius * curve.overlap[0]))


def discBranch(curve: Curve, halfWidth: float) -> Branch:
    """The Branch with a disc of contact of the radius `halfWidth` [m]."""
    way = 3 * curve.force[0] / (4 * curve.modulus * halfWidth)
    return Branch(halfWidth**2 / way, curve.overlap[0] - way)


def originalBranch(curve: Curve) -> Branch:
    """The Branch with the undeformed bodies' R."""
    way = (3 * curve.force[0] / (4 * curve.modulus * numpy.sqrt(curve.radius)))**(2 / 3)
    return Branch(curve.radius, curve.overlap[0] - way)


def force(branch: Branch, modulus: float, overlap: Any) -> Any:
    """[N]; zero up to the residual overlap."""
    return 4 / 3 * modulus * numpy.sqrt(branch.radius) * numpy.maximum(0, overlap - branch.residual)**1.5


def residual(curve: Curve) -> float:
    """Where the force of an unloading curve vanishes [m]: its power 2/3 goes on along the straight line of the last three loads."""
    slope, start = numpy.polyfit(curve.overlap[-3:], curve.force[-3:]**(2 / 3), 1)
    return -start / slope


def compare(loading: Curve, curve: Curve) -> Comparison:
    """The Comparison of an unloading curves.Curve that left the loading one."""
    largest, end = curve.overlap[0], residual(curve)
    work = _work(loading, largest)
    tail = 2 / 5 * curve.force[-1] * (curve.overlap[-1] - end)
    returned = (integrate.simpson(curve.force[::-1], x=curve.overlap[::-1]) + tail) / work
    law = lawBranch(curve)
    lawReturned = 2 / 5 * curve.force[0] * (largest - law.residual) / work
    return Comparison(curve.name, curve.radius / fit.REFERENCE_RADIUS, largest / curve.yieldPoint.overlap,
                      curve.halfWidth[0]**2 / (curve.radius * largest), end / largest, law.residual / largest,
                      originalBranch(curve).residual / largest, discBranch(curve, curve.halfWidth[0]).residual / largest, returned, lawReturned)


def lawRestitution(constants: Sequence[float], ratio: float, largest: float) -> float:
    """Restitution of a slow collision by the law alone, with loading and unloading as in pkg/mechanics/ElastoplasticContact.cpp.

    :param constants: m0, m1, m2, H; :param ratio: R/R0; :param largest: dmax/dy > 1
    """
    scaled = numpy.linspace(1, numpy.sqrt(largest), STEPS)
    fitted = fit.force(constants, ratio, scaled - 1)
    residual = numpy.maximum.accumulate(scaled**2 - fitted / scaled)   # dR/dy; where it would shrink it stays
    force = scaled * (scaled**2 - residual)
    work = 2 / 5 + integrate.trapezoid(2 * scaled * force, scaled)
    return float(numpy.sqrt(2 / 5 * force[-1] * (largest - residual[-1]) / work))


def _work(loading: Curve, largest: float) -> float:
    """Work of loading up to the overlap `largest` [J]; below the first load it is Hertz's."""
    overlap = numpy.append(loading.overlap[loading.overlap < largest], largest)
    force = numpy.interp(overlap, loading.overlap, loading.force)
    return 2 / 5 * force[0] * overlap[0] + integrate.simpson(force, x=overlap)
