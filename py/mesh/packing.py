"""How much solid is in a part of space: the particles' volumes, those at the border cut exactly."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import checks
from ..measure.snapshot import Snapshot
from .regions import Box, Cylinder, HalfSpaces, Mesh

if TYPE_CHECKING:
    from ..typealiases import Floats

Region = Box | Cylinder | HalfSpaces | Mesh

ACCURACY = 3e-3
EMPTY = 1e-12  # of the whole: volume of what half spaces leave of a region, when that is nothing but rounding


class Measured(NamedTuple):
    """A measured number with bounds: the true one lies in [low, high]."""

    value: float
    low: float
    high: float


def solidVolume(particles: Snapshot | Sequence[int], region: Region, accuracy: float = ACCURACY) -> Measured:
    """Volume of the particles in a region [m3].

    Particles wholly inside count with their closed form. Those at the border are cut, as tessellations that lie in them: the cut volume is at
    least that of the tessellation, and exceeds it at most by what the whole particle has beyond its whole tessellation. Where particles overlap they
    count twice.

    :param particles: `Snapshot`, or ids of bodies (spheres and superquadrics count, others do not)
    :param region: `Box`, `Cylinder`, `HalfSpaces` or `Mesh`
    :param accuracy: largest distance between a cut particle and its tessellation, over its smallest half size
    :returns: `Measured`
    """
    snapshot = particles if isinstance(particles, Snapshot) else Snapshot.ofBodies(particles)
    accuracy = checks.within('accuracy', accuracy, 1e-6, 1)
    low, value, high = _region(region).solidVolumes(_rows(snapshot), accuracy).sum(axis=0)
    return Measured(float(value), float(low), float(high))


def packingFraction(particles: Snapshot | Sequence[int], region: Region, accuracy: float = ACCURACY) -> Measured:
    """Volume of the particles in a region over the region's; parameters as in `solidVolume`.

    :returns: `Measured` [-]
    :raises ValueError: the region is empty
    """
    whole = _region(region).volume
    if whole <= EMPTY * getattr(region, 'within', region).volume:
        raise ValueError(f'region = {region!r}: is empty')
    return Measured(*(volume / whole for volume in solidVolume(particles, region, accuracy)))


def _region(region: Any) -> Region:
    if not isinstance(region, (Box, Cylinder, HalfSpaces, Mesh)):
        raise ValueError(f'region = {region!r}: must be a Box, Cylinder, HalfSpaces or Mesh')
    return region


def _rows(snapshot: Snapshot) -> Floats:
    """(N, 17) as `MeshFunctions` takes them."""
    number = len(snapshot)
    return np.hstack([snapshot.positions.reshape(number, 3), snapshot.rotations.reshape(number, 9), snapshot.extents.reshape(number, 3),
                      snapshot.exponents.reshape(number, 2)]).astype(float)
