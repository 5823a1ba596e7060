"""Statistics of few and scattered runs: means and their differences with Student intervals, trends by rank.

Intervals are two-sided. Runs on different beds are independent: each bed comes from its own seed and packing is chaotic. Runs of several
points on the same beds are not: what the beds have in common drops out of differences that are taken bed by bed. So a sample may be
a pandas Series, whose index says on which bed each value was found; a plain sequence shares its beds with no other.
"""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy
import pandas
from scipy import stats

from ..typealiases import ArrayLike, Floats

LEVEL = 0.95
PERMUTATIONS = 9999
SEED = 20180501      # of the permutations, where values are equal: the same data give the same p values

Sample: TypeAlias = Any  # a sequence or array of values, or a pandas Series, which tells on which bed each was found


class Estimate(NamedTuple):
    """Mean of a sample, arithmetic or geometric, with its interval; low and high are nan for a single value: there is none."""

    mean: float
    low: float
    high: float
    number: int


class Trend(NamedTuple):
    """A monotone trend of y over x: share: of the pairs of runs with different x, those that rise less those that fall, -1 to 1;
    rises, falls: one-sided p values."""

    share: float
    rises: float
    falls: float


class Contrast(NamedTuple):
    """A weighted sum of means: estimate, interval, standard error, degrees of freedom, number of runs.

    Without a scatter to judge by (single runs) low, high, error and dof are nan, and so are all p values.
    """

    estimate: float
    low: float
    high: float
    error: float
    dof: float
    number: int

    def above(self, bound: float = 0.0) -> float:
        """One-sided p value of 'the true sum is at most `bound`': small if it is above."""
        if self.error == 0:
            return 0.0 if self.estimate > bound else 1.0
        return float(stats.t.sf((self.estimate - bound) / self.error, self.dof))

    def below(self, bound: float = 0.0) -> float:
        """One-sided p value of 'the true sum is at least `bound`'."""
        return Contrast(-self.estimate, -self.high, -self.low, self.error, self.dof, self.number).above(-bound)

    def twoSided(self) -> float:
        return min(1.0, 2 * min(self.above(), self.below())) if self.error >= 0 else math.nan


def meanInterval(sample: Sample, level: float = LEVEL) -> Estimate:
    """`Estimate` of a sample (one value at least)."""
    sample = numpy.asarray(sample, dtype=float)
    mean, number = float(sample.mean()), len(sample)
    if number < 2:
        return Estimate(mean, math.nan, math.nan, number)
    reach = float(stats.t.ppf(0.5 + level / 2, number - 1) * sample.std(ddof=1) / math.sqrt(number))
    return Estimate(mean, mean - reach, mean + reach, number)


def typicalValue(sample: Sample) -> Estimate:
    """`Estimate` of a sample as findings compare it: where all values are positive the geometric mean, by the interval of the logarithms'
    mean, for scatter goes with the size; so no interval of theirs reaches zero. Else the mean."""
    if numpy.min(sample) > 0:
        mean, low, high = map(float, numpy.exp(meanInterval(numpy.log(sample))[:3]))
        return Estimate(mean, low, high, len(sample))
    return meanInterval(sample)


def pooledVariance(samples: Sequence[Sample]) -> tuple[float, int]:
    """Variance within samples, taken to be the same in all, and its degrees of freedom (0: no sample has two values)."""
    dof = sum(len(sample) - 1 for sample in samples)
    if dof == 0:
        return math.nan, 0
    return sum(float(((sample - numpy.mean(sample)) ** 2).sum()) for sample in map(numpy.asarray, samples)) / dof, dof


def shareBeds(samples: Sequence[Sample]) -> bool:
    """Whether two of the samples have values from the same bed."""
    beds = [bed for sample in samples if isinstance(sample, pandas.Series) for bed in sample.index]
    return len(set(beds)) < len(beds)


def byBed(samples: Sequence[Sample], weights: Sequence[float]) -> tuple[tuple[Sample, ...], tuple[float, ...]]:
    """(samples, weights) of the same sum in which no two samples share a bed: those that do are one sample, of weighted sums bed by bed.

    Beds that one of them lacks are left out. Samples that share beds in a chain, without a bed common to all, are left as they are.
    """
    clusters: list[list[tuple[Sample, float]]] = []
    for one in zip(samples, weights):
        linked = [cluster for cluster in clusters if any(shareBeds([one[0], other]) for other, _ in cluster)]
        clusters = [cluster for cluster in clusters if not any(cluster is link for link in linked)] + [[*sum(linked, []), one]]
    result: list[tuple[Sample, float]] = []
    for cluster in clusters:
        common = set.intersection(*(set(sample.index) for sample, _ in cluster)) if len(cluster) > 1 else ()
        if common:
            beds = [bed for bed in cluster[0][0].index if bed in common]
            cluster = [(sum(weight * sample[beds] for sample, weight in cluster), 1.0)]
        result += cluster
    return tuple(sample for sample, _ in result), tuple(weight for _, weight in result)


def contrast(samples: Sequence[Sample], weights: Sequence[float], level: float = LEVEL, pool: Sequence[Sample] | None = None) -> Contrast:
    """`Contrast` sum(weights * means of samples); with the weights (1, -1) Welch's t interval of a difference, or that of the paired
    differences if both come from the same beds.

    :param pool: samples from which one common variance is taken, instead of each sample's own (Welch and Satterthwaite); not for
        samples that share beds
    """
    samples, weights = byBed(samples, weights)
    samples = [numpy.asarray(sample, dtype=float) for sample in samples]
    estimate = float(sum(weight * sample.mean() for weight, sample in zip(weights, samples)))
    number = sum(map(len, samples))
    dof: float
    if pool is not None:
        variance, dof = pooledVariance(pool)
        squared = variance * sum(weight ** 2 / len(sample) for weight, sample in zip(weights, samples))
    else:
        squared, dof = _satterthwaite(samples, weights)
    if not dof:
        return Contrast(estimate, math.nan, math.nan, math.nan, math.nan, number)
    error = math.sqrt(squared)
    reach = float(stats.t.ppf(0.5 + level / 2, dof) * error) if error else 0.0
    return Contrast(estimate, estimate - reach, estimate + reach, error, dof, number)


def _satterthwaite(samples: Sequence[Floats], weights: Sequence[float]) -> tuple[float, float]:
    """Variance of the weighted sum of means and its degrees of freedom (0: a sample has a single value)."""
    if min(map(len, samples)) < 2:
        return math.nan, 0
    parts = [weight ** 2 * sample.var(ddof=1) / len(sample) for weight, sample in zip(weights, samples)]
    total = sum(parts)
    if total == 0:
        return 0.0, sum(len(sample) - 1 for sample in samples)
    return total, total ** 2 / sum(part ** 2 / (len(sample) - 1) for part, sample in zip(parts, samples))


def holm(values: ArrayLike) -> Floats:
    """Holm's p values: as small as `values` may be called when all of them are looked at. nan stays nan."""
    found = numpy.asarray(values, dtype=float)
    adjusted, largest = numpy.full(len(found), math.nan), 0.0
    order = [i for i in numpy.argsort(found) if not math.isnan(found[i])]
    for rank, i in enumerate(order):
        largest = max(largest, min(1.0, (len(order) - rank) * found[i]))
        adjusted[i] = largest
    return adjusted


def trend(samples: Mapping[float, Sample], seed: int = SEED) -> Trend:
    """`Trend` of {x: values}: Jonckheere's and Terpstra's test for ordered groups, all arrangements of the runs over the x being alike.

    It needs no scatter within an x, so that single runs at five or more x are enough, and takes no shape of the trend for
    granted. The p values are exact; if values are equal, they come from PERMUTATIONS seeded permutations.
    """
    places = sorted(samples)
    x = numpy.concatenate([numpy.full(len(samples[place]), place, dtype=float) for place in places])
    y = numpy.concatenate([numpy.asarray(samples[place], dtype=float) for place in places])
    lower, upper = numpy.nonzero(x[:, None] < x[None, :])
    if not len(lower):
        return Trend(math.nan, math.nan, math.nan)
    observed = int(numpy.sign(y[upper] - y[lower]).sum())
    if len(set(y)) == len(y):
        ways, falling = _arrangements([len(samples[place]) for place in places]), (len(lower) - observed) // 2
        rises, falls = sum(ways[:falling + 1]) / sum(ways), sum(ways[falling:]) / sum(ways)
    else:
        random = numpy.random.default_rng(seed)
        others = random.permuted(numpy.tile(y, (PERMUTATIONS, 1)), axis=1)
        shuffled = numpy.array([numpy.sign(other[upper] - other[lower]).sum() for other in others])
        rises, falls = ((1 + int(side.sum())) / (1 + PERMUTATIONS) for side in (shuffled >= observed, shuffled <= observed))
    return Trend(observed / len(lower), rises, falls)


def _arrangements(counts: Sequence[int]) -> list[int]:
    """Number of arrangements of different values over groups of `counts`, by the number of pairs that fall from an earlier group
    to a later one: the coefficients of the Gaussian multinomial, prod (1 - q^n) / prod (1 - q^i)."""
    ways, placed = [1], 0
    for count in counts:
        for i in range(1, count + 1):
            placed += 1
            product = ways + [0] * placed
            for k in range(len(product) - 1, placed - 1, -1):
                product[k] -= product[k - placed]
            for k in range(i, len(product)):
                product[k] += product[k - i]
            ways = product[:len(ways) + placed - i]
    return ways


def leastP(samples: Mapping[float, Sample]) -> float:
    """The smallest one-sided p value that `trend` could give: that of the one arrangement in full order."""
    counts = [len(sample) for sample in samples.values()]
    return math.prod(map(math.factorial, counts)) / math.factorial(sum(counts))
