"""One bed and the impact on it, from parameters to results, in stages that can be interrupted and taken up again."""
import math
import sys

from yade import O
from yade.wrapper import CurvatureMat, InteractionLoop

from . import pictures, report
from ...files import results
from ...measure.bed import measureBed
from ...runs.onbed import BedRun
from ...scene.walls import setHeight
from ...scene.engines import engine
from .impactor import Recorder, addImpactor, bareImpact, pulse, recordImpact, supportForce
from .parameters import bedPart, checked, criticalImpactStep, materialOf, particleCount
from .pouring import nextCount, rain
from ...scene.settling import RestCriterion, setYoung, settle, stiffen
from ...scene.settlingrules import QUIET, SUPPORT, TRUE_QUIET, TRUE_SUPPORT, rampSteps
from ...measure.snapshot import Snapshot
from ...scene.stepping import Interrupted

REST_STEPS = 10000  # time steps at most, per layer, for the bed to come to rest with its true stiffness
STATIC_STEPS = 200  # time steps over which the base's force is averaged before the impact


class ImpactRun(BedRun):
    """A run in the folder `output`. Make it with `begin`, `onBed` or `resume`, then `run()`; `summary` holds the results.

    `run(until='prepare')` leaves the finished bed in the folder, for any number of impacts. A ValueError (the impactor cannot start where it should,
    no blow reached the base) leaves checkpoint and data as Ctrl-C does.
    """

    STAGES = ('pour', 'stiffen', 'rest', 'measure', 'prepare', 'static', 'impact', 'report')
    SAVED = (Interrupted, ValueError)
    FILES = (*report.FILES, *pictures.FILES)
    checked, bedPart = staticmethod(checked), staticmethod(bedPart)

    recorder = film = None

    @classmethod
    def begin(cls, parameters, output, stream=sys.stderr):
        """Check `parameters` (a dict, see `parameters.PARAMETERS`), then build the scene; YADE's present scene is dropped, and so are
        the results of an earlier run in the folder.

        :raises ValueError: a bad parameter, or a folder that holds an interrupted run; before anything changes
        """
        parameters = checked(parameters)
        run = cls.inFolder(output, {'parameters': parameters, 'pours': []}, stream=stream)
        run._build(particleCount(parameters))
        return run

    @classmethod
    def inFolder(cls, output, state, files=None, stream=sys.stderr):
        """See `StagedRun.inFolder`."""
        own = {name: value for name, value in state.items() if name != 'vtk'}  # whether there is a series is the impact's, not its bed's
        run = super().inFolder(output, own, files, stream)
        pictures.removeOld(run)
        return run

    @property
    def ids(self):
        first, last = self.state['particles']
        return range(first, last + 1)

    def leave(self, until):
        if until == self.BED:
            self.state['bed']['wallSeconds'] = self.state['seconds']
        super().leave(until)

    def save(self):
        """Write the checkpoint, and the record as far as there is one."""
        if self.recorder is not None:
            self.state['rows'] = self.recorder.rows
            self._writeRecord()
        super().save()

    def _plan(self):
        """Expected steps of the stages, for the estimate of the time left."""
        soft = self.parameters['softening'] > 1
        done = self.STAGES[:self.STAGES.index(self.state['stage'])]
        steps = {'pour': max(self.state['pourTime'] - O.time, 0) / O.dt if 'pour' not in done else 0,
                 'stiffen': sum(rampSteps(self.parameters['softening'], self._layers())) if soft else 0, 'rest': 900, 'measure': 0, 'prepare': 0,
                 'static': STATIC_STEPS, 'impact': 0.012 / self._timeStep(), 'report': 0}
        return {stage: count for stage, count in steps.items() if stage not in done}

    def _timeStep(self):
        if self.parameters['dt'] is not None:
            return self.parameters['dt']
        return self.parameters['timeStepFraction'] * criticalImpactStep(self.parameters)

    def _layers(self):
        """Number of layers of the bed: its thickness, as far as it is known yet, over the particles' diameter."""
        thickness = self.state['pours'][-1]['thickness'] if self.state['pours'] else self.parameters['thickness']
        return max(thickness / (2 * self.parameters['radius']), 1.0)

    def _build(self, count):
        """The scene with `count` particles on their way down."""
        p = self.parameters
        ids, container = rain(p, count)
        top = max(O.bodies[i].state.pos[2] for i in ids)
        self.state.update(stage='pour', container=container._asdict(), particles=[ids[0], ids[-1]], rampStage=0,
                          pourTime=math.sqrt(2 * top / p['gravity']) + 0.3, settled={}, settling={}, staticForces=[])

    def _criterion(self, quiet=QUIET, support=SUPPORT):
        return RestCriterion(self.ids, (self.container.baseId, *self.container.sideIds), quiet, support, self.state['settling'])

    def _pour(self):
        criterion = self._criterion(self.parameters['restEnergy'])
        self.state['settled']['soft'] = settle(self.stepper, criterion, self.parameters['maxSettlingTime'])
        self.state['settling'] = {}
        self._say(f'poured {len(self.ids)} particles: kinetic energy {criterion.kineticEnergy():.1e} m g d per particle, '
                  f'support {criterion.supportedWeight():.3f} of the weight, t = {O.time:.3f} s')
        count = self._betterCount()
        if count is None:
            self.state['stage'] = 'stiffen' if self.parameters['softening'] > 1 else 'rest'
        else:
            self.count('pour')  # the new scene's solvers begin at zero
            self._build(count)
            self.stepper.plan['pour'] = self._plan()['pour']

    def _betterCount(self):
        """How many particles to pour instead, None if this is the bed."""
        p, pours = self.parameters, self.state['pours']
        thickness = measureBed(Snapshot.ofBodies(self.ids), self.container)['thickness']
        pours.append({'number': len(self.ids), 'thickness': thickness})
        better = nextCount(pours, p['thickness'], p['thicknessTolerance']) if p['particles'] is None else None
        if better is not None:
            self._say(f'thickness {1e3 * thickness:.2f} mm instead of {1e3 * p["thickness"]:.2f} mm: {better} particles are poured instead')
        return better

    def _stiffen(self):
        stiffen(self.stepper, self.parameters['softening'], self.parameters['timeStepFraction'], self._layers(), self.state['rampStage'],
                lambda done: self.state.update(rampStage=done))
        self.state['stage'] = 'rest'

    def _rest(self):
        criterion = self._criterion(TRUE_QUIET, TRUE_SUPPORT)
        self.state['settled']['true'] = settle(self.stepper, criterion, REST_STEPS * self._layers() * O.dt)
        self.state['settling'] = {}
        self._say(f'at rest: kinetic energy {criterion.kineticEnergy():.1e} m g d per particle, support '
                  f'{criterion.supportedWeight():.4f} of the weight')
        self.state['stage'] = 'measure'

    def _measure(self):
        container = setHeight(self.container, self.parameters['containerHeight'])
        before = Snapshot.ofBodies(self.ids)
        before.save(self.path(report.BEFORE))
        self.state.update(bed=measureBed(before, container), container=container._asdict(), stage='prepare')

    def _prepare(self):
        """The bed gets what is special in this impact."""
        p = self.parameters
        if 'bare' not in self.state:
            bare = bareImpact(p['impactorDiameter'], p['impactorDensity'], CurvatureMat(**materialOf(p)), p['speed'],
                              p['dropHeight'], p['gravity'], p['baseYoung'])
            self.state['bare'] = {'pulse': bare.pulse._asdict(), 'times': bare.times, 'forces': bare.forces}
            engine(InteractionLoop).lawDispatcher.functors[0].updateAttrs({name: p[name] for name in ('overlapLimit', 'leverArms')})
            if p['baseYoung'] is not None:
                setYoung(O.bodies[self.container.baseId], p['baseYoung'])
        if p['baseYoung'] is not None:
            self.state['settled']['true'] = settle(self.stepper, self._criterion(TRUE_QUIET, TRUE_SUPPORT), REST_STEPS * self._layers() * O.dt)
            self.state['settling'] = {}
        self.state['stage'] = 'static'

    def _static(self):
        samples, supports = self.state['staticForces'], ([self.container.baseId], self.container.sideIds)
        O.dt = self._timeStep()
        self.stepper.run(STATIC_STEPS, lambda: samples.append([supportForce(ids) for ids in supports]))
        self.state['staticForce'], self.state['staticWallForce'] = (sum(forces) / len(forces) for forces in zip(*samples))
        self._addImpactor()
        self.state.update(stage='impact', startTime=O.time)

    def _addImpactor(self):
        p = self.parameters
        impactor = addImpactor(p['impactorDiameter'], p['impactorDensity'], O.materials['particles'], p['speed'], p['dropHeight'],
                               self.state['bed']['thickness'], self.ids, p['gravity'], (p['impactorX'], p['impactorY']))
        self.state['impactor'] = impactor
        self.state['impactorStart'] = list(O.bodies[impactor].state.pos)
        O.trackEnergy = True

    def _impact(self):
        self._openRecord()
        static = self.state['staticForce']
        self.state['impactOver'] = recordImpact(self.stepper, self.recorder, static, self.parameters['maxImpactTime'], self.film)
        self._writeRecord()
        measured = pulse(self.recorder.column('time'), self.recorder.column('baseForce'), static)
        self.state.update(pulse=measured._asdict(), stage='report')

    def _report(self):
        self._openRecord()
        self.summary = report.write(self)
        self.state['stage'] = 'done'

    def _openRecord(self):
        """Make the recorder, with what an interrupted run has recorded."""
        if self.recorder is None:
            self.recorder = Recorder(self.container, self.state['impactor'], self.state['startTime'], self.state.pop('rows', ()))
        self.film = pictures.film(self)

    def _writeRecord(self):
        results.writeCsv(self.path(report.RECORD), Recorder.COLUMNS, self.recorder.rows)

    def _say(self, text):
        self.stepper.say(text)
