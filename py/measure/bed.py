"""Measures of a bed from its geometry: thickness, packing fraction. Both are read from the particles cut into voxels."""
from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import checks
from ..scene.container import Container, crossSection
from ..scene.shapes import unitVolume
from .snapshot import Snapshot, boxHalfHeights, gauge

if TYPE_CHECKING:
    from ..typealiases import Bools, Floats
    from .snapshot import Snapshot

MOST_VOXELS = 2e8  # a byte each


def voxelGrid(snapshot: Snapshot, container: Container, voxel: float) -> tuple[Bools, list[Floats]]:
    """Which voxels have their centre inside a particle.

    :param container: `Container`; the grid covers its base and reaches up to the highest particle
    :param voxel: edge length [m]
    :returns: bool (nx, ny, nz); centres along x and y (nx,), (ny,) and z (nz,) [m]
    :raises ValueError: more than MOST_VOXELS
    """
    voxel = checks.positive('voxel', voxel)
    half = _halfSizes(container)
    top = float((snapshot.positions + boxHalfHeights(snapshot))[:, 2].max())
    counts = [max(1, math.ceil(2 * h / voxel)) for h in half] + [max(1, math.ceil(top / voxel))]
    if math.prod(counts) > MOST_VOXELS:
        raise ValueError(f'voxel = {voxel!r}: too small, the grid would have {math.prod(counts):.3g} voxels '
                         f'(at most {MOST_VOXELS:g})')
    origin = np.array([-counts[0] * voxel / 2, -counts[1] * voxel / 2, 0.0])
    centers = [origin[i] + voxel * (np.arange(counts[i]) + 0.5) for i in range(3)]
    filled = np.zeros(counts, dtype=bool)
    for i, reach in enumerate(boxHalfHeights(snapshot)):
        _fill(filled, centers, origin, voxel, snapshot, i, reach)
    return filled, centers


def _fill(filled: Bools, centers: Sequence[Floats], origin: Floats, voxel: float, snapshot: Snapshot, i: int, reach: Floats) -> None:
    position = snapshot.positions[i]
    first = np.maximum(np.floor((position - reach - origin) / voxel).astype(int), 0)
    last = np.minimum(np.ceil((position + reach - origin) / voxel).astype(int), filled.shape)
    if np.any(first >= last):
        return
    box = tuple(slice(a, b) for a, b in zip(first, last))
    offsets = np.stack(np.meshgrid(*(centers[k][box[k]] - position[k] for k in range(3)), indexing='ij'), axis=-1)
    local = offsets @ snapshot.rotations[i]
    filled[box] |= gauge(local, snapshot.extents[i], snapshot.exponents[i]) <= 1


def measureBed(snapshot: Snapshot, container: Container, voxel: float | None = None) -> dict[str, Any]:
    """Thickness and packing fraction of a bed at rest.

    thickness [m]: mean, over all voxel columns within the container, of the height of the highest solid voxel (a
    column that meets no particle counts 0). It is the mean level of the surface as seen from above.
    packingFraction: solid volume (the particles', exact) over cross section times thickness. This is C0.
    innerPackingFraction: solid voxels over voxels in the part that is at least one particle diameter (of equal
    volume) from the side wall, one radius above the base and one radius below the thickness; None if
    nothing is left there.

    :param voxel: edge length [m]; by default a tenth of the mean particle's radius of equal volume
    :returns: dict of the three and `voxel`
    :raises ValueError: no particles, or a voxel so small that the grid would not fit into memory, or so large that it meets none
    """
    if not len(snapshot):
        raise ValueError('snapshot: no particles, so there is no bed to measure')
    volumes = particleVolumes(snapshot)
    radius = float(np.mean(volumes) * 3 / (4 * math.pi)) ** (1 / 3)
    voxel = radius / 10 if voxel is None else voxel
    filled, centers = voxelGrid(snapshot, container, voxel)
    columns = _columnsInside(container, centers, 0.0)
    levels = np.where(filled.any(axis=2), voxel * (filled.shape[2] - filled[:, :, ::-1].argmax(axis=2)), 0.0)
    thickness = float(levels[columns].mean()) if columns.any() else 0.0
    if not thickness > 0:
        raise ValueError(f'voxel = {voxel!r}: too coarse, no voxel in the container has its centre in a particle')
    area = crossSection(container)
    middle = (centers[2] > radius) & (centers[2] < thickness - radius)
    inner = filled[_columnsInside(container, centers, 2 * radius)][:, middle]
    return {'thickness': thickness, 'packingFraction': float(volumes.sum()) / (area * thickness),
            'innerPackingFraction': float(inner.mean()) if inner.size else None, 'voxel': float(voxel)}


def particleVolumes(snapshot: Snapshot) -> Floats:
    """Exact volumes (N,) [m3]."""
    units = {tuple(pair): unitVolume(*pair) for pair in np.unique(snapshot.exponents, axis=0)}
    return snapshot.extents.prod(axis=1) * np.array([units[tuple(pair)] for pair in snapshot.exponents])


def _halfSizes(container: Container) -> tuple[float, float]:
    if container.radius is not None:
        return container.radius, container.radius
    width, depth = container.sides
    return width / 2, depth / 2


def _columnsInside(container: Container, centers: Sequence[Floats], margin: float) -> Bools:
    x, y = np.meshgrid(centers[0], centers[1], indexing='ij')
    if container.radius is not None:
        return np.hypot(x, y) <= container.radius - margin
    width, depth = container.sides
    return (np.abs(x) <= width / 2 - margin) & (np.abs(y) <= depth / 2 - margin)
