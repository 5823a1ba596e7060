"""Many particles, each broken once by `BreakageEngine`: the sizes of the fragments, as in section 1.2 of Zhao & Chi (2023)."""
from __future__ import annotations

import math
import random
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import BreakableMat, BreakageEngine

from .. import checks

if TYPE_CHECKING:
    from ..typealiases import Floats

NOTHING_MOVES = 1e-30  # time step of the one step in which all break [s]


def uniformSizes(low: float, high: float, number: int, seed: int) -> list[float]:
    """`number` diameters [m], uniform between `low` and `high` [m]."""
    low, high = checks.positive('low', low), checks.positive('high', high)
    if low > high:
        raise ValueError(f'low = {low!r}: above high = {high!r}')
    rng = random.Random(seed)
    return [rng.uniform(low, high) for _ in range(checks.wholeNumber('number', number, 1))]


def breakEach(sizes: Sequence[float], exponent: float, seed: int) -> Floats:
    """Break one sphere of each of these diameters [m] by the cube mode, far from each other; YADE's present scene is dropped.

    :param exponent: p of the cut; :param seed: of the cuts
    :returns: sizes of the fragments [m], an array (len(sizes), 8)
    """
    sizes = [checks.positive('sizes', size) for size in sizes]
    O.reset()
    material = BreakableMat(density=2700)
    side = math.ceil(len(sizes) ** (1 / 3))
    ids = [O.bodies.append(utils.sphere(2 * max(sizes) * Vector3(i % side, i // side % side, i // side ** 2), size / 2, material=material))
           for i, size in enumerate(sizes)]
    engine = BreakageEngine(mode='cube', cutExponent=exponent, seed=seed, forced=ids)
    O.engines, O.dt = [engine], NOTHING_MOVES
    O.step()
    return np.array([[2 * O.bodies[child].shape.radius for child in event['children']] for event in engine.events()])
