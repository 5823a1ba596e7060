"""The mean of curves that were sampled at different times, with its confidence band."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy
from scipy import stats

if TYPE_CHECKING:
    from ..typealiases import Floats

LEVEL = 0.95
FEWEST = 3  # curves for a band


def meanCurve(records: Sequence[tuple[Floats, Floats]], times: Floats | Sequence[float]) -> tuple[Floats, Floats]:
    """Mean and half width of the 95 % band of records [(times, forces)] at `times`; nan where not all records have values, and the
    half width nan with fewer than FEWEST records."""
    forces = numpy.array([numpy.interp(times, time, force, left=numpy.nan, right=numpy.nan) for time, force in records])
    number, mean = len(records), forces.mean(axis=0)
    if number < FEWEST:
        return mean, numpy.full(len(times), numpy.nan)
    return mean, stats.t.ppf(0.5 + LEVEL / 2, number - 1) * forces.std(axis=0, ddof=1) / numpy.sqrt(number)
