"""A particle damper: particles in a rigid box on a spring, under a harmonic force. One run is one frequency, from parameters to results,
in stages that can be interrupted and taken up again.

    DamperRun.begin({'frequency': 30.2}, 'results/30.2').run()
"""
from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self, TextIO

from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, VibratingBoxEngine, VibrationRecorder

from ...materials.elastoplastic import elastoplasticMat
from ...materials.shipped import properties
from ...runs.staged import Stage, StagedRun
from ...runs.state import State, later
from ...scene.contactlaws import CURVATURE
from ...scene.engines import engine, halfSizes, superquadricEngines
from ...scene.filling import rainFilling
from ...scene.settling import RestCriterion
from ...scene.settling import settle as settleBed
from ...scene.walls import boxContainer
from . import report
from .parameters import DamperParameters

RAIN_GAP = 0.05             # clear distance of the particles at the start, over their diameter: they have little way to fall
QUIET, SUPPORT = 1e-3, 0.1  # at rest before the drive, see RestCriterion: far below what the drive does to the particles
VERLET = 0.4                # margin of the collider over the smallest half size: few contacts, fast particles


@dataclass(repr=False, eq=False, kw_only=True)
class DamperState(State):
    """What a resumed damper has to know beside scene and parameters."""

    energies: list[dict[str, float]] = field(default_factory=list)                 # O.energy at the end of every period
    settling: dict[str, Any] = field(default_factory=lambda: {'calm': True})       # memory of the criterion of rest
    settled: bool = True                                                           # whether the particles came to rest
    particles: list[int] = later()                                                 # id of the first one, and behind the last one
    supports: list[int] = later()                                                  # ids of base and walls
    startTime: float = later()                                                     # of the drive [s]
    restCentroid: list[float] = later()                                            # centre of mass before it [m]


def settle(run: DamperRun) -> None:
    """The particles fall and come nearly to rest, while the box is held. How they get there does not matter here, so that YADE's non-viscous
    damping helps from the beginning ('calm', see `scene.settling.settle`)."""
    if run.ids:
        criterion = RestCriterion(run.ids, run.state.supports, QUIET, SUPPORT, run.state.settling)
        run.state.settled = settleBed(run.stepper, criterion, run.parameters.maxSettlingTime)


def release(run: DamperRun) -> None:
    """The lid is put on, the box set free, and the force begins, at zero."""
    p, box = run.parameters, engine(VibratingBoxEngine)
    _checkLid(run)
    lid = O.bodies.append(utils.wall((0, 0, p.boxHeight), axis=2, sense=-1, material='particles'))
    box.ids = [*box.ids, lid]
    displacement, velocity = p.startOfTheBox()
    box.updateAttrs({'freeAxes': p.axis, 'forceAmplitude': alongAxis(p, p.forceAmplitude), 'frequency': p.frequency,
                     'phase': -2 * math.pi * p.frequency * O.time, 'displacement': alongAxis(p, displacement),
                     'velocity': alongAxis(p, velocity)})
    engine(VibrationRecorder).dead = False
    O.trackEnergy = True
    run.state.startTime, run.state.restCentroid = O.time, list(centroid(run.ids))


def _checkLid(run: DamperRun) -> None:
    p = run.parameters
    top = max((O.bodies[i].state.pos[2] for i in run.ids), default=0.0) + p.meanShape.boundingRadius
    if top > p.boxHeight:
        raise ValueError(f'boxHeight = {p.boxHeight!r}: the settled particles reach {top:.4g} m; the lid does not go on')


def drive(run: DamperRun) -> None:
    """The periods of the transient, then those that are measured."""
    p, energies = run.parameters, run.state.energies
    while len(energies) < p.transientPeriods() + p.periods:
        run.stepper.run(p.stepsPerPeriod())
        energies.append(dict(O.energy.items()))


def writeReport(run: DamperRun) -> None:
    run.summary = report.write(run)


class DamperRun(StagedRun[DamperParameters, DamperState]):
    """A run in the folder `output`. Make it with `begin` or `resume`, then `run()`; `summary` holds the results."""

    PARAMETERS, STATE = DamperParameters, DamperState
    STAGES = (Stage('settle', settle), Stage('release', release), Stage('drive', drive), Stage('report', writeReport))
    FILES = report.FILES

    @classmethod
    def begin(cls, parameters: Mapping[str, Any], output: str, stream: TextIO | None = sys.stderr) -> Self:
        """Check `parameters` (see `DamperParameters`), then build the scene; YADE's present scene is dropped, and so are the results of an
        earlier run in the folder.

        :raises ValueError: a bad parameter, or a folder that holds an interrupted run; before anything changes
        """
        run = cls.inFolder(output, DamperParameters.checked(parameters), DamperState(stage='settle'), stream)
        run._build()
        return run

    @property
    def ids(self) -> range:
        """Of the particles."""
        return range(*self.state.particles)

    def expectedSteps(self) -> dict[str, float]:
        p = self.parameters
        periods = p.transientPeriods() + p.periods - len(self.state.energies)
        settling = 0.6 * p.maxSettlingTime / p.timeStep() if self.state.stage == 'settle' else 0
        return {'settle': settling, 'release': 0, 'drive': periods * p.stepsPerPeriod(), 'report': 0}

    def _build(self) -> None:
        """The scene: the box, held, with the particles on their way down, and the engines of all stages."""
        p = self.parameters
        material = newMaterial(p, label='particles')
        O.reset()
        O.materials.append(material)
        container = boxContainer(p.boxWidth, p.boxDepth, p.boxHeight, material)
        ids: Sequence[int] = ()
        if p.particles:
            ids = rainFilling(p.drawnShapes(p.particles, p.seed), container, material, p.seed, gap=RAIN_GAP)[0]
        box = VibratingBoxEngine(ids=[container.baseId, *container.sideIds], freeAxes='', mass=p.boxMass, label='box',
                                 stiffness=alongAxis(p, p.stiffness), damping=alongAxis(p, p.dashpot))
        O.engines = [*superquadricEngines(gravity=(0, 0, -p.gravity), verletDist=VERLET * min(halfSizes(), default=p.radius), afterForces=[box],
                                          law=p.law),
                     VibrationRecorder(box=box, particles=list(ids), iterPeriod=p.stepsPerSample(), initRun=True, dead=True)]
        O.dt = p.timeStep()
        self.state.particles, self.state.supports = [min(ids), max(ids) + 1] if ids else [0, 0], list(box.ids)


def newMaterial(p: DamperParameters, **others: Any) -> Any:
    """The material of particles and box, not yet in the scene."""
    common = {**p.attributes(), **others}
    if p.law == CURVATURE:
        return CurvatureMat(**common)
    return elastoplasticMat({**properties(p.material), 'yieldStress': p.yieldStress()}, **{'rollingDamping': p.rollingDamping, **common})


def alongAxis(p: DamperParameters, value: float) -> Any:
    """A vector of length `value` along the axis on which the box moves."""
    return Vector3(*(value if axis == p.axis else 0 for axis in 'xyz'))


def centroid(ids: Sequence[int]) -> Any:
    """Centre of mass of bodies; Vector3 [m], zero without bodies."""
    states = [O.bodies[i].state for i in ids]
    mass = sum(state.mass for state in states)
    return sum((state.mass * state.pos for state in states), Vector3.Zero) / mass if mass else Vector3.Zero
