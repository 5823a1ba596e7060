"""The free fall of the impactor, which is not simulated."""
import math

from ... import checks

CLEARANCE = 5e-4  # m between impactor and the highest particle at the start


def surfaceSpeed(speed: float, height: float, gravity: float = 9.81) -> float:
    """Speed [m/s] at the layer's surface of a sphere that has `speed` [m/s] at `height` [m] above it; `gravity` [m/s2]."""
    return speedAt(0.0, checks.notNegative('speed', speed), checks.notNegative('height', height), checks.positive('gravity', gravity))


def speedAt(height: float, speed: float, dropHeight: float, gravity: float) -> float:
    """Speed [m/s] at `height` [m] above the surface of a sphere that has `speed` [m/s] at `dropHeight` [m] above it.

    :param gravity: [m/s2]
    :raises ValueError: `height` is above the top of its path
    """
    squared = speed ** 2 + 2 * gravity * (dropHeight - height)
    if squared < 0:
        raise ValueError(f'dropHeight = {dropHeight!r}: too low; with speed = {speed!r} m/s there the impactor has never been '
                         f'{height:.4g} m above the surface, where it has to start')
    return math.sqrt(squared)
