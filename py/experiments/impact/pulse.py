"""The pulse of the force on the base, measured in its record."""
from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

BLOW_THRESHOLD = 0.01        # of the static force: less is no blow, a bed at rest is as uncertain (settling.TRUE_SUPPORT)
PULSE_THRESHOLD = 0.1        # of the peak: the pulse lasts as long as the force is above


class Pulse(NamedTuple):
    """A pulse of the force on the base, what it bore before taken off.

    peak [N] at peakTime [s]; start, end [s]: the time around the peak in which the force is above PULSE_THRESHOLD of
    it without a break; duration = end - start [s]; impulse [N s] between the two; lastTime [s]: when the force was above
    that threshold for the last time, later than `end` if the bed or the impactor bounces. Times count from the record's start.
    """

    peak: float
    peakTime: float
    start: float
    end: float
    duration: float
    impulse: float
    lastTime: float


def pulse(times: Sequence[float], forces: Sequence[float], staticForce: float) -> Pulse:
    """Measure the pulse in a record of `forces` [N] at `times` [s]; `staticForce` [N] is taken off first.

    :raises ValueError: an empty record, one that is no record, or one in which no blow reached the base
    """
    if not times:
        raise ValueError('times = []: nothing was recorded')
    if len(times) != len(forces):
        raise ValueError(f'forces: {len(forces)} of them, but {len(times)} times')
    if not all(map(math.isfinite, (*times, *forces, staticForce))):
        raise ValueError('times, forces, staticForce: must be finite')
    if any(later < time for time, later in zip(times, times[1:])):
        raise ValueError('times: must not fall')
    extra = [force - staticForce for force in forces]
    top = max(range(len(extra)), key=extra.__getitem__)
    if extra[top] <= BLOW_THRESHOLD * abs(staticForce):
        raise ValueError(f'forces: no blow reached the base, it rises by {extra[top]:.3g} N above the static {staticForce:.4g} N '
                         f'within {times[-1] - times[0]:.3g} s; is maxImpactTime too short?')
    threshold = PULSE_THRESHOLD * extra[top]
    first = next((i + 1 for i in range(top - 1, -1, -1) if extra[i] < threshold), 0)
    last = next((i - 1 for i in range(top + 1, len(extra)) if extra[i] < threshold), len(extra) - 1)
    loud = max(i for i in range(len(extra)) if extra[i] >= threshold)
    impulse = sum(0.5 * (extra[i] + extra[i + 1]) * (times[i + 1] - times[i]) for i in range(first, last))
    return Pulse(extra[top], times[top], times[first], times[last], times[last] - times[first], impulse, times[loud])
