"""Curves of force over overlap, as the finite elements give them."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats
    from .hertz import YieldPoint


class Curve(NamedTuple):
    """One path of a case: effective radius [m], hertz.YieldPoint, E* [Pa], and arrays of overlap d [m], force [N], half-width a [m]."""

    name: str
    radius: float
    yieldPoint: YieldPoint
    modulus: float
    overlap: Floats
    force: Floats
    halfWidth: Floats


def forceAt(curve: Curve, overlap: ArrayLike) -> Any:
    """Force of a Curve at other overlaps [N]; between its loads it goes on as a power law."""
    return numpy.exp(numpy.interp(numpy.log(overlap), numpy.log(curve.overlap), numpy.log(curve.force)))
