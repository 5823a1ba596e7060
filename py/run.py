"""One impact study from its parameters to its results, in stages that can be interrupted and taken up again."""
import math
import os
import random
import sys
import time

from yade import O
from yade.wrapper import CurvatureMat

from . import report, results, study
from .bedgeometry import measureBed
from .container import Container, cylinderContainer, setHeight
from .engines import criticalTimeStep, superquadricEngines
from .filling import rainFilling
from .impact import Recorder, addImpactor, bareImpact, recordImpact, supportForce
from .settling import QUIET, SUPPORT, TRUE_QUIET, TRUE_SUPPORT, RestCriterion, rampSteps, settle, stiffen
from .snapshot import Snapshot
from .stepping import Interrupted, Stepper

SCENE, STATE, RECORD = 'checkpoint.yade.gz', 'checkpoint.json', 'force.csv'
STATIC_STEPS = 200  # time steps over which the base's force is averaged before the impact


class ImpactRun:
    """A run in the folder `output`. Make it with `begin` or `resume`, then `run()`; `summary` holds the results.

    :ivar state: what a resumed run has to know beside the scene; plain numbers, lists and dicts
    """

    STAGES = ('pour', 'stiffen', 'rest', 'static', 'impact')

    def __init__(self, output, state, stream=sys.stderr):
        self.output, self.state, self.stream = output, state, stream
        self.parameters = state['parameters']
        self.summary = None

    @classmethod
    def begin(cls, parameters, output, stream=sys.stderr):
        """Check `parameters` (a dict, see `study.PARAMETERS`), then build the scene; YADE's present scene is dropped.

        :raises ValueError: before anything changes
        """
        parameters = study.checked(parameters)
        os.makedirs(output, exist_ok=True)
        run = cls(output, {'parameters': parameters, 'stage': 'pour', 'seconds': 0.0}, stream)
        run._build()
        return run

    @classmethod
    def resume(cls, output, stream=sys.stderr):
        """Take up the interrupted run in the folder `output`."""
        statePath, scenePath = (os.path.join(output, name) for name in (STATE, SCENE))
        if not (os.path.exists(statePath) and os.path.exists(scenePath)):
            raise ValueError(f'output = {output!r}: there is no checkpoint of an interrupted run to resume')
        run = cls(output, results.readJson(statePath), stream)
        O.load(scenePath)
        return run

    @property
    def container(self):
        return Container(**self.state['container'])

    @property
    def ids(self):
        first, last = self.state['particles']
        return range(first, last + 1)

    def path(self, name):
        return os.path.join(self.output, name)

    def run(self, until='done'):
        """Do all stages that are left, write the results, return the summary.

        :param until: a later one of `STAGES`: stop before it, leave a checkpoint for `resume`, return None
        :raises Interrupted: after Ctrl-C, with checkpoint and data so far written
        """
        start = time.perf_counter()
        with Stepper(self._plan(), self.stream) as self.stepper:
            try:
                while self.state['stage'] != until:
                    self.stepper.begin(self.state['stage'])
                    getattr(self, '_' + self.state['stage'])()
            except Interrupted:
                self.state['seconds'] += time.perf_counter() - start
                self.save()
                raise
        self.state['seconds'] += time.perf_counter() - start
        if until != 'done':
            self.save()
            return None
        report.write(self)
        return self.summary

    def save(self):
        """Write the checkpoint, and the record as far as there is one."""
        recorder = getattr(self, 'recorder', None)
        if recorder is not None:
            results.writeCsv(self.path(RECORD), Recorder.COLUMNS, recorder.rows)
        O.save(self.path(SCENE))
        results.writeJson(self.path(STATE), self.state)

    def _plan(self):
        """Expected steps of the stages, for the estimate of the time left."""
        soft = self.parameters['softening'] > 1
        done = self.STAGES[:self.STAGES.index(self.state['stage'])]
        steps = {'pour': max(self.state['pourTime'] - O.time, 0) / O.dt if 'pour' not in done else 0,
                 'stiffen': sum(rampSteps(self.parameters['softening'])) if soft else 0, 'rest': 900, 'static': STATIC_STEPS,
                 'impact': 0.012 / self._timeStep()}
        return {stage: count for stage, count in steps.items() if stage not in done}

    def _timeStep(self):
        if self.parameters['dt'] is not None:
            return self.parameters['dt']
        shape = study.shapeOf(self.parameters)
        return self.parameters['timeStepFraction'] * (1 - self.parameters['radiusSpread']) * CurvatureMat(
            **study.materialOf(self.parameters)).criticalTimeStep(min(shape.extents))

    def _build(self):
        p, shape = self.parameters, study.shapeOf(self.parameters)
        O.reset()
        bare = bareImpact(p['impactorDiameter'], p['impactorDensity'], CurvatureMat(**study.materialOf(p)), p['speed'],
                          p['dropHeight'], p['gravity'])
        self.state['bare'] = {'pulse': bare.pulse._asdict(), 'times': bare.times, 'forces': bare.forces}
        material = CurvatureMat(**{**study.materialOf(p), 'young': p['young'] / p['softening']}, label='particles')
        O.materials.append(material)
        rng = random.Random(p['seed'])
        shapes = [shape.scaled(1 + p['radiusSpread'] * (2 * rng.random() - 1)) if p['radiusSpread'] else shape
                  for _ in range(study.particleCount(p))]
        container = cylinderContainer(p['containerDiameter'] / 2, p['containerHeight'], material, shape.boundingRadius)
        ids, container = rainFilling(shapes, container, material, p['seed'], p['rainSpeed'], p['solidFraction'])
        O.engines = superquadricEngines(gravity=(0, 0, -p['gravity']))
        O.dt = p['timeStepFraction'] * criticalTimeStep()
        top = max(O.bodies[i].state.pos[2] for i in ids)
        self.state.update(container=container._asdict(), particles=[ids[0], ids[-1]], rampStage=0,
                          pourTime=math.sqrt(2 * top / p['gravity']) + 0.3, settled={})

    def _criterion(self, quiet=QUIET, support=SUPPORT):
        return RestCriterion(self.ids, (self.container.baseId, *self.container.sideIds), quiet, support)

    def _pour(self):
        left = self.parameters['maxSettlingTime'] - O.time
        criterion = self._criterion()
        self.state['settled']['soft'] = left > 0 and settle(self.stepper, criterion, left)
        self._say(f'poured {len(self.ids)} particles: kinetic energy {criterion.kineticEnergy():.1e} m g d per particle, '
                  f'support {criterion.supportedWeight():.3f} of the weight, t = {O.time:.3f} s')
        self.state['stage'] = 'stiffen' if self.parameters['softening'] > 1 else 'rest'

    def _stiffen(self):
        stiffen(self.stepper, self.parameters['softening'], self.parameters['timeStepFraction'],
                self.state['rampStage'], lambda done: self.state.update(rampStage=done))
        self.state['stage'], self.state['restStart'] = 'rest', O.time

    def _rest(self):
        criterion = self._criterion(TRUE_QUIET, TRUE_SUPPORT)
        limit = 10000 * O.dt
        left = self.state.setdefault('restStart', O.time) + limit - O.time
        self.state['settled']['true'] = left > 0 and settle(self.stepper, criterion, left)
        self._say(f'at rest: kinetic energy {criterion.kineticEnergy():.1e} m g d per particle, support '
                  f'{criterion.supportedWeight():.4f} of the weight')
        self.state['stage'] = 'static'

    def _static(self):
        base, wall = [], []
        O.dt = self._timeStep()
        self.stepper.run(STATIC_STEPS, lambda: (base.append(supportForce([self.container.baseId])),
                                                wall.append(supportForce(self.container.sideIds))))
        self.state['staticForce'], self.state['staticWallForce'] = sum(base) / len(base), sum(wall) / len(wall)
        container = setHeight(self.container, self.parameters['containerHeight'])
        before = Snapshot.ofBodies(self.ids)
        self.state['bed'] = measureBed(before, container)
        before.save(self.path('before.npz'))
        self._addImpactor(container)
        self.state.update(container=container._asdict(), stage='impact', startTime=O.time)

    def _addImpactor(self, container):
        p = self.parameters
        impactor = addImpactor(p['impactorDiameter'], p['impactorDensity'], O.materials['particles'], p['speed'],
                               p['dropHeight'], self.state['bed']['thickness'], self.ids, p['gravity'])
        self.state['impactor'] = impactor
        self.state['impactorStart'] = list(O.bodies[impactor].state.pos)
        O.trackEnergy = True

    def _impact(self):
        rows = results.readCsv(self.path(RECORD))[1] if self.state.get('recorded') else ()
        self.recorder = Recorder(self.container, self.state['impactor'], self.state['startTime'], rows)
        self.state['recorded'] = True
        self.state['impactOver'] = recordImpact(self.stepper, self.recorder, self.state['staticForce'],
                                                self.parameters['maxImpactTime'])
        self.state['stage'] = 'done'

    def removeCheckpoint(self):
        """The run is done: a checkpoint of it would only mislead."""
        for name in (SCENE, STATE):
            if os.path.exists(self.path(name)):
                os.remove(self.path(name))

    def _say(self, text):
        self.stepper.say(text)
