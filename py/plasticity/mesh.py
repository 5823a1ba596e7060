"""Meshes of one body at its contact: polar about the point of first touch, ever finer towards it, so that discs of contact of all sizes
are resolved alike.

A body fills depth z >= 0 below the contact point (r is the distance from the axis): a sphere's surface is z = R - sqrt(R^2 - r^2), a plate's z = 0.
The rings are at given r on the surface, so that two bodies with the same r have matching nodes there.
"""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy

if TYPE_CHECKING:
    from ..typealiases import Floats


class ElementSizes(NamedTuple):
    """Sizes of elements.

    first: r of the innermost ring [m]; ratio, outerRatio: each ring's width over its r, within and beyond `fineRadius` [m]; sectors:
    number of elements from the axis to the surface.
    """

    first: float
    ratio: float
    outerRatio: float
    fineRadius: float
    sectors: int


REACH = 0.95        # of a sphere's radius, that a body extends to on its surface: nearly the equator
PLATE_REACH = 2.0   # of the sphere's radius


def elementSizes(smallest: float, largest: float, fineness: float = 1.0) -> ElementSizes:
    """Sizes for half-widths between `smallest` and `largest` [m]; the 24 sectors times `fineness`, and rings in proportion."""
    return ElementSizes(first=0.15 * smallest, ratio=0.045 / fineness, outerRatio=0.16 / fineness, fineRadius=2.5 * largest,
                        sectors=max(4, round(24 * fineness)))


def surfaceRadii(elementSizes: ElementSizes, reaches: Iterable[float]) -> dict[float, Floats]:
    """{reach: r of the rings [m], from the first to the reach}; what lies within the smallest reach is shared. Reaches differ by more than a ring."""
    radii, result = [elementSizes.first], {}
    for reach in sorted(reaches):
        while radii[-1] < reach * (1 - elementSizes.outerRatio / 2):
            radii.append(radii[-1] * (1 + (elementSizes.ratio if radii[-1] < elementSizes.fineRadius else elementSizes.outerRatio)))
        radii[-1] = reach
        result[reach] = numpy.array(radii)
    return result


def depth(radius: float, r: Any) -> Any:
    """The depth of a body's surface below its contact point [m]; radius infinity is a plate."""
    if numpy.isinf(radius):
        return numpy.zeros_like(r)
    return r**2 / (radius + numpy.sqrt(radius**2 - r**2))   # without the cancellation of R - sqrt(R^2 - r^2)


def nodes(radius: float, surface: Floats, sectors: int) -> tuple[Floats, Floats]:
    """The corners of all elements: r and z [m], each (rings, sectors + 1), from the axis (first column) to the surface (last)."""
    z = depth(radius, surface)
    distance, polar = numpy.hypot(surface, z), numpy.arctan2(surface, z)
    angles = polar[:, None] * numpy.linspace(0, 1, sectors + 1)
    return distance[:, None] * numpy.sin(angles), distance[:, None] * numpy.cos(angles)
