"""One moment of a scene, as the arrays that files and pictures are made of."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from .. import checks
from ..files import arrayfile
from ..files.wholefile import ReplacingBytes
from . import bodyarrays

if TYPE_CHECKING:
    from ..scene.container import Container
    from ..typealiases import Floats, PathLike, Rows
    from .snapshot import Snapshot


class SceneSnapshot:
    """One moment.

    :ivar step: O.iter; :ivar time: O.time [s]
    :ivar particles, contacts, container: rows as in `bodyarrays`
    :raises ValueError: other rows, a step or a time that is none
    """

    def __init__(self, particles: Rows, contacts: Rows | None = None, container: Rows | None = None, step: int = 0, time: float = 0.0) -> None:
        self.particles = _rows('particles', particles, 'PARTICLE')
        self.contacts = _rows('contacts', np.zeros(0, bodyarrays.CONTACT) if contacts is None else contacts, 'CONTACT')
        self.container = _rows('container', np.zeros(0, bodyarrays.BORDER) if container is None else container, 'BORDER')
        self.step, self.time = checks.wholeNumber('step', step, 0), checks.finite('time', time)

    @classmethod
    def ofScene(cls, ids: Sequence[int] | None = None) -> Self:
        """The present scene; of the particles only those among the bodies `ids`, and the contacts that they have a part in.

        :raises ValueError: a body that is not in the scene
        """
        from yade import O  # the rest of this module needs no YADE

        from . import scenearrays
        particles, contacts = scenearrays.particles(ids), scenearrays.contacts()
        if ids is not None:
            contacts = contacts[np.isin(contacts['id1'], particles['id']) | np.isin(contacts['id2'], particles['id'])]
        return cls(particles, contacts, scenearrays.container(), O.iter, O.time)

    @classmethod
    def ofSnapshot(cls, snapshot: Snapshot, container: Container | None = None) -> Self:
        """The particles of a `Snapshot`, at rest and without forces, in a `Container`."""
        rows = np.zeros(len(snapshot), bodyarrays.PARTICLE)
        rows['kind'] = bodyarrays.SUPERQUADRIC
        rows['id'], rows['position'] = snapshot.ids, snapshot.positions
        rows['extents'], rows['exponents'] = snapshot.extents, snapshot.exponents
        rows['orientation'] = _quaternions(snapshot.rotations)
        return cls(rows, container=None if container is None else _borders(container))

    def save(self, path: PathLike) -> None:
        """Write it as one .npz, for `load`."""
        with ReplacingBytes(path) as file:
            np.savez(file, particles=self.particles, contacts=self.contacts, container=self.container, step=self.step, time=self.time)

    @classmethod
    def load(cls, path: PathLike) -> Self:
        """The snapshot in the file that `save` wrote.

        :raises ValueError: naming the file, which holds something else
        """
        stored: dict[str, Any] = arrayfile.read(path, ('particles', 'contacts', 'container', 'step', 'time'))
        try:
            return cls(**stored)
        except ValueError as error:
            raise ValueError(f'{path}: damaged ({error})') from None

    def speeds(self) -> Floats:
        """[m/s], (N,)"""
        return np.linalg.norm(self.particles['velocity'], axis=1)

    def normalForces(self) -> Floats:
        """Of the contacts [N], (M,)"""
        return np.linalg.norm(self.contacts['normalForce'], axis=1)

    def largestForces(self) -> Floats:
        """Of the contacts of each particle [N], (N,)"""
        result, ids, forces = np.zeros(len(self.particles)), self.particles['id'], self.normalForces()
        if not len(ids):
            return result
        order = np.argsort(ids)
        for name in ('id1', 'id2'):
            place = order[np.searchsorted(ids, self.contacts[name], sorter=order).clip(max=len(ids) - 1)]
            here = ids[place] == self.contacts[name]
            np.maximum.at(result, place[here], forces[here])
        return result

    def box(self) -> Floats:
        """Lowest and highest corner [m] of a box that holds the particles and what of the container is finite, (2, 3)."""
        half = np.einsum('nij,nj->ni', np.abs(bodyarrays.matrices(self.particles['orientation'])), self.particles['extents'])
        facets = self.container[self.container['kind'] == bodyarrays.FACET]
        cylinders = self.container[self.container['kind'] == bodyarrays.CYLINDER]
        points = np.concatenate([self.particles['position'] - half, self.particles['position'] + half, facets['numbers'].reshape(-1, 3),
                                 *map(_cylinderBox, cylinders)])
        return np.array([points.min(axis=0), points.max(axis=0)]) if len(points) else np.zeros((2, 3))


def _rows(name: str, rows: Any, kind: str) -> Rows:
    if not (isinstance(rows, np.ndarray) and rows.ndim == 1 and rows.dtype == getattr(bodyarrays, kind)):
        raise ValueError(f'{name}: must be rows of bodyarrays.{kind}')
    return rows


def _cylinderBox(cylinder: Any) -> Floats:
    """Corners (4, 3) [m] of the boxes around the two ends of a hollow cylinder; of an endless one around its middle."""
    radius, height = cylinder['numbers'][:2]
    axis = bodyarrays.matrices(cylinder['orientation'])[:, 2]
    across = radius * np.sqrt(np.clip(1 - axis ** 2, 0, 1))
    along = height / 2 * axis if np.isfinite(height) else np.zeros(3)
    return cylinder['position'] + np.array([side * along + edge * across for side in (-1, 1) for edge in (-1, 1)])


def _borders(container: Container) -> Rows:
    """Rows of BORDER for a `Container`."""
    planes = [(container.baseId, 2, 0.0)]
    if container.radius is None:
        planes += [(container.sideIds[2 * axis + place], axis, (place - 0.5) * size)
                   for axis, size in enumerate(container.sides) for place in (0, 1)]
    rows = np.zeros(len(planes) + (container.radius is not None), bodyarrays.BORDER)
    rows['orientation'][:, 3] = 1
    row: Any
    for row, (bodyId, axis, place) in zip(rows, planes):
        row['id'], row['kind'], row['numbers'][0], row['position'][axis] = bodyId, bodyarrays.WALL, axis, place
    if container.radius is not None:
        rows[-1]['id'], rows[-1]['kind'] = container.sideIds[0], bodyarrays.CYLINDER
        rows[-1]['position'][2] = container.height / 2
        rows[-1]['numbers'][:2] = container.radius, container.height
    return rows


def _quaternions(matrices: Floats) -> Floats:
    """Unit quaternions (N, 4) as (x, y, z, w) of rotation matrices (N, 3, 3): the eigenvector of the largest eigenvalue of a symmetric
    4x4 matrix, which needs no case (Bar-Itzhack, J. Guid. Control Dyn. 23, 1085 (2000))."""
    m = np.asarray(matrices, dtype=float).reshape(-1, 3, 3)
    k = np.zeros((len(m), 4, 4))
    k[:, :3, :3] = m + np.transpose(m, (0, 2, 1)) - np.trace(m, axis1=1, axis2=2)[:, None, None] * np.eye(3)
    k[:, :3, 3] = k[:, 3, :3] = np.stack([m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]], axis=1)
    k[:, 3, 3] = np.trace(m, axis1=1, axis2=2)
    return np.linalg.eigh(k)[1][:, :, 3] if len(m) else np.zeros((0, 4))
