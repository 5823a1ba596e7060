"""An oedometer test: a bed of particles, rained into a rigid container, is compressed by a plate while its particles break. From parameters to
results, in stages that can be interrupted and taken up again.

    OedometerRun.begin({'mode': 'cube'}, 'results/cube').run()
"""
import math
import random
import sys

from yade import O, utils
from yade.wrapper import BreakageEngine, NewtonIntegrator, Sphere, Superquadric

from . import report
from ...runs.onbed import BedRun
from ...scene.walls import boxContainer, cylinderContainer, setHeight
from ...scene.engines import engine, superquadricEngines
from ...scene.filling import rainFilling
from .parameters import bedPart, bedTimeStep, breakageSeed, checked, containerHeight, newMaterials, section, shapeOf, strengthOf, testTimeStep
from .record import Averages, row, strain
from ...scene.settling import RestCriterion, settle
from ...measure.snapshot import Snapshot, boxHalfHeights

RAIN_GAP = 0.05             # clear distance of the particles at the start, over their diameter: they have little way to fall
QUIET, SUPPORT = 1e-3, 0.1  # at rest before the plate is put on, see RestCriterion: the plate moves everything again
SEATING_SPEED = 0.1         # m/s of the plate until it sits; what it stirs up dies away in the hold that follows
SEATING_STEPS = 20          # time steps over which its force is averaged
HOLD_STEPS = 1000           # time steps for which it stands still then
HELD_SHARE = 0.5            # of seatingStress that it must bear in them on the average: the bed gives way a little
SEATING_DAMPING = 0.3       # non-viscous, from the rain to the end of the hold: how the bed comes about does not matter
MARGIN = 0.2                # of the collider over the smallest half size, see superquadricEngines


class OedometerRun(BedRun):
    """A run in the folder `output`. Make it with `begin`, `onBed` or `resume`, then `run()`; `summary` holds the results.

    `run(until='prepare')` leaves the finished bed in the folder, for any number of tests.
    """

    STAGES = ('settle', 'seat', 'hold', 'prepare', 'compress', 'report')
    FILES = report.FILES
    checked, bedPart = staticmethod(checked), staticmethod(bedPart)

    @classmethod
    def begin(cls, parameters, output, stream=sys.stderr):
        """Check `parameters` (a dict, see `oedometerparameters.PARAMETERS`), then build the scene; YADE's present scene is dropped, and so are
        the results of an earlier run in the folder.

        :raises ValueError: a bad parameter, or a folder that holds an interrupted run; before anything changes
        """
        state = {'parameters': checked(parameters), 'stage': 'settle', 'settling': {'calm': True}}
        run = cls.inFolder(output, state, stream=stream)
        run._build()
        return run

    @property
    def plate(self):
        """The plate's body."""
        return O.bodies[self.state['plate']]

    @property
    def ids(self):
        """Of all particles there are."""
        return [body.id for body in O.bodies if isinstance(body.shape, (Sphere, Superquadric))]

    @property
    def area(self):
        """Of the plate [m2]."""
        return section(self.parameters)

    def _plan(self):
        p, stages = self.parameters, self.STAGES[self.STAGES.index(self.state['stage']):]
        done = self.state['rows'][-1]['strain'] if self.state.get('rows') else 0.0
        steps = {'settle': 0.6 * p['settlingTime'] / bedTimeStep(p), 'seat': p['largestDiameter'] / SEATING_SPEED / bedTimeStep(p),
                 'hold': HOLD_STEPS, 'compress': (p['maxStrain'] - done) / p['strainRate'] / testTimeStep(p)}
        return {stage: steps.get(stage, 0) for stage in stages}

    def _build(self):
        """The scene: the container, with the particles on their way down."""
        p = self.parameters
        O.reset()
        material, walls = newMaterials(p)
        O.materials.append(material)
        O.materials.append(walls)
        height = containerHeight(p)
        container = (boxContainer(p['width'], p['width'], height, walls) if p['container'] == 'box' else
                     cylinderContainer(p['width'] / 2, height, walls))
        shapes = particleShapes(p)
        ids, container = rainFilling(shapes, container, material, p['seed'], gap=RAIN_GAP)
        O.engines = superquadricEngines(gravity=(0, 0, -p['gravity']), damping=SEATING_DAMPING, law='curvature',
                                        verletDist=MARGIN * min(min(shape.extents) for shape in shapes))
        O.dt = bedTimeStep(p)
        self.state.update(container=container._asdict(), rows=[], particles=len(ids),
                          solid=sum(shape.volume for shape in shapes))

    def _settle(self):
        criterion = RestCriterion(self.ids, (self.container.baseId, *self.container.sideIds), QUIET, SUPPORT, self.state['settling'])
        self.state['settled'] = settle(self.stepper, criterion, self.parameters['settlingTime'])
        self._putOnPlate()
        self.state['stage'] = 'seat'

    def _putOnPlate(self):
        particles = Snapshot.ofBodies(self.ids)
        top = float((particles.positions + boxHalfHeights(particles))[:, 2].max())
        self.state['container'] = setHeight(self.container, max(top, containerHeight(self.parameters)))._asdict()
        self.state['plate'] = O.bodies.append(utils.wall((0, 0, top), axis=2, sense=-1, material='walls'))
        self.plate.state.vel = (0, 0, -SEATING_SPEED)

    def _seat(self):
        """The plate comes down until it bears seatingStress."""
        while self._plateStress(SEATING_STEPS) < self.parameters['seatingStress']:
            if self.plate.state.pos[2] <= 0:
                raise ValueError(f'seatingStress = {self.parameters["seatingStress"]!r}: the plate came down to the base without meeting it')
        self.plate.state.vel = (0, 0, 0)
        self.state['stage'] = 'hold'

    def _hold(self):
        """The plate stands still. What stopped it may have been a single grain that gave way: then it goes on."""
        if self._plateStress(HOLD_STEPS) < HELD_SHARE * self.parameters['seatingStress']:
            self.plate.state.vel = (0, 0, -SEATING_SPEED)
            self.state['stage'] = 'seat'
            return
        Snapshot.ofBodies(self.ids).save(self.path(report.BEFORE))
        self.state.update(stage='prepare', height=float(self.plate.state.pos[2]))

    def _plateStress(self, steps):
        """Mean axial stress [Pa] on the plate over the next `steps`."""
        averages = Averages(self.state)
        self.stepper.run(steps, averages.add)
        return averages.take()['plate'] / self.area

    def _prepare(self):
        """The particles become breakable."""
        p = self.parameters
        engine(NewtonIntegrator).damping = p['damping']
        if p['mode'] != 'none':
            O.materials['particles'].updateAttrs(strengthOf(p))
            O.engines = [BreakageEngine(criterion=p['criterion'], mode=p['mode'], cutExponent=p['cutExponent'], maxEvents=p['maxEvents'],
                                        smallestFragment=p['smallestFragment'], inertialSize=p['inertialSize'],
                                        seed=breakageSeed(p))] + O.engines
        O.dt = testTimeStep(p)
        O.trackEnergy = True
        self.state.update(stage='compress', startTime=O.time, startIter=O.iter)
        self.state.setdefault('bedSeconds', self.state['seconds'])
        self.state['before'] = report.contactsNow(self.ids)

    def _compress(self):
        p, rows = self.parameters, self.state['rows']
        while not self._over():
            rate = self._strainRate()
            self.plate.state.vel = (0, 0, -rate * self.state['height'])
            averages = Averages(self.state)
            self.stepper.run(max(1, round(p['sampleStrain'] / (rate * O.dt))), averages.add)
            rows.append(row(self, averages.take(), rate))
        self.state['stage'] = 'report'

    def _strainRate(self):
        """[1/s]: strainRate, but never more than inertialNumber allows at the present stress (`oedometerrecord.row`)."""
        p, rows = self.parameters, self.state['rows']
        stress = max(rows[-1]['plateStress'] if rows else 0.0, p['seatingStress'])
        return min(p['strainRate'], p['inertialNumber'] / p['largestDiameter'] * math.sqrt(stress / p['density']))

    def _over(self):
        p, rows = self.parameters, self.state['rows']
        if not rows:
            return False
        enough = p['maxParticles'] is not None and rows[-1]['particles'] >= p['maxParticles']
        return enough or rows[-1]['plateStress'] >= p['maxStress'] or strain(self) >= p['maxStrain'] * (1 - 1e-9)

    def _report(self):
        self.summary = report.write(self)
        self.state['stage'] = 'done'


def particleShapes(parameters):
    """`ParticleShape` of every particle: uniformly distributed sizes."""
    rng = random.Random(f'sizes {parameters["seed"]}')  # another sequence than the one that places the particles
    low, high = parameters['smallestDiameter'], parameters['largestDiameter']
    return [shapeOf(parameters, low + (high - low) * rng.random()) for _ in range(parameters['particles'])]
