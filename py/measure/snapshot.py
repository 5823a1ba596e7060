"""Where all particles are, as arrays: what the measures and the pictures work on, independent of the scene."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from ..files import arrayfile
from . import bodyarrays

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats, Ints, PathLike

SHAPES = {'ids': (), 'positions': (3,), 'rotations': (3, 3), 'extents': (3,), 'exponents': (2,)}  # of its arrays, after the number of particles


class Snapshot:
    """Particles at one moment.

    :ivar ids: body ids, (N,); :ivar positions: [m], (N, 3); :ivar rotations: body to scene, (N, 3, 3)
    :ivar extents: half sizes [m], (N, 3); :ivar exponents: (n1, n2), (N, 2)
    """

    ARRAYS = tuple(SHAPES)
    ids: Ints
    positions: Floats
    rotations: Floats
    extents: Floats
    exponents: Floats

    def __init__(self, **arrays: ArrayLike) -> None:
        for name in self.ARRAYS:
            setattr(self, name, np.asarray(arrays[name]))

    def __len__(self) -> int:
        return len(self.ids)

    @classmethod
    def ofBodies(cls, ids: Sequence[int] | None) -> Self:
        """Snapshot of the spheres and superquadrics among the bodies `ids` of the scene, in that order (None: all); in a periodic
        scene inside the cell.

        :raises ValueError: a body that is not in the scene
        """
        from . import scenearrays  # needs YADE, the rest does not
        rows = scenearrays.particles(ids)
        return cls(ids=rows['id'].copy(), positions=rows['position'].copy(), rotations=bodyarrays.matrices(rows['orientation']),
                   extents=rows['extents'].copy(), exponents=rows['exponents'].copy())

    def save(self, path: PathLike) -> None:
        np.savez_compressed(path, **{name: getattr(self, name) for name in self.ARRAYS})

    @classmethod
    def load(cls, path: PathLike) -> Self:
        """The snapshot in the file that `save` wrote.

        :raises ValueError: naming the file, which holds something else
        """
        result = cls(**arrayfile.read(path, cls.ARRAYS))
        if any(getattr(result, name).shape != (len(result.ids), *rest) for name, rest in SHAPES.items()):
            raise ValueError(f'{path}: damaged (its arrays do not have the shapes of a snapshot)')
        return result


def gauge(points: Floats, extents: Floats, exponents: Floats) -> Floats:
    """g = f^(1/n1) of `points` (..., 3) [m] in the particle's own axes: below 1 inside, 1 on the surface."""
    x, y, z = np.moveaxis(np.abs(points) / extents, -1, 0)
    n1, n2 = exponents
    radial = np.maximum(x, y)
    ratio = np.divide(np.minimum(x, y), radial, out=np.zeros_like(radial), where=radial > 0)
    radial = radial * (1 + ratio ** n2) ** (1 / n2)
    largest = np.maximum(radial, z)
    ratio = np.divide(np.minimum(radial, z), largest, out=np.zeros_like(largest), where=largest > 0)
    return largest * (1 + ratio ** n1) ** (1 / n1)


def boxHalfHeights(snapshot: Snapshot) -> Floats:
    """Half extents (N, 3) [m] of boxes along the scene's axes that hold the particles (of their own boxes: they are
    a little too large)."""
    return np.einsum('nij,nj->ni', np.abs(snapshot.rotations), snapshot.extents)


def matrix(orientation: Any) -> list[list[float]]:
    matrix = orientation.toRotationMatrix()
    return [[matrix[i, j] for j in range(3)] for i in range(3)]
