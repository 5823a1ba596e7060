"""How large the fragments of the cube mode are: the exact distribution of Zhao & Chi's cut, and tests against it. Numpy only.

A cut's coordinates are u^p, u uniform on (0, 1). A fragment drawn at random from the eight has along each axis the lower or the upper side, w = u^p
or 1 - u^p with equal chance, and these are independent: its share of the volume is the product of three such w, its size over the parent's the cube
root of that.

The eight fragments of one parent are not independent: they share a cut, and their volumes add up to the parent's. So no test here takes its
significance from Kolmogorov's formula: it is found by simulating (or permuting) whole parents.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import checks

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats, Ints

GRID = 2000   # points of the distribution functions
NODES = 4000  # of the quadrature over u


class CutDistribution:
    """P(size of a fragment over its parent's <= x) for the exponent p; call it with an array of x. Its error is below 1e-4."""

    def __init__(self, exponent: float) -> None:
        self.exponent = checks.positive('exponent', exponent)
        u = (np.arange(NODES) + 0.5) / NODES
        self._sides = np.concatenate([u ** self.exponent, 1 - u ** self.exponent])
        roots = np.linspace(0, 1, GRID)
        areas = self._product(lambda t: self._side(t), roots ** 2)
        shares = self._product(lambda t: np.interp(np.sqrt(np.minimum(t, 1)), roots, areas), roots ** 3)
        self._sizes, self._probabilities = roots, shares

    def __call__(self, x: Any) -> Any:
        return np.interp(x, self._sizes, self._probabilities)

    def massOfParents(self, x: Any, ratios: ArrayLike) -> Any:
        """The part of the mass in fragments whose size over the common length is <= x."""
        middles, steps = (self._sizes[1:] + self._sizes[:-1]) / 2, np.diff(self._probabilities)
        masses = np.concatenate([[0], np.cumsum(8 * middles ** 3 * steps)])
        weights = np.asarray(ratios) ** 3
        return sum(weight * np.interp(np.asarray(x, dtype=float) / ratio, self._sizes, masses)
                   for weight, ratio in zip(weights, np.asarray(ratios))) / weights.sum()

    def _side(self, t: Any) -> Any:
        """P(w <= t) of one side."""
        t = np.minimum(t, 1)
        return (t ** (1 / self.exponent) + 1 - (1 - t) ** (1 / self.exponent)) / 2

    def _product(self, distribution: Callable[[Floats], Floats], values: Any) -> Any:
        """P(w v <= value) at each of `values`, of a side w and a v with that distribution."""
        return np.array([distribution(value / self._sides).mean() for value in values])

    def ofParents(self, x: Any, ratios: ArrayLike) -> Any:
        """The same of sizes over a common length, for parents whose sizes over it are `ratios`: the mean over the parents."""
        return np.mean([self(np.asarray(x) / ratio) for ratio in np.asarray(ratios)], axis=0)


def draw(rng: np.random.Generator, exponent: float, number: int) -> Floats:
    """Sizes of the fragments over their parents', (number, 8), by a numpy generator."""
    cut = rng.random((number, 3)) ** exponent
    sides = np.stack([cut, 1 - cut], axis=2)
    shares = sides[:, 0, :, None, None] * sides[:, 1, None, :, None] * sides[:, 2, None, None, :]
    return np.cbrt(shares.reshape(number, 8))


def distance(values: Floats, function: Callable[[Floats], Floats]) -> float:
    """Kolmogorov's distance: the largest between the values' empirical distribution and a distribution function."""
    ordered = np.sort(np.ravel(values))
    expected = function(ordered)
    steps = np.arange(len(ordered) + 1) / len(ordered)
    return max(float(np.max(expected - steps[:-1])), float(np.max(steps[1:] - expected)))


def agreement(sizes: Floats, exponent: float, parents: ArrayLike, largest: float, seed: int = 0, samples: int = 1000) -> tuple[float, float]:
    """Whether fragments come from the cut: Kolmogorov's distance between all `sizes` (parents, 8) [m] over `largest` [m] and the exact distribution
    for `parents` of those sizes [m], and the part of `samples` simulations of as many parents, eight fragments each, with a distance as large.

    :returns: (distance, p-value)
    """
    ratios = np.asarray(parents) / largest
    x = np.linspace(0, 1, GRID)
    tabled = CutDistribution(exponent).ofParents(x, ratios)

    def exact(values: Floats) -> Floats:
        return np.interp(values, x, tabled)
    found = distance(np.asarray(sizes) / largest, exact)
    rng = np.random.default_rng(seed)
    simulated = [distance(draw(rng, exponent, len(ratios)) * ratios[:, None], exact) for _ in range(samples)]
    return found, float((1 + np.sum(np.array(simulated) >= found)) / (1 + samples))


def sameDistribution(groups: Sequence[Floats], seed: int = 0, samples: int = 500) -> tuple[float, float]:
    """Whether groups of parents have the same distribution of fragments: the largest Kolmogorov distance between a group and all of them together,
    and the part of `samples` random exchanges of whole parents between the groups with one as large.

    :param groups: arrays (parents, 8)
    :returns: (distance, p-value)
    """
    values = np.concatenate([np.asarray(group) for group in groups])
    owners = np.repeat(np.arange(len(groups)), [len(group) for group in groups])
    order = np.argsort(values, axis=None, kind='stable')
    parentOf = np.repeat(np.arange(len(values)), values.shape[1])[order]
    together = np.arange(1, len(order) + 1) / len(order)

    def largest(labels: Ints) -> float:
        own = labels[parentOf]
        return max(float(np.max(np.abs(np.cumsum(own == k) / np.sum(own == k) - together))) for k in range(len(groups)))
    found = largest(owners)
    rng = np.random.default_rng(seed)
    exchanged = [largest(rng.permutation(owners)) for _ in range(samples)]
    return found, float((1 + np.sum(np.array(exchanged) >= found)) / (1 + samples))
