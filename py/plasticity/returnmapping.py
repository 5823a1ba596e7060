"""Rate-independent plasticity of von Mises with isotropic hardening, small strain: the radial return of Simo & Hughes, Computational
Inelasticity (1998), section 3.3, for all integration points at once.

Strain and stress in axisymmetry are rows of four: rr, zz, tt (hoop), rz; the shear strain is twice the tensor's component.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy

if TYPE_CHECKING:
    from ..typealiases import ArrayLike, Floats

TRACE = numpy.array([1.0, 1.0, 1.0, 0.0])
DEVIATOR = numpy.diag([1, 1, 1, 0.5]) - numpy.outer(TRACE, TRACE) / 3   # from strain to deviatoric stress/(2 G)
STRAIN_OF_FLOW = numpy.array([1.0, 1.0, 1.0, 2.0])                      # from tensor components to a strain row


class State(NamedTuple):
    """Plastic strain, rows of four, and equivalent plastic strain, one a point."""

    plasticStrain: Floats
    hardening: Floats


class Material:
    """Elastic constants and the curve of true stress over plastic strain.

    :param stressStrain: rows (plastic strain, true stress [Pa]), straight in between, constant after the last; None: never yields
    """

    def __init__(self, young: float, poisson: float, stressStrain: ArrayLike | None = None) -> None:
        self.shear = young / (2 * (1 + poisson))
        self.elasticity = young / (3 * (1 - 2 * poisson)) * numpy.outer(TRACE, TRACE) + 2 * self.shear * DEVIATOR
        self._curve = None
        if stressStrain is not None:
            strain, stress = numpy.array(stressStrain, dtype=float).T
            self._curve = numpy.append(strain, 1e3 * max(1, strain[-1])), numpy.append(stress, stress[-1])

    def virgin(self, points: int) -> State:
        """The State of `points` integration points that never yielded."""
        return State(numpy.zeros((points, 4)), numpy.zeros(points))

    def respond(self, strain: Floats, state: State) -> tuple[Floats, Floats, State]:
        """Stress [Pa] (n, 4), its derivative by the strain [Pa] (n, 4, 4) and the new State, coming from `state` to `strain` (n, 4)."""
        trial = (strain - state.plasticStrain) @ self.elasticity
        tangent = numpy.tile(self.elasticity, (len(strain), 1, 1))
        if self._curve is None:
            return trial, tangent, state
        deviator = trial - trial @ TRACE[:, None] / 3 * TRACE
        mises = numpy.sqrt(1.5 * (deviator**2 @ STRAIN_OF_FLOW))
        hardening, slope = self._hardened(mises, state.hardening)
        flowing = numpy.nonzero(hardening > state.hardening)[0]
        step, mises, slope = (hardening - state.hardening)[flowing], mises[flowing], slope[flowing]
        normal = 1.5 * deviator[flowing] / mises[:, None]
        stress, plasticStrain = trial.copy(), state.plasticStrain.copy()
        stress[flowing] -= 2 * self.shear * step[:, None] * normal
        plasticStrain[flowing] += step[:, None] * normal * STRAIN_OF_FLOW
        inner = 4 * self.shear**2 * (step / mises - 1 / (3 * self.shear + slope))
        tangent[flowing] += (inner[:, None, None] * normal[:, :, None] * normal[:, None, :]
                             - (6 * self.shear**2 * step / mises)[:, None, None] * DEVIATOR)
        return stress, tangent, State(plasticStrain, hardening)

    def _hardened(self, mises: Floats, before: Floats) -> tuple[Floats, Floats]:
        """Equivalent plastic strain p on the yield surface, mises - 3 G (p - before) = stress(p), and the curve's slope there.

        On a curve of straight pieces that is a look-up, as 3 G p + stress(p) grows with p.
        """
        assert self._curve is not None, 'the material is elastic'
        strain, stress = self._curve
        lookUp = 3 * self.shear * strain + stress
        target = mises + 3 * self.shear * before
        after = numpy.maximum(numpy.interp(target, lookUp, strain), before)
        after[mises <= numpy.interp(before, strain, stress)] = before[mises <= numpy.interp(before, strain, stress)]
        piece = numpy.clip(numpy.searchsorted(lookUp, target, side='right') - 1, 0, len(strain) - 2)
        return after, (numpy.diff(stress) / numpy.diff(strain))[piece]
