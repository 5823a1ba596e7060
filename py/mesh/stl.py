"""Surfaces of triangles: read from and written to STL files, and put into the scene as containers of facets."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import MeshFunctions

from .. import checks
from ..files.wholefile import ReplacingBytes
from ..measure.snapshot import Snapshot, matrix
from ..scene.bodies import rotation
from .tessellation import tessellation

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats, Ints, PathLike

_STL_HEADER = b'yade-superquadric'.ljust(80)
_STL_TRIANGLE = np.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('attribute', '<u2')])


@dataclass(frozen=True)
class TriangleMesh:
    """Triangles in space; `name` is what errors call it."""
    points: Floats      #: (N, 3) [m]
    triangles: Ints   #: (M, 3) indices of points, counterclockwise seen from where they face
    name: str = 'surface'

    def __post_init__(self) -> None:
        object.__setattr__(self, 'points', table('points', self.points, np.float64))
        object.__setattr__(self, 'triangles', table('triangles', self.triangles, np.int32))

    def check(self, closed: bool = True) -> str:
        """'outward', 'inward' or (without `closed`) 'open': how the triangles face.

        :raises ValueError: says all that is wrong, how often and where first: numbers that are not finite, triangles without an area, edges with one
            triangle only (if it shall be closed) or with more than two, triangles turned over, parts that meet in a single point, triangles that go
            through each other, parts that face opposite ways
        """
        return MeshFunctions.check(self.points, self.triangles, self.name, closed)


def readStl(path: PathLike, scale: float = 1.0, position: Sequence[float] = (0, 0, 0), orientation: Quaternion = Quaternion.Identity) -> TriangleMesh:
    """The triangles of an STL file, ASCII or binary, in space: x = position + orientation * (scale * x of the file).

    :param scale: of the file's unit in metres: 1e-3 where it is millimetres
    :param position: [m]; :param orientation: Quaternion
    :returns: `TriangleMesh`, not checked
    :raises ValueError: for a file that cannot be read, is no STL file or is cut short
    """
    path = checks.path('path', path)
    scale, position, turn = checks.positive('scale', scale), checks.vector('position', position), matrix(rotation(orientation))
    points, triangles = (np.frombuffer(rows, kind).reshape(-1, 3) for rows, kind in zip(MeshFunctions.readStl(path), (float, np.int32)))
    return TriangleMesh(scale * points @ np.transpose(turn) + position, triangles, path)


def stlContainer(path: PathLike, material: Any, closed: bool = True, scale: float = 1.0, position: Sequence[float] = (0, 0, 0),
                 orientation: Quaternion = Quaternion.Identity, wire: bool = True, color: Any = None) -> list[int]:
    """Put the triangles of an STL file into the scene as fixed facets that act as one surface.

    The facets push particles to the side on which their centres are, so it does not matter which way the triangles face, as long as all face alike.

    :param path, scale, position, orientation: as in `readStl`
    :param material: its material
    :param closed: False for a container with an opening: edges with one triangle only are then accepted, all else is checked
    :param wire, color: of the drawing
    :returns: ids of the facets
    :raises ValueError: what is wrong with the surface (`TriangleMesh.check`), before anything is added
    """
    surface = readStl(path, scale, position, orientation)
    surface.check(checks.boolean('closed', closed))
    corners = [Vector3(*point) for point in surface.points]
    triangles: Any = surface.triangles.tolist()
    return O.bodies.append([utils.facet([corners[i] for i in triangle], material=material, wire=wire, color=color, fixed=True)
                            for triangle in triangles])


def writeStl(path: PathLike, surface: TriangleMesh) -> None:
    """Write a `TriangleMesh` as a binary STL file: single precision, seven digits of each coordinate.

    :raises ValueError: coordinates that single precision does not hold, triangles of points that are not there
    """
    corners = _corners(surface)
    triangles = np.zeros(len(corners), dtype=_STL_TRIANGLE)
    triangles['corners'] = corners
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    triangles['normal'] = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(float).tiny)
    with ReplacingBytes(path) as file:
        file.write(_STL_HEADER + np.uint32(len(triangles)).tobytes() + triangles.tobytes())


def _corners(surface: Any) -> Floats:
    """Of the triangles (M, 3, 3) [m], which an STL file can hold."""
    if not isinstance(surface, TriangleMesh):
        raise ValueError(f'surface = {surface!r}: must be a TriangleMesh')
    outside = (surface.triangles < 0) | (surface.triangles >= len(surface.points))
    if outside.any():
        raise ValueError(f'triangles must be indices of points, got {surface.triangles[outside][0]}')
    corners = surface.points[surface.triangles]
    large = np.isfinite(corners) & (np.abs(corners) > np.finfo('f4').max)
    if large.any():
        raise ValueError(f'points must be within single precision, got {float(corners[large][0])!r}')
    return corners


def particlesToStl(path: PathLike, ids: Sequence[int], error: float) -> None:
    """Write the spheres and superquadrics among the bodies `ids` as one STL file: their tessellations within `error` [m], each a closed surface.

    :raises ValueError: none of the bodies is a particle, or as `tessellation`; nothing is written then
    """
    particles = [O.bodies[int(i)] for i in Snapshot.ofBodies(ids).ids]
    if not particles:
        raise ValueError(f'ids = {ids!r}: there is no particle among them')
    points, triangles, before = [], [], 0
    for body in particles:
        own = tessellation(body.shape, error)
        points.append(own.points @ np.transpose(matrix(body.state.ori)) + np.array(body.state.pos))
        triangles.append(own.triangles + before)
        before += len(own.points)
    writeStl(path, TriangleMesh(np.vstack(points), np.vstack(triangles)))


def table(name: str, rows: ArrayLike, kind: type) -> NDArray[Any]:
    """`rows` as an array (N, 3) of the `kind` float64 or int32."""
    try:
        with np.errstate(invalid='ignore'):
            result: NDArray[Any] = np.ascontiguousarray(rows, dtype=kind)
    except (TypeError, ValueError, OverflowError):
        result = np.empty(0)
    if result.ndim != 2 or result.shape[1] != 3:
        raise ValueError(f'{name}: must be rows of three numbers')
    if kind is np.int32 and not np.array_equal(result, np.asarray(rows)):  # 0.9 would become 0
        raise ValueError(f'{name}: must be rows of three whole numbers')
    return result
