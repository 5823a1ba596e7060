"""Gradings: what a set of particle sizes says. Arrays in, numbers and arrays out; nothing of the scene.

A particle's size d is the diameter of the sphere of its volume. F(d) is the mass finer than d over the whole mass: a step function of the particles'
own sizes, without sieves, so that gaps in the sizes are seen as they are.
"""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from ..typealiases import ArrayLike

FINES = 7.4e-5         # m: Hardin's limit between silt and sand; what is finer does not count as breakable
ULTIMATE_DIMENSION = 2.6  # fractal dimension of the grading that crushing ends in (Einav 2007 takes 2.5 to 2.6)
DECADE_STEP = 0.05     # decades of size over which the steepest part of a grading is looked for
GAP_MASS = 0.002       # of the mass: what an interval of sizes may carry and still count as missing
GAP_TAIL = 0.01        # of the mass at either end of the grading, in which sparse particles are no gaps
FIT_POINTS = 50        # equally spaced in log d
FIT_LOWEST = 1e-3      # of the mass: below, a grading hangs on single particles


class Fractal(NamedTuple):
    """Fractal dimension of a grading's tail (see `fractal`) [-], r^2 of the fit [-], between the sizes low and high [m]."""

    dimension: float
    correlation: float
    low: float
    high: float


class Grading:
    """The grading of particles of the sizes `sizes` (N,) [m]; `masses` (N,): any measure of their amount, by default their volumes."""

    def __init__(self, sizes: ArrayLike, masses: ArrayLike | None = None) -> None:
        sizes = np.asarray(sizes, dtype=float)
        if not len(sizes) or not np.all(sizes > 0):
            raise ValueError('sizes: must be positive, and at least one')
        masses = sizes ** 3 if masses is None else np.asarray(masses, dtype=float)
        if masses.shape != sizes.shape or not np.all(masses > 0):
            raise ValueError('masses: must be positive, one for each size')
        order = np.argsort(sizes, kind='stable')
        self.sizes, self.shares = sizes[order], masses[order] / masses.sum()
        self.sums = np.concatenate([[0.0], np.cumsum(self.shares)])
        self.sums[-1] = 1.0

    def finer(self, sizes: ArrayLike) -> Any:
        """F: share of the mass in particles smaller than `sizes` [m], an array or a number."""
        return self.sums[np.searchsorted(self.sizes, sizes, side='left')]

    def size(self, share: float) -> float:
        """d_p [m]: the smallest size that, with all smaller ones, makes up at least the `share` p of the mass."""
        index = np.searchsorted(self.sums[1:], share * (1 - 1e-12), side='left')
        return float(self.sizes[min(int(index), len(self.sizes) - 1)])

    def meanLog(self, floor: float = 0.0) -> float:
        """Mean of ln d over the mass, sizes below `floor` [m] taken as `floor`."""
        return float(np.sum(self.shares * np.log(np.maximum(self.sizes, floor))))

    def uniformity(self) -> float:
        """Coefficient of uniformity d60/d10 [-]."""
        return self.size(0.6) / self.size(0.1)


def hardin(before: Grading, after: Grading) -> float:
    """Relative breakage B_r = B_t/B_p [-] of Hardin, J. Geotech. Eng. 111(10), 1177-1192 (1985).

    B_p is the area, over log10 d, between the grading before and the vertical at FINES, B_t that between both gradings. With step functions
    the areas are means over the mass: integral (1 - F) d ln d = mean of ln(d/FINES).
    """
    potential = before.meanLog(FINES) - math.log(FINES)
    if potential <= 0:
        raise ValueError(f'before: all particles are below {FINES:g} m; Hardin\'s measure knows no breakage of them')
    return (before.meanLog(FINES) - after.meanLog(FINES)) / potential


def einav(before: Grading, after: Grading, dimension: float = ULTIMATE_DIMENSION) -> float:
    """Breakage B [-] of Einav, J. Mech. Phys. Solids 55, 1274-1297 (2007): the same area as Hardin's B_t, over that between the grading before
    and the ultimate one F_u = (d/d_max)^(3 - dimension), whose mean of ln d is ln d_max - 1/(3 - dimension)."""
    if not dimension < 3:
        raise ValueError(f'dimension = {dimension!r}: must be below 3')
    ultimate = math.log(before.sizes[-1]) - 1 / (3 - dimension)
    return (before.meanLog() - after.meanLog()) / (before.meanLog() - ultimate)


def fractal(grading: Grading, high: float, low: float | None = None) -> Fractal | None:
    """Fractal dimension D of a grading's tail: F ~ d^(3 - D) (Turcotte 1986), by least squares of log F over log d at FIT_POINTS sizes equally
    spaced in log d, from `low` [m] (by default where F reaches FIT_LOWEST) to `high` [m].

    :returns: `Fractal`; None if the grading has no tail of at least a factor of two in size below `high`
    """
    low = grading.size(FIT_LOWEST) * (1 + 1e-9) if low is None else low
    if high < 2 * low:
        return None
    logs = np.linspace(math.log(low), math.log(high), FIT_POINTS)
    finer = grading.finer(np.exp(logs))
    if not np.all(finer > 0):
        return None
    slope, level = np.polyfit(logs, np.log(finer), 1)
    rest, spread = np.log(finer) - slope * logs - level, np.log(finer) - np.log(finer).mean()
    correlation = 1 - float(rest @ rest) / float(spread @ spread) if spread @ spread > 0 else 0.0
    return Fractal(float(3 - slope), correlation, float(low), float(high))


def widestGap(grading: Grading) -> tuple[float, float, float]:
    """The widest interval of sizes that (nearly) no mass has: (factor in size [-], its lower end [m], its upper end [m]).

    Of all intervals with at most GAP_MASS of the mass inside, between the sizes d_p and d_(1-p) of p = GAP_TAIL, the one with the largest ratio of
    ends. A continuous grading of N particles of comparable masses leaves a factor near one; a mode of breakage with fixed sizes leaves the ratio of
    neighbouring sizes. That some mass is allowed makes the measure robust: a lone grain in the middle of a gap does not halve it.
    """
    first, last = (int(np.searchsorted(grading.sums[1:], share, side='left')) for share in (GAP_TAIL, 1 - GAP_TAIL))
    sizes = grading.sizes[first:min(last, len(grading.sizes) - 1) + 1]
    inside = grading.sums[first:first + len(sizes)]  # of mass below each of these sizes
    if len(sizes) < 2:
        return 1.0, float(sizes[0]), float(sizes[0])
    shares = grading.shares[first:first + len(sizes)]
    # From the particle i on, the last j with at most GAP_MASS strictly between the two.
    reach = np.searchsorted(inside, inside + shares + GAP_MASS, side='right') - 1
    ratios = sizes[reach] / sizes
    widest = int(np.argmax(ratios))
    return float(ratios[widest]), float(sizes[widest]), float(sizes[reach[widest]])


def steepestPart(grading: Grading) -> tuple[float, float]:
    """(Largest share of the mass [-] within DECADE_STEP decades of size, where that interval begins [m]): 1 if all are of one size; an
    even grading over k decades has DECADE_STEP/k."""
    ends = np.searchsorted(grading.sizes, grading.sizes * 10 ** DECADE_STEP, side='right')
    masses = grading.sums[ends] - grading.sums[:-1]
    steepest = int(np.argmax(masses))
    return float(masses[steepest]), float(grading.sizes[steepest])
