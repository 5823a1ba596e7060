"""One bed and the impact on it, from parameters to results, in stages that can be interrupted and taken up again."""
from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Self, TextIO

from yade import O
from yade.wrapper import CurvatureMat, InteractionLoop

from ...files import results
from ...measure.bed import measureBed
from ...measure.snapshot import Snapshot
from ...pictures.snapshotrecorder import SnapshotRecorder
from ...runs.filenames import BEFORE
from ...runs.onbed import BedRun
from ...runs.staged import Stage
from ...runs.state import BedState, later
from ...scene.engines import engine
from ...scene.settling import RestCriterion, settle, setYoung
from ...scene.settling import stiffen as stiffenBed
from ...scene.settlingrules import QUIET, SUPPORT, TRUE_QUIET, TRUE_SUPPORT, rampSteps
from ...scene.stepping import Interrupted
from ...scene.walls import setHeight
from . import pictures, report
from .curves import RECORD
from .impactor import Recorder, addImpactor, bareImpact, recordImpact, supportForce
from .parameters import ImpactParameters
from .pouring import nextCount, rain
from .pulse import pulse

REST_STEPS = 10000  # time steps at most, per layer, for the bed to come to rest with its true stiffness
STATIC_STEPS = 200  # time steps over which the base's force is averaged before the impact


@dataclass(repr=False, eq=False, kw_only=True)
class ImpactState(BedState):
    """What a resumed impact has to know beside scene and parameters."""

    pours: list[dict[str, Any]] = field(default_factory=list)      # number and thickness [m] of each attempt
    vtk: bool = False                                              # whether a series for ParaView is written
    particles: list[int] = later()                                 # ids of the first and the last one
    pourTime: float = later()                                      # [s] that the rain is expected to take
    settled: dict[str, bool] = later()                             # whether the bed came to rest, soft and with its true stiffness
    settling: dict[str, Any] = later()                             # memory of the criterion of rest
    rampStage: int = later()                                       # of the stiffness
    bed: dict[str, Any] = later()                                  # as measured
    bare: dict[str, Any] = later()                                 # pulse, times, forces of the impact without a bed
    staticForces: list[list[float]] = later()                      # [N] on base and side walls, step by step
    staticForce: float = later()                                   # means of them [N]
    staticWallForce: float = later()
    impactor: int = later()                                        # its id
    startTime: float = later()                                     # of the impact [s]
    rows: list[list[float]] = later()                              # of the record of an impact that was interrupted
    impactOver: bool = later()
    pulse: dict[str, float] = later()


def pour(run: ImpactRun) -> bool:
    """The soft particles come to rest. False if others are to be poured instead, as the thickness is not the one aimed at."""
    criterion = run.criterion(run.parameters.restEnergy)
    run.state.settled['soft'] = settle(run.stepper, criterion, run.parameters.maxSettlingTime)
    run.state.settling = {}
    run.say(f'poured {len(run.ids)} particles: kinetic energy {criterion.kineticEnergy():.1e} m g d per particle, '
            f'support {criterion.supportedWeight():.3f} of the weight, t = {O.time:.3f} s')
    number = _betterCount(run)
    if number is None:
        return True
    run.count('pour')  # the new scene's solvers begin at zero
    run.build(number)
    run.stepper.plan['pour'] = run.expectedSteps()['pour']
    return False


def _betterCount(run: ImpactRun) -> int | None:
    """How many particles to pour instead, None if this is the bed."""
    p, pours = run.parameters, run.state.pours
    pours.append({'number': len(run.ids), 'thickness': measureBed(Snapshot.ofBodies(run.ids), run.container)['thickness']})
    better = nextCount(pours, p.thickness, p.thicknessTolerance) if p.particles is None else None
    if better is not None:
        run.say(f'thickness {1e3 * pours[-1]["thickness"]:.2f} mm instead of {1e3 * p.thickness:.2f} mm: {better} particles are poured instead')
    return better


def isSoft(run: ImpactRun) -> bool:
    """Whether the bed was poured with a lower stiffness than its own."""
    return run.parameters.pouringSoftening > 1


def stiffen(run: ImpactRun) -> None:
    def note(stage: int) -> None:
        run.state.rampStage = stage

    p = run.parameters
    stiffenBed(run.stepper, p.pouringSoftening, p.timeStepFraction, run.layers(), run.state.rampStage, note)


def rest(run: ImpactRun) -> None:
    """The bed comes to rest with its true stiffness."""
    criterion = run.restOnceMore()
    run.say(f'at rest: kinetic energy {criterion.kineticEnergy():.1e} m g d per particle, support '
            f'{criterion.supportedWeight():.4f} of the weight')


def measure(run: ImpactRun) -> None:
    container = setHeight(run.container, run.parameters.containerHeight)
    before = Snapshot.ofBodies(run.ids)
    before.save(run.path(BEFORE))
    run.state.bed, run.state.container = measureBed(before, container), container._asdict()


def prepare(run: ImpactRun) -> None:
    """The bed gets what is special in this impact."""
    p = run.parameters
    if not run.state.has('bare'):
        bare = bareImpact(p.impactorDiameter, p.impactorDensity, CurvatureMat(**p.attributes()), p.speed, p.dropHeight, p.gravity, p.baseYoung)
        run.state.bare = {'pulse': bare.pulse._asdict(), 'times': bare.times, 'forces': bare.forces}
        law = engine(InteractionLoop).lawDispatcher.functors[0]
        law.updateAttrs({'overlapLimit': p.overlapLimit, 'effectiveMassAtContact': p.effectiveMassAtContact})
        if p.baseYoung is not None:
            setYoung(O.bodies[run.container.baseId], p.baseYoung)
    if p.baseYoung is not None:
        run.restOnceMore()


def static(run: ImpactRun) -> None:
    """The base's force is averaged, then the impactor is put in its place."""
    p, state = run.parameters, run.state
    supports = [run.container.baseId], run.container.sideIds
    O.dt = p.impactTimeStep()
    run.stepper.run(STATIC_STEPS, lambda: state.staticForces.append([supportForce(ids) for ids in supports]))
    state.staticForce, state.staticWallForce = (sum(forces) / len(forces) for forces in zip(*state.staticForces))
    state.impactor = addImpactor(p.impactorDiameter, p.impactorDensity, O.materials['particles'], p.speed, p.dropHeight, state.bed['thickness'],
                                 run.ids, p.gravity, (p.impactorX, p.impactorY))
    O.trackEnergy = True
    state.startTime = O.time


def impact(run: ImpactRun) -> None:
    recorder, state = run.openRecord(), run.state
    state.impactOver = recordImpact(run.stepper, recorder, state.staticForce, run.parameters.maxImpactTime, run.film)
    run.writeRecord()
    state.pulse = pulse(recorder.column('time'), recorder.column('baseForce'), state.staticForce)._asdict()


def writeReport(run: ImpactRun) -> None:
    run.openRecord()
    run.summary = report.write(run)


class ImpactRun(BedRun[ImpactParameters, ImpactState]):
    """A run in the folder `output`. Make it with `begin`, `onBed` or `resume`, then `run()`; `summary` holds the results.

    `run(until='prepare')` leaves the finished bed in the folder, for any number of impacts. A ValueError (the impactor cannot start where it should,
    no blow reached the base) leaves checkpoint and data as Ctrl-C does.
    """

    PARAMETERS, STATE = ImpactParameters, ImpactState
    STAGES = (Stage('pour', pour, backTo='pour'), Stage('stiffen', stiffen, when=isSoft), Stage('rest', rest), Stage('measure', measure),
              Stage('prepare', prepare), Stage('static', static), Stage('impact', impact), Stage('report', writeReport))
    SAVED = (Interrupted, ValueError)
    FILES = (*report.FILES, *pictures.FILES)

    recorder: Recorder | None = None
    film: SnapshotRecorder | None = None

    @classmethod
    def begin(cls, parameters: Mapping[str, Any], output: str, stream: TextIO | None = sys.stderr) -> Self:
        """Check `parameters` (see `ImpactParameters`), then build the scene; YADE's present scene is dropped, and so are the results of an
        earlier run in the folder.

        :raises ValueError: a bad parameter, or a folder that holds an interrupted run; before anything changes
        """
        complete = ImpactParameters.checked(parameters)
        run = cls.inFolder(output, complete, ImpactState(stage='pour'), stream)
        run.build(complete.particleCount())
        return run

    @classmethod
    def inFolder(cls, output: str, parameters: ImpactParameters, state: ImpactState, stream: TextIO | None = sys.stderr) -> Self:
        """See `StagedRun.inFolder`."""
        state.vtk = False  # whether there is a series is the impact's, not its bed's
        run = super().inFolder(output, parameters, state, stream)
        pictures.removeOld(run)
        return run

    @property
    def ids(self) -> range:
        """Of the particles."""
        first, last = self.state.particles
        return range(first, last + 1)

    def save(self) -> None:
        """Write the checkpoint, and the record as far as there is one."""
        if self.recorder is not None:
            self.state.rows = [list(row) for row in self.recorder.rows]
            self.writeRecord()
        super().save()

    def expectedSteps(self) -> dict[str, float]:
        p, names = self.parameters, [stage.name for stage in self.STAGES]
        left = names[names.index(self.state.stage):]
        steps = {'pour': max(self.state.pourTime - O.time, 0) / O.dt,
                 'stiffen': sum(rampSteps(p.pouringSoftening, self.layers())) if isSoft(self) else 0, 'rest': 900, 'static': STATIC_STEPS,
                 'impact': 0.012 / p.impactTimeStep()}
        return {name: steps.get(name, 0) for name in left}

    def layers(self) -> float:
        """Number of layers of the bed: its thickness, as far as it is known yet, over the particles' diameter."""
        thickness = self.state.pours[-1]['thickness'] if self.state.pours else self.parameters.thickness
        return max(thickness / (2 * self.parameters.radius), 1.0)

    def build(self, number: int) -> None:
        """The scene with so many particles on their way down."""
        ids, container = rain(self.parameters, number)
        top, state = max(O.bodies[i].state.pos[2] for i in ids), self.state
        state.container, state.particles, state.rampStage = container._asdict(), [ids[0], ids[-1]], 0
        state.pourTime = math.sqrt(2 * top / self.parameters.gravity) + 0.3
        state.settled, state.settling, state.staticForces = {}, {}, []

    def criterion(self, quiet: float = QUIET, support: float = SUPPORT) -> RestCriterion:
        """Of the bed's rest."""
        return RestCriterion(self.ids, (self.container.baseId, *self.container.sideIds), quiet, support, self.state.settling)

    def restOnceMore(self) -> RestCriterion:
        """Let the bed come to rest with its true stiffness; the criterion by which it did."""
        criterion = self.criterion(TRUE_QUIET, TRUE_SUPPORT)
        self.state.settled['true'] = settle(self.stepper, criterion, REST_STEPS * self.layers() * O.dt)
        self.state.settling = {}
        return criterion

    def openRecord(self) -> Recorder:
        """The recorder, with what an interrupted run has recorded."""
        if self.recorder is None:
            rows = self.state.rows if self.state.has('rows') else ()
            self.recorder = Recorder(self.container, self.state.impactor, self.state.startTime, rows)
        self.film = pictures.film(self)
        return self.recorder

    def writeRecord(self) -> None:
        """The record so far."""
        if self.recorder is not None:
            results.writeCsv(self.path(RECORD), Recorder.COLUMNS, self.recorder.rows)

    def say(self, text: str) -> None:
        self.stepper.say(text)
