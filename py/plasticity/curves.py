"""Curves of force over overlap, as the finite elements give them."""
from collections import namedtuple

import numpy

Curve = namedtuple('Curve', 'name radius yieldPoint modulus overlap force halfWidth')
Curve.__doc__ = """One path of a case: effective radius [m], hertz.YieldPoint, E* [Pa], and arrays of overlap d [m], force [N], half-width a [m]."""


def forceAt(curve, overlap):
    """Force of a Curve at other overlaps [N]; between its loads it goes on as a power law."""
    return numpy.exp(numpy.interp(numpy.log(overlap), numpy.log(curve.overlap), numpy.log(curve.force)))
