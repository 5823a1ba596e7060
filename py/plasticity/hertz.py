"""Closed forms of the elastic contact: Hertz's force, and where yielding begins (Li et al. 2018).
Johnson, Contact Mechanics (1985), chapters 3, 4 and 6.

`modulus` is the effective modulus E* [Pa], `radius` the effective radius R [m] of the contact.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy

if TYPE_CHECKING:
    from .curves import Curve

PRESSURE_AT_YIELD = 1.6   # p_y/sigma_y: Mises, Poisson's ratio 0.3; the same number as in pkg/mechanics/ElastoplasticContact.cpp


class YieldPoint(NamedTuple):
    pressure: float
    force: float
    overlap: float
    contactRadius: float


def effectiveModulus(young: float, poisson: float) -> float:
    """E* of two bodies of the same material [Pa]."""
    return young / (2 * (1 - poisson**2))


def effectiveRadius(*radii: float) -> float:
    """R of two bodies [m]; a plate has the radius infinity."""
    return 1 / sum(1 / radius for radius in radii)


def yieldPoint(yieldStress: float, modulus: float, radius: float) -> YieldPoint:
    """The elastic contact at the onset of yield."""
    pressure = PRESSURE_AT_YIELD * yieldStress
    slope = numpy.pi * pressure / (2 * modulus)   # ay/R
    return YieldPoint(pressure, 4 / 3 * modulus * radius**2 * slope**3, slope**2 * radius, slope * radius)


def force(modulus: float, radius: float, overlap: Any) -> Any:
    """Hertz's force [N]."""
    return 4 / 3 * modulus * numpy.sqrt(radius) * overlap**1.5


def halfWidth(modulus: float, radius: float, force: Any) -> Any:
    """Radius of the disc of contact under a force [m]."""
    return numpy.cbrt(3 * force * radius / (4 * modulus))


def meanDisplacement(young: float, poisson: float, width: float) -> float:
    """What a half-space's surface gives way under the pressure exp(-(r/width)^2) of unit force, weighted by the pressure [m/N].

    With Hankel transforms u^(k) = 2 (1 - nu^2)/E p^(k)/k (Sneddon, Fourier Transforms (1951), section 52); that of the pressure is a Gaussian.
    """
    return (1 - poisson**2) / (young * width * numpy.sqrt(2 * numpy.pi))


def errors(curve: Curve) -> Any:
    """Relative departures of a curves.Curve from Hertz, arrays: of the force at the same overlap, of the half-width under the same force."""
    return (curve.force / force(curve.modulus, curve.radius, curve.overlap) - 1,
            curve.halfWidth / halfWidth(curve.modulus, curve.radius, curve.force) - 1)
