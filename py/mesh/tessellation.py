"""Particles as triangles, for pictures, files and meshes."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy
from numpy.typing import NDArray

from .. import checks
from ..typealiases import Floats, Ints


@dataclass(frozen=True)
class Tessellation:
    """A closed convex surface of triangles, in the frame of the body."""
    points: Floats       #: (N, 3) on the surface of the particle [m]
    normals: Floats      #: (N, 3) outward unit normals of the particle's surface at the points
    triangles: Ints      #: (M, 3) indices of points, counterclockwise seen from outside
    error: float         #: upper bound of the largest (Hausdorff) distance between the particle's surface and the triangles [m]


def tessellation(shape: Any, error: float) -> Tessellation:
    """A `Superquadric` or `Sphere` as triangles within the distance `error` [m] of its surface; the arrays cannot be written to.

    Points are close where the curvature is high; a sphere takes about 5 radius/error of them. ValueError for another shape, for an error that is not
    positive and finite, and for one that takes more than a million points.
    """
    from yade.minieigenHP import Vector3  # the class Tessellation needs no YADE
    from yade.wrapper import Sphere, Superquadric
    checks.positive('error', error)
    if isinstance(shape, Sphere):
        shape = Superquadric(extents=Vector3(shape.radius, shape.radius, shape.radius), n1=2, n2=2)
    if not isinstance(shape, Superquadric):
        raise ValueError(f'shape = {shape!r}: must be a Superquadric or a Sphere')
    points, normals, triangles, bound = shape.tessellation(error)
    return Tessellation(_rows(points, float), _rows(normals, float), _rows(triangles, numpy.int32), bound)


def _rows(buffer: bytes, kind: type) -> NDArray[Any]:
    return numpy.frombuffer(buffer, kind).reshape(-1, 3)
