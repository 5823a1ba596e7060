"""The rows that bodies and contacts are as numpy arrays, for files and pictures; `scenearrays` gathers them from the scene."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats

SPHERE, SUPERQUADRIC, WALL, CYLINDER, FACET = range(5)  # kinds of shapes

# The rows of pkg/python/BodyArrays.hpp. SI units; vectors along the scene's axes; a quaternion is (x, y, z, w).
PARTICLE = np.dtype([
    ('id', 'i8'), ('kind', 'i8'), ('material', 'i8'), ('contacts', 'i8'), ('extents', 'f8', 3), ('exponents', 'f8', 2), ('position', 'f8', 3),
    ('orientation', 'f8', 4), ('velocity', 'f8', 3), ('angVel', 'f8', 3), ('volume', 'f8'), ('stress', 'f8', (3, 3)), ('octahedralStress', 'f8')])
CONTACT = np.dtype([
    ('id1', 'i8'), ('id2', 'i8'), ('centre1', 'f8', 3), ('centre2', 'f8', 3), ('point', 'f8', 3), ('normalForce', 'f8', 3),
    ('shearForce', 'f8', 3), ('overlap', 'f8')])
BORDER = np.dtype([('id', 'i8'), ('kind', 'i8'), ('position', 'f8', 3), ('orientation', 'f8', 4), ('numbers', 'f8', 9)])


def matrices(quaternions: ArrayLike) -> Floats:
    """Rotation matrices (N, 3, 3) of unit quaternions (N, 4) as (x, y, z, w)."""
    x, y, z, w = np.moveaxis(np.asarray(quaternions, dtype=float), -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))
