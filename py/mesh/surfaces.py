"""Surfaces of particles and containers as triangles: what is drawn and written to files."""
from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..measure import bodyarrays
from .tessellation import Tessellation, tessellation

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats, Ints, Rows

DETAIL = 0.02    # default of the largest distance between a particle's surface and its triangles, over its largest half size
CIRCLE = 96      # corners of a hollow cylinder's section
MARGIN = 0.05    # by which a plane reaches beyond what it bounds, over that box's diagonal

UPRIGHT = 1 - 1e-9  # cosine of an axis with another, above which they are the same to rounding


class BodySurfaces(NamedTuple):
    """The surfaces of many bodies as triangles, for drawing: points [m], unit normals (N, 3), triangles (M, 3) as places
    of points, owner (N,): whose row a point belongs to."""

    points: Floats
    normals: Floats
    triangles: Ints
    owner: Ints


@lru_cache(maxsize=64)
def _unit(n1: float, n2: float, detail: float) -> Tessellation:
    """The tessellation of the superquadric with half sizes 1 [m]: all of the same exponents are this one, stretched."""
    from yade.wrapper import Superquadric  # surfaces of containers need no YADE
    return tessellation(Superquadric(extents=(1, 1, 1), n1=n1, n2=n2), detail)


def particleSurfaces(particles: Rows, detail: ArrayLike = DETAIL) -> BodySurfaces:
    """`BodySurfaces` of all `particles` (rows of PARTICLE): one tessellation for each pair of exponents, stretched, turned and moved.

    :param detail: largest distance between the surface and the triangles, over the particle's largest half size; for all, or (N,)
    """
    parts, first = [], 0
    looks = np.column_stack([particles['exponents'], np.broadcast_to(detail, len(particles))])
    different, kinds = np.unique(looks, axis=0, return_inverse=True)
    for kind, look in enumerate(different):
        unit, rows = _unit(*map(float, look)), np.flatnonzero(kinds.ravel() == kind)
        parts.append(_instances(unit, particles[rows], rows, first))
        first += len(rows) * len(unit.points)
    return _joined(parts)


def _instances(unit: Tessellation, particles: Rows, rows: Ints, first: int) -> BodySurfaces:
    """`BodySurfaces` of the particles that are all the unit shape stretched; numbers of their points begin with `first`."""
    turns, number = bodyarrays.matrices(particles['orientation']), len(unit.points)
    points = (unit.points[None] * particles['extents'][:, None]) @ np.swapaxes(turns, 1, 2) + particles['position'][:, None]
    normals = (unit.normals[None] / particles['extents'][:, None])  # a gradient: it stretches the other way
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    triangles = unit.triangles[None] + (first + number * np.arange(len(rows)))[:, None, None]
    return BodySurfaces(points.reshape(-1, 3), (normals @ np.swapaxes(turns, 1, 2)).reshape(-1, 3), triangles.reshape(-1, 3), np.repeat(rows, number))


def _joined(parts: Sequence[BodySurfaces]) -> BodySurfaces:
    empty = BodySurfaces(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros((0, 3), dtype=int), np.zeros(0, dtype=int))
    return BodySurfaces(*map(np.concatenate, zip(empty, *parts)))


def containerSurfaces(container: Rows, box: Floats) -> BodySurfaces:
    """`BodySurfaces` of the `container` (rows of BORDER), triangles seen from both sides. Planes end where they meet others, or with a
    hollow cylinder that stands on them, or a little beyond the `box` (2, 3) [m]; cylinders without end reach as far as the box.
    """
    parts, first = [], 0
    cylinders, edges = container[container['kind'] == bodyarrays.CYLINDER], _edges(container, box)
    for row in np.flatnonzero(container['kind'] != bodyarrays.FACET):
        border = container[row]
        points, normals, triangles = _cylinder(border, box) if border['kind'] == bodyarrays.CYLINDER else _plane(border, cylinders, edges)
        parts.append(BodySurfaces(points, normals, triangles + first, np.full(len(points), row)))
        first += len(points)
    rows = np.flatnonzero(container['kind'] == bodyarrays.FACET)
    vertices = container['numbers'][rows].reshape(-1, 3, 3)
    across = np.cross(vertices[:, 1] - vertices[:, 0], vertices[:, 2] - vertices[:, 0])
    normals = np.repeat(across / np.linalg.norm(across, axis=1, keepdims=True), 3, axis=0)
    parts.append(BodySurfaces(vertices.reshape(-1, 3), normals, first + np.arange(3 * len(rows)).reshape(-1, 3), np.repeat(rows, 3)))
    return _joined(parts)


def _circle() -> Floats:
    angles = np.linspace(0, 2 * np.pi, CIRCLE, endpoint=False)
    return np.stack([np.cos(angles), np.sin(angles), np.zeros(CIRCLE)], axis=1)


def _cylinder(border: Any, box: Floats) -> tuple[Floats, Floats, Ints]:
    turn, (radius, height) = bodyarrays.matrices(border['orientation']), border['numbers'][:2]
    along = (np.array(np.meshgrid(*np.transpose(box))).reshape(3, -1).T - border['position']) @ turn[:, 2]
    ends = (-height / 2, height / 2) if np.isfinite(height) else (along.min(), along.max())
    ring = _circle()
    points = np.concatenate([radius * ring + (0, 0, end) for end in ends]) @ turn.T + border['position']
    here = np.arange(CIRCLE)
    beside = (here + 1) % CIRCLE
    triangles = np.concatenate([np.stack([here, beside, beside + CIRCLE], axis=1), np.stack([here, beside + CIRCLE, here + CIRCLE], axis=1)])
    return points, np.tile(-ring @ turn.T, (2, 1)), triangles


def _edges(container: Rows, box: Floats) -> tuple[Floats, Floats]:
    """Where planes end, lowest and highest corner (2, 3) [m]: at other planes around the middle of the box, else a little beyond the box."""
    low, high = np.array(box) + MARGIN * np.linalg.norm(box[1] - box[0]) * np.array([[-1], [1]])
    middle = np.mean(box, axis=0)
    for wall in container[container['kind'] == bodyarrays.WALL]:
        axis = int(wall['numbers'][0])
        place = wall['position'][axis]
        if place < middle[axis]:
            low[axis] = max(low[axis], place)
        else:
            high[axis] = min(high[axis], place)
    return low, high


def _plane(border: Any, cylinders: Rows, edges: tuple[Floats, Floats]) -> tuple[Floats, Floats, Ints]:
    axis, place = int(border['numbers'][0]), border['position']
    normal = np.eye(3)[axis]
    for cylinder in cylinders:
        if abs(bodyarrays.matrices(cylinder['orientation'])[axis, 2]) > UPRIGHT:  # it stands on the plane
            points = cylinder['numbers'][0] * np.roll(_circle(), axis + 1, axis=1) + cylinder['position']
            points[:, axis] = place[axis]
            corners = np.arange(1, CIRCLE - 1)
            return points, np.tile(normal, (CIRCLE, 1)), np.stack([np.zeros_like(corners), corners, corners + 1], axis=1)
    low, high = edges
    one, other = (axis + 1) % 3, (axis + 2) % 3
    points = np.tile(place, (4, 1))
    points[:, one], points[:, other] = [low[one], high[one], high[one], low[one]], [low[other], low[other], high[other], high[other]]
    return points, np.tile(normal, (4, 1)), np.array([(0, 1, 2), (0, 2, 3)])
