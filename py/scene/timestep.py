"""The critical time step of a material and a size as a number; `engines.criticalTimeStep` finds the smallest one of a scene."""
from __future__ import annotations

import math

from .. import checks


def rayleighTimeStep(smallestHalfSize: float, young: float, poisson: float, density: float) -> float:
    """Time [s] in which a Rayleigh wave crosses the particle: that of Wang & Ji (2018),
    pi Rmin / (0.163 nu + 0.8766) sqrt(density/G).

    :param smallestHalfSize: Rmin = min(a, b, c) [m]; :param young: [Pa]; :param poisson: [-]; :param density: [kg/m3]
    """
    smallest = checks.positive('smallestHalfSize', smallestHalfSize)
    shearModulus = checks.positive('young', young) / (2 * (1 + checks.above('poisson', poisson, -1, 0.5)))
    return math.pi * smallest / (0.163 * poisson + 0.8766) * math.sqrt(checks.positive('density', density) / shearModulus)
