"""Whether particles are where they should be: inside their container, below the plate."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..scene.container import Container
    from ..typealiases import Floats
    from .snapshot import Snapshot

LARGEST_PROTRUSION = 0.5  # of a particle's size: with more than that through a wall its centre is outside


def protrusions(snapshot: Snapshot, container: Container, top: float) -> Floats:
    """How far every particle's centre is outside [m]: (N,), negative inside; the largest distance to base, side walls and the plane z = `top` [m].

    :param snapshot: `Snapshot`; :param container: `Container`
    """
    x, y, z = snapshot.positions.T
    if container.radius is not None:
        sideways = np.hypot(x, y) - container.radius
    else:
        width, depth = container.sides
        sideways = np.maximum(np.abs(x) - width / 2, np.abs(y) - depth / 2)
    return np.maximum.reduce([sideways, -z, z - top])


def describe(snapshot: Snapshot, sizes: Floats, container: Container, top: float) -> dict[str, float]:
    """Dict for JSON: how many particles have their centre outside, how many are outside altogether, the deepest overlap with a wall over size [-].

    :param sizes: diameters (N,) of the spheres of their volumes [m]
    """
    outside = protrusions(snapshot, container, top)
    depth = float(np.max(outside / sizes + LARGEST_PROTRUSION))
    return {'centresOutside': int(np.sum(outside > 0)), 'lost': int(np.sum(outside > sizes / 2)), 'deepest': depth}
