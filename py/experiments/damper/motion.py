"""What a record of a vibration says: amplitude and phase at the drive's frequency, spectrum, period, as arrays in and numbers out."""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...typealiases import ArrayLike, Floats

RECORD = 'motion.csv'  # of a run
LONGEST = 8          # periods of the drive after which a motion is compared with itself, at most
REPEATS = 0.1        # of the motion's own deviation: what differs less after so many periods is the same motion again
LINES = 8            # of the spectrum that are named
LOWEST_LINE = 0.02   # of the highest one: less is no line


class Motion(NamedTuple):
    """Arrays of one length: time [s] since the drive began; displacements [m] and velocities [m/s] of the box and of the particles' centre of mass,
    along the axis on which the box moves, in the scene's axes: the box from its empty equilibrium, the centre of mass from where it was before the
    drive; mean force of the contacts on the box since the record before [N]."""

    time: Floats
    box: Floats
    boxVelocity: Floats
    centroid: Floats
    centroidVelocity: Floats
    contactForce: Floats


def ofRecorder(recorder: Any, axis: str, startTime: float, restCentroid: Sequence[float]) -> Motion:
    """`Motion` in a `VibrationRecorder`.

    :param axis: 'x', 'y' or 'z'; :param startTime: of the drive [s]; :param restCentroid: centre of mass before it [m], three numbers
    """
    index = 'xyz'.index(axis)

    def component(vectors: Iterable[Sequence[float]]) -> Floats:
        return np.array([vector[index] for vector in vectors])
    return Motion(np.array(recorder.times) - startTime, component(recorder.boxDisplacement), component(recorder.boxVelocity),
                  component(recorder.centroidPosition) - restCentroid[index], component(recorder.centroidVelocity), component(recorder.contactForce))


def lastPeriods(motion: Motion, periods: int, samples: int) -> Motion:
    """The last `periods` of a motion with `samples` records each."""
    return Motion(*(column[-periods * samples:] for column in motion))


def fundamental(times: ArrayLike, values: ArrayLike, frequency: float) -> complex:
    """Complex amplitude A of the part at `frequency` [Hz]: values = Im(A exp(2 pi i frequency times)) + constant + rest, by least squares.

    A response to a force F sin(2 pi frequency t) has the amplitude `abs(A)` and lags behind it by -arg A.
    """
    angles = 2 * math.pi * frequency * np.asarray(times)
    columns = np.stack([np.sin(angles), np.cos(angles), np.ones_like(angles)], axis=1)
    sine, cosine, _ = np.linalg.lstsq(columns, np.asarray(values), rcond=None)[0]
    return complex(sine, cosine)


def phaseLag(amplitude: complex) -> float:
    """By which a complex amplitude lags behind the force, in [0, 360) degrees."""
    return math.degrees(-math.atan2(amplitude.imag, amplitude.real)) % 360


def spectrum(values: ArrayLike, step: float) -> tuple[Floats, Floats]:
    """Frequencies [Hz] and amplitudes of a record over whole periods, its mean taken off; `step` between records [s]."""
    record = np.asarray(values)
    amplitudes = 2 / len(record) * np.abs(np.fft.rfft(record - record.mean()))
    return np.fft.rfftfreq(len(record), step), amplitudes


def lines(frequencies: Floats, amplitudes: Floats) -> list[tuple[float, float]]:
    """(frequency, amplitude) of the highest local maxima of a spectrum, highest first."""
    inner = amplitudes[1:-1]
    tops = 1 + np.flatnonzero((inner >= amplitudes[:-2]) & (inner > amplitudes[2:]) & (inner >= LOWEST_LINE * amplitudes.max()))
    ordered = sorted(tops, key=lambda i: -amplitudes[i])[:LINES]
    return [(float(frequencies[i]), float(amplitudes[i])) for i in ordered]


def harmonicShare(values: ArrayLike, periods: int) -> tuple[float, float]:
    """Part of the variance at multiples of the drive's frequency, in a record of whole `periods`; the first harmonic's part; both [-]."""
    power = spectrum(values, 1.0)[1] ** 2
    total = power.sum()
    return (float(power[periods::periods].sum() / total), float(power[periods] / total)) if total else (0.0, 0.0)


def repetition(values: ArrayLike, samples: int) -> list[float]:
    """By how much the motion differs from itself k periods of the drive later, k = 1, 2, ...: root mean square over that of two
    unrelated parts of it, [-]; of as many k as leave half of the record to compare."""
    record = np.asarray(values)
    unrelated = math.sqrt(2) * record.std()
    longest = min(LONGEST, len(record) // (2 * samples))
    return [float(np.sqrt(np.mean((record[k * samples:] - record[:-k * samples]) ** 2)) / unrelated) if unrelated else 0.0
            for k in range(1, longest + 1)]


def period(differences: Iterable[float]) -> int | None:
    """The smallest number of the drive's periods after which the motion repeats (`repetition`); None: it does not."""
    return next((k for k, difference in enumerate(differences, 1) if difference < REPEATS), None)


def loopFill(values: Floats, velocities: Floats, periods: int) -> float:
    """Area that the motion goes round in its phase plane in a period, over that of the rectangle about it: pi/4 for a sine, 1 for a
    rectangle, [-]; 0 for no motion. Mean over the `periods`."""
    box = np.ptp(values) * np.ptp(velocities)
    turn = np.append(values[1:], values[0]) - np.append(values[-1], values[:-1])
    return float(abs(np.sum(velocities * turn)) / (2 * periods * box)) if box else 0.0


def describe(times: Floats, values: Floats, velocities: Floats, periods: int, samples: int, frequency: float, force: float) -> dict[str, Any]:
    """What is to be known of displacements and velocities over whole `periods` of `samples` records: a dict for JSON. SI units, angles in degrees.

    :param force: amplitude of the driving force [N]; it is sin(2 pi frequency t)
    """
    amplitude, differences = fundamental(times, values, frequency), repetition(values, samples)
    share, first = harmonicShare(values, periods)
    return {'amplitude': abs(amplitude), 'receptance': abs(amplitude) / force, 'phaseLag': phaseLag(amplitude), 'mean': float(np.mean(values)),
            'peakToPeak': float(np.ptp(values)), 'rms': float(np.std(values)), 'harmonicShare': share, 'fundamentalShare': first,
            'period': period(differences), 'repetition': differences, 'loopFill': loopFill(values, velocities, periods),
            'lines': lines(*spectrum(values, float(np.mean(np.diff(times)))))}
