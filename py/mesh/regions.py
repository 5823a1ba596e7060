"""Parts of space in which solid is measured (packing.py): boxes, cylinders, what half spaces cut out, what a closed surface encloses."""
from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from yade.wrapper import MeshFunctions

from .. import checks
from .stl import TriangleMesh, readStl, table

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Bools, Floats, PathLike

# Corners are numbered by the bits x, y, z; triangles face outward.
BOX_TRIANGLES = np.array([(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7),
                           (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)], dtype=np.int32)
ALL = np.zeros((0, 4))  # no half spaces: all of space
SIDES = 100000          # of the prisms about a cylinder, at most: each particle is held against all of them


@dataclass(frozen=True)
class Box:
    """The box between the corners `low` and `high` (x, y, z) [m], along the axes."""
    low: tuple[float, ...]
    high: tuple[float, ...]

    def __post_init__(self) -> None:
        low, high = checks.vector('low', self.low), checks.vector('high', self.high)
        if not all(a < b for a, b in zip(low, high)):
            raise ValueError(f'high = {self.high!r}: must lie above low = {self.low!r} in each coordinate')
        object.__setattr__(self, 'low', low)
        object.__setattr__(self, 'high', high)

    @property
    def volume(self) -> float:
        """[m3]"""
        return math.prod(b - a for a, b in zip(self.low, self.high))

    def halfSpaces(self) -> Floats:
        """(6, 4): rows (nx, ny, nz, d) of n.x <= d."""
        unit = np.eye(3)
        return np.vstack([np.column_stack([unit, self.high]), np.column_stack([-unit, np.negative(self.low)])])

    def volumeCut(self, halfSpaces: Floats) -> float:
        """Volume [m3] of what lies in the `halfSpaces` (K, 4), too."""
        corners = np.array([[(self.low, self.high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)])
        return MeshFunctions.volume(corners, BOX_TRIANGLES, halfSpaces)

    def solidVolumes(self, particles: Floats, accuracy: float, halfSpaces: Floats = ALL) -> Floats:
        """Bounds and estimates (N, 3) of the particles' volumes inside [m3]; `particles` (N, 17) and `halfSpaces` (K, 4) as in `MeshFunctions`."""
        return _inHalfSpaces(particles, accuracy, np.vstack([self.halfSpaces(), halfSpaces]))


@dataclass(frozen=True)
class Cylinder:
    """The cylinder of `radius` [m] round the axis from the point `base` to the point `top` [m].

    Solid in it has bounds by an inscribed and a circumscribed prism, closer to it than particles are to their tessellations; the estimate is
    that of a prism of the same cross section.
    """
    radius: float
    base: tuple[float, ...]
    top: tuple[float, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, 'radius', checks.positive('radius', self.radius))
        for name in ('base', 'top'):
            object.__setattr__(self, name, checks.vector(name, getattr(self, name)))
        if self.base == self.top:
            raise ValueError(f'top = {self.top!r}: must differ from base')

    @property
    def volume(self) -> float:
        """[m3]"""
        return math.pi * self.radius ** 2 * math.dist(self.base, self.top)

    def solidVolumes(self, particles: Floats, accuracy: float) -> Floats:
        """As `Box.solidVolumes`."""
        if not len(particles):
            return np.zeros((0, 3))
        sides = self._sides(accuracy * particles[:, 12:15].min())
        half = math.pi / sides
        inner, alike, outer = (_inHalfSpaces(particles, accuracy, self._prism(sides, apothem * self.radius))
                               for apothem in (math.cos(half), math.sqrt(half / math.tan(half)), 1.0))
        low, high = np.minimum(inner[:, 0], outer[:, 2]), outer[:, 2]  # of a cylinder much thinner than particles only rounding is left
        return np.column_stack([low, np.clip(alike[:, 1], low, high), high])

    def _sides(self, distance: float) -> int:
        """Of a prism that lies within the distance [m] of the cylinder; no more than SIDES, the bounds are farther apart then."""
        angle = math.acos(max(0.0, 1 - distance / self.radius))
        return SIDES if angle * SIDES < math.pi else max(4, math.ceil(math.pi / angle))

    def _prism(self, sides: int, apothem: float) -> Floats:
        """Half spaces of a regular prism about the axis."""
        base, top = np.array(self.base), np.array(self.top)
        axis = (top - base) / np.linalg.norm(top - base)
        across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
        across /= np.linalg.norm(across)
        angles = 2 * math.pi * np.arange(sides) / sides
        normals = np.outer(np.cos(angles), across) + np.outer(np.sin(angles), np.cross(axis, across))
        return np.vstack([np.column_stack([normals, normals @ base + apothem]), [*axis, axis @ top], [*-axis, -axis @ base]])


@dataclass(frozen=True)
class Mesh:
    """What a closed `TriangleMesh` encloses, convex or not, whichever way it faces. ValueError for one that bounds nothing (docs/meshes.md)."""
    surface: TriangleMesh
    volume: float = field(init=False)  #: [m3]

    def __post_init__(self) -> None:
        if not isinstance(self.surface, TriangleMesh):
            raise ValueError(f'surface = {self.surface!r}: must be a TriangleMesh')
        self.surface.check(closed=True)
        if np.abs(self.surface.points).max() > checks.LARGEST:
            raise ValueError(f'surface: {self.surface.name}: points must not be above {checks.LARGEST:g} m in size')
        object.__setattr__(self, 'volume', self.volumeCut(ALL))

    @classmethod
    def ofStl(cls, path: PathLike, **placing: Any) -> Self:
        """Of an STL file; `placing` as in `readStl`."""
        return cls(readStl(path, **placing))

    def volumeCut(self, halfSpaces: Floats) -> float:
        """As `Box.volumeCut`."""
        return abs(MeshFunctions.volume(self.surface.points, self.surface.triangles, halfSpaces))

    def contains(self, points: ArrayLike) -> Bools:
        """Which of the `points` (N, 3) [m] are inside, (N,) bool."""
        questions = table('points', points if np.size(points) else np.zeros((0, 3)), np.float64)
        return np.frombuffer(MeshFunctions.contained(self.surface.points, self.surface.triangles, self.surface.name, questions), dtype=bool)

    def solidVolumes(self, particles: Floats, accuracy: float, halfSpaces: Floats = ALL) -> Floats:
        """As `Box.solidVolumes`."""
        return _rows(MeshFunctions.volumesInMesh(np.ascontiguousarray(particles), accuracy, self.surface.points, self.surface.triangles,
                                                 self.surface.name, halfSpaces))


@dataclass(frozen=True)
class HalfSpaces:
    """What lies `within` a `Box` or a `Mesh` and in all of the half spaces n.x <= d.

    `planes` are pairs (n, d) of a normal and a distance [m]; n is normalised.
    """
    planes: tuple[Any, ...]
    within: Box | Mesh

    def __post_init__(self) -> None:
        if not isinstance(self.within, (Box, Mesh)):
            raise ValueError(f'within = {self.within!r}: must be a Box or a Mesh')
        object.__setattr__(self, 'planes', tuple(_plane(i, plane) for i, plane in enumerate(_sequence(self.planes))))

    @property
    def volume(self) -> float:
        """[m3]"""
        return self.within.volumeCut(self._rows())

    def solidVolumes(self, particles: Floats, accuracy: float) -> Floats:
        """As `Box.solidVolumes`."""
        return self.within.solidVolumes(particles, accuracy, self._rows())

    def _rows(self) -> Floats:
        return np.array([(*normal, distance) for normal, distance in self.planes]).reshape(-1, 4)


def _sequence(planes: Any) -> Iterable[Any]:
    if isinstance(planes, (str, bytes)) or not isinstance(planes, Iterable):
        raise ValueError(f'planes = {planes!r}: must be pairs of a normal and a distance')
    return planes


def _plane(i: int, plane: Any) -> tuple[tuple[float, ...], float]:
    try:
        if isinstance(plane, (str, bytes)):
            raise TypeError
        normal, distance = plane
    except (TypeError, ValueError):
        raise ValueError(f'planes[{i}] = {plane!r}: must be a normal and a distance') from None
    normal = checks.vector(f'planes[{i}] normal', normal)
    length = math.hypot(*normal)
    if length < 1 / checks.LARGEST:
        raise ValueError(f'planes[{i}] normal = {normal!r}: must not be zero, at least {1 / checks.LARGEST:g} long')
    return tuple(x / length for x in normal), checks.finite(f'planes[{i}] distance', distance)


def _inHalfSpaces(particles: Floats, accuracy: float, halfSpaces: Floats) -> Floats:
    return _rows(MeshFunctions.volumesInHalfSpaces(np.ascontiguousarray(particles), accuracy, np.ascontiguousarray(halfSpaces)))


def _rows(volumes: bytes) -> Floats:
    return np.frombuffer(volumes).reshape(-1, 3)
