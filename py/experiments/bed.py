"""Parameters of how a bed of particles comes about."""
from __future__ import annotations

from dataclasses import dataclass

from .. import checks
from ..runs.parameters import Parameters, between, count, parameter


@dataclass(frozen=True, kw_only=True)
class Bed(Parameters):
    """Particles fall into a container and come to rest."""

    TITLE = 'bed'

    gravity: float = parameter(9.81, checks.positive, 'acceleration of gravity, along -z', 'm/s2')
    maxSettlingTime: float = parameter(2.0, checks.positive, 'simulated time after which the particles count as settled in any case', 's')
    timeStepFraction: float = parameter(0.3, between(0, 1 + 1e-12), 'time step over the critical one (the Rayleigh time step of the smallest '
                                        'particle), at most')
    seed: int = parameter(1, count(0), 'seed of positions, orientations and sizes')
