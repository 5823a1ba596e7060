"""How a quantity is compared: by ratios where it is positive, and what is said of it."""
from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy

from ..experiments.quantities import inUnit, signed
from ..statistics.samples import Contrast, contrast, shareBeds
from .experiments import QUANTITIES


class Measure:
    """Compares samples of a quantity: its logarithms where all values are positive, for scatter goes with the size, else itself.

    :param y: the quantity; :param samples: all samples of the finding (SI)
    """

    def __init__(self, y: str, samples: Sequence[Any]) -> None:
        self.y = y
        values = numpy.concatenate([numpy.asarray(sample, dtype=float) for sample in samples]) if samples else numpy.empty(0)
        self.log = bool(len(values) and values.min() > 0)
        self.size = float(numpy.abs(values).mean()) if len(values) else math.nan
        self.all, self.shared = [self.of(sample) for sample in samples], shareBeds(samples)

    def of(self, sample: Any) -> Any:
        """The values that are compared."""
        return numpy.log(sample) if self.log else sample

    def contrast(self, samples: Sequence[Any], weights: Sequence[float], pooled: bool = False) -> Contrast:
        """`Contrast` of samples; with the scatter common to all of the finding if asked for, or if a sample is a single run.

        Not so where points share beds: differences on the same beds scatter less than runs do, and some less than others.
        """
        pooled = (pooled or min(map(len, samples)) < 2) and not self.shared
        return contrast([self.of(sample) for sample in samples], weights, pool=self.all if pooled else None)

    def margin(self, share: float) -> float:
        """A relative margin on the scale that is compared."""
        return math.log1p(share) if self.log else share * self.size

    def change(self, value: float) -> str:
        """A difference on the scale that is compared, for readers and without unit: in per cent, or in the quantity's unit."""
        return f'{100 * math.expm1(value):+.1f}' if self.log else signed(QUANTITIES[self.y].factor * value)

    def text(self, difference: Contrast) -> str:
        """A `Contrast` for readers, with its interval: '-12.3 % [-15.6, -8.9]'."""
        size = f'{self.change(difference.estimate)} {"%" if self.log else QUANTITIES[self.y].unit}'.rstrip()
        if not difference.error >= 0:
            return f'{size} (single runs: no interval)'
        return f'{size} [{self.change(difference.low)}, {self.change(difference.high)}]'

    def numbers(self, difference: Contrast) -> dict[str, Any]:
        """A `Contrast` for machines: ratio or difference (SI), its interval, two-sided p."""
        back = math.exp if self.log else float
        values = {'ratio' if self.log else 'difference': back(difference.estimate), 'low': back(difference.low),
                  'high': back(difference.high), 'p': difference.twoSided()}
        return {key: None if math.isnan(value) else value for key, value in values.items()}

    def value(self, sample: Any) -> str:
        """Mean of a sample for readers."""
        return inUnit(QUANTITIES[self.y], float(numpy.mean(sample)))


def pText(p: float) -> str:
    """'p = 0.012' for readers."""
    if p is None or math.isnan(p):
        return 'no p value'
    return f'p = {p:.2g}' if p >= 1e-4 else 'p < 0.0001'
