"""Bringing a bed to rest: first with soft particles, which allows long time steps, then with the true stiffness.

The rain falls and comes to rest with Young's modulus divided by `softening`; the critical time step grows by
its square root. The restitution of the law does not depend on the stiffness, nor does friction; what differs is the
overlap under the bed's own weight, well below a percent of the particle size. Then the modulus rises to the
true one in small steps of time and stiffness while YADE's non-viscous damping takes up the energy that the shrinking
overlaps give back, and the bed comes to rest a second time.
"""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from yade import O
from yade.wrapper import Body, CurvatureMat, CurvaturePhys, ElastoplasticMat, NewtonIntegrator

from .. import checks
from .engines import criticalTimeStep, engine
from .settlingrules import CALM, CHECK_STEPS, CHECKS_IN_A_ROW, DAMPING, QUIET, QUIET_SHARE, RAMP_DAMPING, RAMP_STAGES, SUPPORT, rampSteps

if TYPE_CHECKING:
    from .stepping import Stepper


class RestCriterion:
    """Whether the particles `ids` rest on the bodies `supports` (base and walls).

    At rest: kinetic energy (rotation included) per particle below `quiet` m g d, the fastest percent (QUIET_SHARE) left out, and the
    vertical force on the supports within `support` of the weight; as often in a row as CHECKS_IN_A_ROW says.

    :ivar memory: what settling has to know beside the scene when it is taken up again, a dict of plain values: how often in
        a row the criterion `held`, whether the bed was `calm`, when settling has to `end` [s]
    """

    def __init__(self, ids: Sequence[int], supports: Sequence[int], quiet: float = QUIET, support: float = SUPPORT,
                 memory: dict[str, Any] | None = None) -> None:
        self.ids, self.supports = list(ids), list(supports)
        if not self.ids:
            raise ValueError('ids = []: at least one particle is needed')
        self.quiet, self.support = checks.positive('quiet', quiet), checks.positive('support', support)
        self.gravity = abs(engine(NewtonIntegrator).gravity[2])
        masses = [O.bodies[i].state.mass for i in self.ids]
        self.weight = self.gravity * sum(masses)
        self.scale = self.weight * _meanDiameter(self.ids)
        self.memory = {} if memory is None else memory

    def kineticEnergy(self) -> float:
        """Mean kinetic energy of a particle over m g d [-], the fastest left out."""
        quiet = math.ceil(QUIET_SHARE * len(self.ids))
        energies = sorted(_kineticEnergy(O.bodies[i].state) for i in self.ids)[:quiet]
        return sum(energies) / quiet * len(self.ids) / self.scale

    def supportedWeight(self) -> float:
        """Vertical force on the supports over the weight [-]."""
        return -sum(O.forces.f(i)[2] for i in self.supports) / self.weight

    def check(self) -> bool:
        """Look once; True when the criterion has held long enough."""
        quiet = self.kineticEnergy() < self.quiet
        holds = quiet and abs(self.supportedWeight() - 1) < self.support
        self.memory['held'] = self.memory.get('held', 0) + 1 if holds else 0
        return self.memory['held'] >= CHECKS_IN_A_ROW


def _kineticEnergy(state: Any) -> float:
    spin = state.ori.conjugate() * state.angVel
    return 0.5 * (state.mass * state.vel.squaredNorm() + sum(i * w * w for i, w in zip(state.inertia, spin)))


def _meanDiameter(ids: Sequence[int]) -> float:
    volume = sum(O.bodies[i].state.mass / O.bodies[i].mat.density for i in ids) / len(ids)
    return (6 * volume / math.pi) ** (1 / 3)


def settle(stepper: Stepper, criterion: RestCriterion, maxTime: float) -> bool:
    """Step until the criterion holds, or for `maxTime` [s] of simulated time at most. As soon as the kinetic energy
    per particle is below CALM m g d, YADE's non-viscous damping helps, until the end.

    :param stepper: `Stepper`
    :returns: whether the bed came to rest
    """
    newton, memory = engine(NewtonIntegrator), criterion.memory
    end = memory.setdefault('end', O.time + checks.positive('maxTime', maxTime))
    before = newton.damping
    try:
        while True:
            if memory.get('calm'):
                newton.damping = DAMPING
            stepper.run(CHECK_STEPS)
            if criterion.check():
                return True
            if O.time >= end:
                return False
            memory['calm'] = memory.get('calm', False) or criterion.kineticEnergy() < CALM
    finally:
        newton.damping = before


def scaleStiffness(factor: float) -> None:
    """Multiply Young's modulus of all shared materials, and of the contacts that exist, by `factor`.

    The tangential displacements are scaled by factor^(-2/3), as the overlaps will be once the bed has found its
    equilibrium again: the contacts then carry the friction that they carried before.

    :raises ValueError: a body's material is not in O.materials, so that it would be missed; or it yields: a bed of
        softened grains would have other dents
    """
    factor = checks.positive('factor', factor)
    for body in O.bodies:
        _requireElastic(body)
        if isinstance(body.mat, CurvatureMat) and body.mat.id < 0:
            raise ValueError(f'body {body.id}: its material is not in O.materials; use O.materials.append')
    for material in O.materials:
        if isinstance(material, CurvatureMat):
            material.young = factor * material.young
    shrink = factor ** (-2 / 3)
    for interaction in O.interactions:
        phys = interaction.phys
        if isinstance(phys, CurvaturePhys):
            phys.updateAttrs({'effectiveModulus': factor * phys.effectiveModulus,
                              'shearDisplacement': shrink * phys.shearDisplacement})


def setYoung(body: Body, young: float) -> None:
    """Give the `body` a Young's modulus [Pa] of its own, also in the contacts that it has; its other bodies keep theirs.

    The contacts keep the friction that they carry, as in `scaleStiffness`; its material must not yield, as there.
    """
    _requireElastic(body)
    own = type(body.mat)(**{**body.mat.dict(), 'id': -1, 'label': '', 'young': checks.positive('young', young)})
    O.materials.append(own)
    body.mat = own
    for interaction in body.intrs():
        if not isinstance(interaction.phys, CurvaturePhys):
            continue
        pair = [O.bodies[i].mat for i in (interaction.id1, interaction.id2)]
        modulus = 1 / sum((1 - material.poisson ** 2) / material.young for material in pair)
        shrink = (modulus / interaction.phys.effectiveModulus) ** (-2 / 3)
        interaction.phys.updateAttrs({'effectiveModulus': modulus, 'shearDisplacement': shrink * interaction.phys.shearDisplacement})


def _requireElastic(body: Body) -> None:
    if isinstance(body.mat, ElastoplasticMat) and math.isfinite(body.mat.yieldStress):
        raise ValueError(f'body {body.id}: its material yields (yieldStress = {body.mat.yieldStress:g} Pa), so its contacts cannot '
                         f'be given another stiffness')


def stiffen(stepper: Stepper, softening: float, timeStepFraction: float, layers: float = 1.0, done: int = 0,
            afterScaling: Callable[[int], object] = lambda stage: None) -> None:
    """Raise the stiffness by `softening` in RAMP_STAGES stages, the time step following.

    :param timeStepFraction: time step over the critical one
    :param layers: thickness of the bed over the particles' diameter
    :param done: stage in whose steps a run was stopped that is now taken up again; 0: none
    :param afterScaling: called with the number of the stage, before its steps are run
    """
    factor = checks.positive('softening', softening) ** (1 / RAMP_STAGES)
    newton = engine(NewtonIntegrator)
    before, newton.damping = newton.damping, RAMP_DAMPING
    try:
        for stage, steps in enumerate(rampSteps(softening, layers), 1):
            if stage > done:
                scaleStiffness(factor)
                O.dt = timeStepFraction * criticalTimeStep()
                afterScaling(stage)
            if stage >= done:
                stepper.run(steps)
    finally:
        newton.damping = before
