"""From which x on does y no longer change? A model in two pieces, fitted to few and scattered runs."""
from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy

from .samples import LEVEL, Sample, pooledVariance

if TYPE_CHECKING:
    from ..typealiases import Floats, Ints

GRID = 160           # places tried for the bend
REPLICATES = 2000
SEED = 20180502
FEWEST = 4           # values of x: the model has three parameters, and its shape is chosen


class Saturation(NamedTuple):
    """A fit: bend: the x from which y is constant, low to high: its interval; shape: of the change before, 'power law' or
    'straight'; plateau: y beyond; misfit: standard deviation of means about the model that the scatter of the runs does not explain;
    replicates: bends of the bootstrap; resolved: whether the interval ends before the largest x."""

    bend: float
    low: float
    high: float
    shape: str
    plateau: float
    misfit: float
    replicates: Floats
    resolved: bool


def fitSaturation(samples: Mapping[float, Sample], seed: int = SEED) -> Saturation | None:
    """Fit y = plateau + slope * change(x) for x < bend, y = plateau beyond, to {x: values of y}; x > 0.

    change is log(bend/x) or (bend - x), whichever fits better: a power law or an exponential if y are logarithms. Means count by
    their number of runs, for the scatter is taken to be the same at all x. The interval is a parametric bootstrap: three to
    five runs are too few to draw from. Each replicate draws scatter about the model, of a variance that is itself drawn (it
    is known from few runs) and contains the misfit, and chooses shape and bend anew.

    :returns: `Saturation`; None with too few x, or without scatter and misfit to judge by
    """
    places = numpy.array(sorted(samples), dtype=float)
    if len(places) < FEWEST or places[0] <= 0:
        return None
    means = numpy.array([numpy.mean(samples[x]) for x in sorted(samples)])
    counts = numpy.array([len(samples[x]) for x in sorted(samples)], dtype=float)
    model = _Model(places, counts)
    best, squares = model.fit(means[None, :])
    fitted = model.values(means, best[0])
    freedom = len(places) - 3
    variance, dof = pooledVariance(list(samples.values()))
    if not dof and freedom < 2:
        return None
    misfit = max(0.0, squares[0] / freedom - (variance if dof else 0.0)) / counts.mean()
    random = numpy.random.default_rng(seed)
    drawn = variance * dof / random.chisquare(dof, REPLICATES) if dof else numpy.zeros(REPLICATES)
    extra = misfit * freedom / random.chisquare(freedom, REPLICATES)
    spread = numpy.sqrt(drawn[:, None] / counts + extra[:, None])
    bends = model.bends(model.fit(fitted + spread * random.standard_normal(spread.shape))[0])
    low, high = numpy.quantile(bends, [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return Saturation(float(model.bends(best)[0]), float(low), float(high), model.shape(best[0]), float(fitted[-1]),
                      math.sqrt(misfit), bends, bool(high < places[-1] * (1 - 1e-9)))


class _Model:
    """All candidates: for each shape and each bend of a grid the matrix that takes means to their weighted residuals."""

    def __init__(self, places: Floats, counts: Floats) -> None:
        self.grid = numpy.geomspace(places[1], places[-1], GRID)
        bend, x = self.grid[:, None], places[None, :]
        changes = numpy.concatenate([numpy.log(numpy.maximum(bend / x, 1)), numpy.maximum(bend - x, 0) / bend])
        designs = numpy.stack([numpy.ones_like(changes), changes], axis=2)
        weighted = designs * numpy.sqrt(counts)[None, :, None]
        self.designs, self.solvers = designs, numpy.linalg.pinv(weighted) * numpy.sqrt(counts)
        self.residuals = numpy.sqrt(counts)[None, :, None] * (numpy.eye(len(places)) - designs @ self.solvers)

    def fit(self, means: Floats) -> tuple[Ints, Floats]:
        """Best candidates for rows of means (B, k), and their weighted sums of squares."""
        squares = numpy.stack([((means @ matrix.T) ** 2).sum(axis=1) for matrix in self.residuals], axis=1)
        best = squares.argmin(axis=1)
        return best, squares[numpy.arange(len(means)), best]

    def bends(self, candidates: Ints) -> Floats:
        return self.grid[candidates % GRID]

    def shape(self, candidate: int) -> str:
        return 'power law' if candidate < GRID else 'straight'

    def values(self, means: Floats, candidate: int) -> Floats:
        """The fitted curve at the places."""
        return self.designs[candidate] @ self.solvers[candidate] @ means
