"""The constants of the plastic law of Li, Gao, Zhang & Liu (2018) from curves of force over half-width

    fN/fy = 1 + G(R/R0) ((a - ay)/ay)^H,    G(r) = m0 + m1 r + m2 r^2

by least squares of the relative error of the force (SciPy). The law in YADE knows the overlap d only and takes a = sqrt(R d); the
constants for it are found with the same a. With the true half-width of the finite elements, as in the paper, they are others.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy
from scipy import optimize, stats

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats, Ints
    from .curves import Curve

REFERENCE_RADIUS = 2.5e-3   # R0 [m], the paper's
WITHIN = 0.1                # of an overlap: a case's last load counts, whose overlap is a few percent larger than its approach
CONSTANTS = ('m0', 'm1', 'm2', 'exponent')


class Points(NamedTuple):
    """Beyond yield, arrays: number of the case, R/R0, w = (a - ay)/ay, fN/fy."""

    case: Floats
    ratio: Floats
    excess: Floats
    force: Floats


class Fit(NamedTuple):
    """constants: m0, m1, m2, exponent by name; intervals: theirs, 95 %, (low, high) by name; rms, largest: relative error of the
    force; correlation: of the errors of neighbouring points of a case."""

    constants: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    rms: float
    largest: float
    correlation: float


def nominalHalfWidth(curve: Curve) -> Floats:
    """a = sqrt(R d) [m], what the law takes."""
    return numpy.sqrt(curve.radius * curve.overlap)


def points(curves: Sequence[Curve], halfWidth: Callable[[Curve], Floats] = nominalHalfWidth, largest: float = numpy.inf) -> Points:
    """Points of the curves.Curves beyond yield up to sqrt(R d) = `largest` R; `halfWidth` gives a [m] of a curve."""
    parts = []
    for i, curve in enumerate(curves):
        excess = halfWidth(curve) / curve.yieldPoint.contactRadius - 1
        beyond = (excess > 0) & (curve.overlap > curve.yieldPoint.overlap) & (curve.overlap <= largest**2 * curve.radius * (1 + WITHIN))
        count = int(beyond.sum())
        parts.append((numpy.full(count, i), numpy.full(count, curve.radius / REFERENCE_RADIUS), excess[beyond],
                      curve.force[beyond] / curve.yieldPoint.force))
    return Points(*(numpy.concatenate(part) for part in zip(*parts)))


def force(constants: ArrayLike, ratio: Any, excess: Any) -> Any:
    """Force over the yield force, fN/fy; `constants` m0, m1, m2, H in this order."""
    m0, m1, m2, exponent = numpy.asarray(constants)
    return 1 + (m0 + ratio * (m1 + ratio * m2)) * excess**exponent


def fit(points: Points, degree: int = 2) -> Fit:
    """Fit the law to Points; `degree` of G, below 2 with the higher m_i zero. Returns a Fit.

    :raises ValueError: fewer points than constants, or effective radii than coefficients of G
    """
    free = [0, 1, 2][:degree + 1] + [3]
    if len(points.force) <= len(free) or len(numpy.unique(numpy.round(points.ratio, 9))) <= degree:
        raise ValueError(f'points = {len(points.force)} at {len(numpy.unique(points.ratio))} effective radii: too few to fit {len(free)} constants')

    def full(values: Floats) -> Floats:
        constants = numpy.zeros(4)
        constants[free] = values
        return constants

    def errors(values: Floats) -> Floats:
        return force(full(values), points.ratio, points.excess) / points.force - 1

    solution = optimize.least_squares(errors, [1.0] + [0.0] * degree + [2.0], x_scale='jac', xtol=1e-13, ftol=1e-13, gtol=1e-13)
    if not solution.success:
        raise ValueError(f'least squares = {solution.message!r}: no constants were found')
    half, correlation = _halfIntervals(solution, points.case)
    constants = full(solution.x)
    halves = full(half)
    return Fit({name: float(value) for name, value in zip(CONSTANTS, constants)},
               {name: (float(value - h), float(value + h)) for name, value, h in zip(CONSTANTS, constants, halves)},
               float(numpy.sqrt(numpy.mean(solution.fun**2))), float(numpy.abs(solution.fun).max()), correlation)


def _halfIntervals(solution: Any, case: Ints) -> tuple[Floats, float]:
    """Half widths of the 95 % intervals, and the correlation rho of neighbouring errors.

    The errors are the power law's departures from smooth curves: neighbours are alike, and n points count as n (1 - rho)/(1 + rho).
    """
    errors, number = solution.fun, len(solution.x)
    neighbours = case[1:] == case[:-1]
    correlation = numpy.sum(errors[1:][neighbours] * errors[:-1][neighbours]) / max(numpy.sum(errors**2), numpy.finfo(float).tiny)
    correlation = float(numpy.clip(correlation, 0, 0.99))
    inflation = (1 + correlation) / (1 - correlation)
    variance = numpy.sum(errors**2) / (len(errors) - number) * inflation
    covariance = variance * numpy.linalg.inv(solution.jac.T @ solution.jac)
    freedom = max(1.0, len(errors) / inflation - number)
    return stats.t.ppf(0.975, freedom) * numpy.sqrt(numpy.diag(covariance)), correlation


def collapse(points: Points) -> float:
    """How far the cases' curves lie apart: rms of the relative differences of fN/fy from the mean over the cases, at the same w."""
    cases = numpy.unique(points.case)
    low = max(points.excess[points.case == i].min() for i in cases)
    high = min(points.excess[points.case == i].max() for i in cases)
    grid = numpy.geomspace(low, high, 50)
    forces = numpy.array([numpy.interp(numpy.log(grid), numpy.log(points.excess[points.case == i]), points.force[points.case == i]) for i in cases])
    return float(numpy.sqrt(numpy.mean((forces / forces.mean(0) - 1)**2)))
