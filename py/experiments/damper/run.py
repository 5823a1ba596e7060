"""A particle damper: particles in a rigid box on a spring, under a harmonic force. One run is one frequency, from parameters to results,
in stages that can be interrupted and taken up again.

    DamperRun.begin({'frequency': 30.2}, 'results/30.2').run()
"""
import math
import random
import sys

from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import VibratingBoxEngine, VibrationRecorder

from . import report
from ...scene.walls import boxContainer
from .parameters import checked, makeMaterial, sampleSteps, shapeOf, startOf, timeStep
from ...scene.engines import engine, halfSizes, superquadricEngines
from ...scene.filling import rainFilling
from ...scene.settling import RestCriterion, settle
from ...runs.staged import StagedRun

RAIN_GAP = 0.05             # clear distance of the particles at the start, over their diameter: they have little way to fall
QUIET, SUPPORT = 1e-3, 0.1  # at rest before the drive, see RestCriterion: far below what the drive does to the particles
VERLET = 0.4                # margin of the collider over the smallest half size: few contacts, fast particles


class DamperRun(StagedRun):
    """A run in the folder `output`. Make it with `begin` or `resume`, then `run()`; `summary` holds the results."""

    STAGES = ('settle', 'release', 'drive', 'report')

    @classmethod
    def begin(cls, parameters, output, stream=sys.stderr):
        """Check `parameters` (a dict, see `damperparameters.PARAMETERS`), then build the scene; YADE's present scene is dropped, and so are
        the results of an earlier run in the folder.

        :raises ValueError: a bad parameter, or a folder that holds an interrupted run; before anything changes
        """
        state = {'parameters': checked(parameters), 'stage': 'settle', 'energies': [], 'settling': {'calm': True}}
        run = cls.inFolder(output, state, report.FILES, stream)
        run._build()
        return run

    @property
    def ids(self):
        """Of the particles."""
        return range(*self.state['particles'])

    @property
    def transientPeriods(self):
        return math.ceil(self.parameters['transientTime'] * self.parameters['frequency'])

    @property
    def stepsPerPeriod(self):
        return self.parameters['samples'] * sampleSteps(self.parameters)

    def _plan(self):
        """Expected steps of the stages, for the estimate of the time left."""
        periods = self.transientPeriods + self.parameters['periods'] - len(self.state['energies'])
        settling = 0.6 * self.parameters['settlingTime'] / timeStep(self.parameters) if self.state['stage'] == 'settle' else 0
        return {'settle': settling, 'release': 0, 'drive': periods * self.stepsPerPeriod, 'report': 0}

    def _build(self):
        """The scene: the box, held, with the particles on their way down, and the engines of all stages."""
        p = self.parameters
        material = makeMaterial(p, label='particles')
        O.reset()
        O.materials.append(material)
        container = boxContainer(p['boxWidth'], p['boxDepth'], p['boxHeight'], material)
        ids = rainFilling(particleShapes(p), container, material, p['seed'], gap=RAIN_GAP)[0] if p['particles'] else []
        box = VibratingBoxEngine(ids=[container.baseId, *container.sideIds], freeAxes='', mass=p['boxMass'], label='box',
                                 stiffness=alongAxis(p, p['stiffness']), damping=alongAxis(p, p['dashpot']))
        O.engines = [*superquadricEngines(gravity=(0, 0, -p['gravity']), verletDist=VERLET * min(halfSizes(), default=p['radius']), afterForces=[box],
                                          law=p['law']),
                     VibrationRecorder(box=box, particles=ids, iterPeriod=sampleSteps(p), initRun=True, dead=True)]
        O.dt = timeStep(p)
        self.state.update(particles=[min(ids), max(ids) + 1] if ids else [0, 0], supports=list(box.ids))

    def _settle(self):
        """The particles fall and come nearly to rest, while the box is held. How they get there does not matter here, so that YADE's non-viscous
        damping helps from the beginning ('calm', see `settle`)."""
        if self.ids:
            criterion = RestCriterion(self.ids, self.state['supports'], QUIET, SUPPORT, self.state['settling'])
            self.state['settled'] = settle(self.stepper, criterion, self.parameters['settlingTime'])
        self.state['stage'] = 'release'

    def _release(self):
        """The lid is put on, the box set free, and the force begins, at zero."""
        p, box = self.parameters, engine(VibratingBoxEngine)
        self._checkLid()
        lid = O.bodies.append(utils.wall((0, 0, p['boxHeight']), axis=2, sense=-1, material='particles'))
        box.ids = [*box.ids, lid]
        displacement, velocity = startOf(p)
        box.updateAttrs({'freeAxes': p['axis'], 'forceAmplitude': alongAxis(p, p['forceAmplitude']), 'frequency': p['frequency'],
                         'phase': -2 * math.pi * p['frequency'] * O.time, 'displacement': alongAxis(p, displacement),
                         'velocity': alongAxis(p, velocity)})
        engine(VibrationRecorder).dead = False
        O.trackEnergy = True
        self.state.update(stage='drive', startTime=O.time, restCentroid=list(centroid(self.ids)))

    def _checkLid(self):
        p = self.parameters
        top = max((O.bodies[i].state.pos[2] for i in self.ids), default=0.0) + shapeOf(p).boundingRadius
        if top > p['boxHeight']:
            raise ValueError(f'boxHeight = {p["boxHeight"]!r}: the settled particles reach {top:.4g} m; the lid does not go on')

    def _drive(self):
        energies = self.state['energies']
        while len(energies) < self.transientPeriods + self.parameters['periods']:
            self.stepper.run(self.stepsPerPeriod)
            energies.append(dict(O.energy.items()))
        self.state['stage'] = 'report'

    def _report(self):
        self.summary = report.write(self)
        self.state['stage'] = 'done'


def alongAxis(parameters, value):
    """A vector of length `value` along the axis on which the box moves."""
    return Vector3(*(value if axis == parameters['axis'] else 0 for axis in 'xyz'))


def particleShapes(parameters):
    """`ParticleShape` of every particle: normally distributed sizes, cut at radiusSpread."""
    shape, spread = shapeOf(parameters), parameters['radiusSpread']
    rng = random.Random(f'sizes {parameters["seed"]}')  # another sequence than the one that places the particles
    return [shape.scaled(1 + cutNormal(rng, spread)) if spread else shape for _ in range(parameters['particles'])]


def cutNormal(rng, limit):
    """Normally distributed with a standard deviation of `limit`/3, drawn again beyond `limit`."""
    while abs(value := rng.gauss(0, limit / 3)) > limit:
        pass
    return value


def centroid(ids):
    """Centre of mass of bodies; Vector3 [m], zero without bodies."""
    states = [O.bodies[i].state for i in ids]
    mass = sum(state.mass for state in states)
    return sum((state.mass * state.pos for state in states), Vector3.Zero) / mass if mass else Vector3.Zero
