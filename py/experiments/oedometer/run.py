"""An oedometer test: a bed of particles, rained into a rigid container, is compressed by a plate while its particles break. From parameters to
results, in stages that can be interrupted and taken up again.

    OedometerRun.begin({'mode': 'cube'}, 'results/cube').run()
"""
from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Self, TextIO

from yade import O, utils
from yade.wrapper import BreakableMat, BreakageEngine, CurvatureMat, NewtonIntegrator, Sphere, Superquadric

from ...measure.snapshot import Snapshot, boxHalfHeights
from ...runs.filenames import BEFORE
from ...runs.onbed import BedRun
from ...runs.staged import Stage
from ...runs.state import BedState, later
from ...scene.engines import engine, superquadricEngines
from ...scene.filling import rainFilling
from ...scene.settling import RestCriterion
from ...scene.settling import settle as settleBed
from ...scene.walls import boxContainer, cylinderContainer, setHeight
from . import report
from .parameters import BOX, OedometerParameters
from .record import Averages, row, strain

RAIN_GAP = 0.05             # clear distance of the particles at the start, over their diameter: they have little way to fall
QUIET, SUPPORT = 1e-3, 0.1  # at rest before the plate is put on, see RestCriterion: the plate moves everything again
SEATING_SPEED = 0.1         # m/s of the plate until it sits; what it stirs up dies away in the hold that follows
SEATING_STEPS = 20          # time steps over which its force is averaged
HOLD_STEPS = 1000           # time steps for which it stands still then
HELD_SHARE = 0.5            # of seatingStress that it must bear in them on the average: the bed gives way a little
SEATING_DAMPING = 0.3       # non-viscous, from the rain to the end of the hold: how the bed comes about does not matter
MARGIN = 0.2                # of the collider over the smallest half size, see superquadricEngines


@dataclass(repr=False, eq=False, kw_only=True)
class OedometerState(BedState):
    """What a resumed test has to know beside scene and parameters."""

    rows: list[dict[str, Any]] = field(default_factory=list)                     # of the record, see `record.row`
    settling: dict[str, Any] = field(default_factory=lambda: {'calm': True})     # memory of the criterion of rest
    particles: int = later()                                                     # number of them before any breaks
    solid: float = later()                                                       # their volume [m3]
    settled: bool = later()                                                      # whether they came to rest
    plate: int = later()                                                         # id of the plate
    sums: dict[str, float] | None = None                                         # of the forces in a portion of steps, see `record.Averages`
    height: float = later()                                                      # of the bed under the seated plate [m]
    startTime: float = later()                                                   # of the compression [s]
    startIter: int = later()
    before: dict[str, list[float]] = later()                                     # contacts before it


def settle(run: OedometerRun) -> None:
    """The rain comes to rest, then the plate is put on."""
    criterion = RestCriterion(run.ids, (run.container.baseId, *run.container.sideIds), QUIET, SUPPORT, run.state.settling)
    run.state.settled = settleBed(run.stepper, criterion, run.parameters.maxSettlingTime)
    particles = Snapshot.ofBodies(run.ids)
    top = float((particles.positions + boxHalfHeights(particles))[:, 2].max())
    run.state.container = setHeight(run.container, max(top, run.parameters.containerHeight()))._asdict()
    run.state.plate = O.bodies.append(utils.wall((0, 0, top), axis=2, sense=-1, material='walls'))
    run.movePlate(SEATING_SPEED)


def seat(run: OedometerRun) -> None:
    """The plate comes down until it bears seatingStress."""
    while _plateStress(run, SEATING_STEPS) < run.parameters.seatingStress:
        if run.plate.state.pos[2] <= 0:
            raise ValueError(f'seatingStress = {run.parameters.seatingStress!r}: the plate came down to the base without meeting it')
    run.movePlate(0)


def hold(run: OedometerRun) -> bool:
    """The plate stands still. What stopped it may have been a single grain that gave way: then it has to be seated again, and this is False."""
    if _plateStress(run, HOLD_STEPS) < HELD_SHARE * run.parameters.seatingStress:
        run.movePlate(SEATING_SPEED)
        return False
    Snapshot.ofBodies(run.ids).save(run.path(BEFORE))
    run.state.height = float(run.plate.state.pos[2])
    return True


def _plateStress(run: OedometerRun, steps: int) -> float:
    """Mean axial stress [Pa] on the plate over the next `steps`."""
    averages = Averages(run.state)
    run.stepper.run(steps, averages.add)
    return averages.take()['plate'] / run.area


def prepare(run: OedometerRun) -> None:
    """The particles become breakable."""
    p, state = run.parameters, run.state
    run.bedIsDone()
    engine(NewtonIntegrator).damping = p.numericalDamping
    if p.breaks():
        O.materials['particles'].updateAttrs(p.strength())
        O.engines = [BreakageEngine(criterion=p.criterion, mode=p.mode, cutExponent=p.cutExponent, maxEvents=p.maxEvents,
                                    smallestFragment=p.smallestFragment, inertialSize=p.inertialSize, seed=p.seedOfBreakage())] + O.engines
    O.dt = p.testTimeStep()
    O.trackEnergy = True
    state.startTime, state.startIter = O.time, O.iter
    state.before = report.contactsNow(run.ids)


def compress(run: OedometerRun) -> None:
    """The plate comes down, record by record, until the test is over."""
    p, rows = run.parameters, run.state.rows
    while not _isOver(run):
        rate = _strainRate(run)
        run.movePlate(rate * run.state.height)
        averages = Averages(run.state)
        run.stepper.run(max(1, round(p.sampleStrain / (rate * O.dt))), averages.add)
        rows.append(row(run, averages.take(), rate))


def _strainRate(run: OedometerRun) -> float:
    """[1/s]: strainRate, but never more than inertialNumber allows at the present stress (`record.row`)."""
    p, rows = run.parameters, run.state.rows
    stress = max(rows[-1]['plateStress'] if rows else 0.0, p.seatingStress)
    return min(p.strainRate, p.inertialNumber / p.largestDiameter * math.sqrt(stress / p.density))


def _isOver(run: OedometerRun) -> bool:
    p, rows = run.parameters, run.state.rows
    if not rows:
        return False
    enough = p.maxParticles is not None and rows[-1]['particles'] >= p.maxParticles
    return enough or rows[-1]['plateStress'] >= p.maxStress or strain(run) >= p.maxStrain * (1 - 1e-9)


def writeReport(run: OedometerRun) -> None:
    run.summary = report.write(run)


class OedometerRun(BedRun[OedometerParameters, OedometerState]):
    """A run in the folder `output`. Make it with `begin`, `onBed` or `resume`, then `run()`; `summary` holds the results.

    `run(until='prepare')` leaves the finished bed in the folder, for any number of tests.
    """

    PARAMETERS, STATE = OedometerParameters, OedometerState
    STAGES = (Stage('settle', settle), Stage('seat', seat), Stage('hold', hold, backTo='seat'), Stage('prepare', prepare),
              Stage('compress', compress), Stage('report', writeReport))
    FILES = report.FILES

    @classmethod
    def begin(cls, parameters: Mapping[str, Any], output: str, stream: TextIO | None = sys.stderr) -> Self:
        """Check `parameters` (see `OedometerParameters`), then build the scene; YADE's present scene is dropped, and so are the results of an
        earlier run in the folder.

        :raises ValueError: a bad parameter, or a folder that holds an interrupted run; before anything changes
        """
        run = cls.inFolder(output, OedometerParameters.checked(parameters), OedometerState(stage='settle'), stream)
        run._build()
        return run

    @property
    def plate(self) -> Any:
        """The plate's body."""
        return O.bodies[self.state.plate]

    def movePlate(self, speed: float) -> None:
        """Give the plate a `speed` downward [m/s]."""
        self.plate.state.vel = (0, 0, -speed)

    @property
    def ids(self) -> list[int]:
        """Of all particles there are."""
        return [body.id for body in O.bodies if isinstance(body.shape, (Sphere, Superquadric))]

    @property
    def area(self) -> float:
        """Of the plate [m2]."""
        return self.parameters.section()

    def expectedSteps(self) -> dict[str, float]:
        p, names = self.parameters, [stage.name for stage in self.STAGES]
        done = self.state.rows[-1]['strain'] if self.state.rows else 0.0
        steps = {'settle': 0.6 * p.maxSettlingTime / p.bedTimeStep(), 'seat': p.largestDiameter / SEATING_SPEED / p.bedTimeStep(),
                 'hold': HOLD_STEPS, 'compress': (p.maxStrain - done) / p.strainRate / p.testTimeStep()}
        return {name: steps.get(name, 0) for name in names[names.index(self.state.stage):]}

    def _build(self) -> None:
        """The scene: the container, with the particles on their way down."""
        p, state = self.parameters, self.state
        O.reset()
        material, walls = newMaterials(p)
        O.materials.append(material)
        O.materials.append(walls)
        height, width = p.containerHeight(), p.containerWidth
        container = boxContainer(width, width, height, walls) if p.container == BOX else cylinderContainer(width / 2, height, walls)
        shapes = p.drawnShapes()
        ids, container = rainFilling(shapes, container, material, p.seed, gap=RAIN_GAP)
        O.engines = superquadricEngines(gravity=(0, 0, -p.gravity), damping=SEATING_DAMPING, law='curvature',
                                        verletDist=MARGIN * min(min(shape.extents) for shape in shapes))
        O.dt = p.bedTimeStep()
        state.container, state.particles, state.solid = container._asdict(), len(ids), sum(shape.volume for shape in shapes)


def newMaterials(p: OedometerParameters) -> tuple[Any, Any]:
    """The materials of particles, which do not break yet, and of walls; not yet in the scene."""
    common = p.attributes()
    return (BreakableMat(**common, label='particles'),
            CurvatureMat(**{**common, 'frictionAngle': math.atan(p.wallFriction)}, label='walls'))
