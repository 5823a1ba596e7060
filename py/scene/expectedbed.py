"""What a poured bed is expected to fill: its packing fraction, the number of particles for a thickness, and whether they fit."""
from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from .. import checks
from .container import Container, crossSection

if TYPE_CHECKING:
    from .shapes import ParticleShape

DEEP_FRACTION = 0.622  # packing fraction of poured beds of many layers, with the thickness as seen from above, ...
LAYER_FRACTION = 0.12  # ... and what it gains times d/H (d: diameter of equal volume): fitted to beds of spheres, cylinders and
                       # cubes of H = 0.8 to 9.5 cm. It only serves to choose a number, and is within 7 % there
DENSEST = 0.9          # no poured bed comes near it; a container asked to hold more is overfull without doubt


def expectedFraction(thickness: float, volume: float) -> float:
    """Expected packing fraction of a poured bed of `thickness` [m] whose particles have the mean `volume` [m3]."""
    diameter = (6 * volume / math.pi) ** (1 / 3)
    return min(DEEP_FRACTION + LAYER_FRACTION * diameter / thickness, DENSEST)


def particleNumber(thickness: float, shape: ParticleShape, container: Container, solidFraction: float | None = None) -> int:
    """How many particles make a bed of `thickness` [m]: solidFraction * area * thickness / particle volume.

    :param shape: `ParticleShape`; :param container: `Container`
    :param solidFraction: solid volume over bed volume, in (0, 1); by default `expectedFraction`
    """
    thickness = checks.positive('thickness', thickness)
    solidFraction = (expectedFraction(thickness, shape.volume) if solidFraction is None else
                     checks.above('solidFraction', solidFraction, 0, 1))
    return max(1, round(solidFraction * crossSection(container) * thickness / shape.volume))


def checkCapacity(shapes: Sequence[ParticleShape], container: Container, solidFraction: float = DEEP_FRACTION) -> None:
    """ValueError if the particles, packed to `solidFraction`, need more than the container's volume."""
    needed = sum(shape.volume for shape in shapes) / solidFraction
    available = crossSection(container) * container.height
    if needed > available:
        raise ValueError(f'number of particles = {len(shapes)}: overfull container; poured to a solid fraction of '
                         f'{solidFraction:g} they need {needed:.4g} m3, it holds {available:.4g} m3')
