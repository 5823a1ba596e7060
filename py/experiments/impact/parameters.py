"""The parameters of an impact study: one list for command line, batch table, checks and summary.

The defaults are the case of Wang & Ji, Acta Phys. Sin. 67, 094501 (2018) that their Fig. 10 shows for cubes and H = 2.5 cm.
"""
import math

from yade.wrapper import CurvatureMat

from ... import checks
from ...scene.shapes import SHAPES, particleShape
from ...scene.container import Container, checkCylinder
from ...scene.contactlaws import LEVER_ARMS, OVERLAP_LIMIT
from ...scene.expectedbed import DEEP_FRACTION, DENSEST, particleNumber
from ...scene.rain import GAP, SIDEWAYS
from .impactor import CALIBRATED_DENSITY, CLEARANCE, speedAt, surfaceSpeed
from ...runs.parameters import Parameter, between, completed, count, defaultsOf, oneOf, optional, scopeOf, within
from ...scene.settlingrules import QUIET

BED, IMPACT = 'bed', 'impact'  # scopes: of the bed, and of what may differ from impact to impact on the same bed

PARAMETERS = (
    Parameter('shape', 'cube', '', oneOf(SHAPES), 'shape of the particles: ' + ', '.join(SHAPES), BED),
    Parameter('n1', None, '', optional(checks.exponent), 'exponent along z, instead of the shape\'s own', BED),
    Parameter('n2', None, '', optional(checks.exponent), 'exponent in the x-y plane, instead of the shape\'s own', BED),
    Parameter('aspect', 1.0, '', checks.positive, 'c/a, for ellipsoid, cylinder and block', BED),
    Parameter('radius', 5e-3, 'm', checks.positive, 'radius of the sphere that has the particle\'s volume', BED),
    Parameter('radiusSpread', 0.0, '', within(0, 1, False), 'radii are uniform within (1 - spread, 1 + spread) times radius; '
              '0: equal masses', BED),
    Parameter('thickness', 0.025, 'm', checks.positive, 'thickness H of the bed to aim at; the result is measured', BED),
    Parameter('particles', None, '', optional(count(1)), 'number of particles, instead of what thickness and '
              'solidFraction give', BED),
    Parameter('solidFraction', None, '', optional(between(0, DENSEST)), 'expected packing fraction of the bed, instead of an estimate from '
              'its thickness', BED),
    Parameter('containerDiameter', 0.19, 'm', checks.positive, 'inner diameter of the rigid cylinder', BED),
    Parameter('containerHeight', 0.3, 'm', checks.positive, 'height of the rigid cylinder', BED),
    Parameter('density', 2500.0, 'kg/m3', checks.positive, 'density of the particles', BED),
    Parameter('young', 1e9, 'Pa', checks.positive, 'Young\'s modulus of particles, container and impactor', BED),
    Parameter('poisson', 0.2, '', between(-1, 0.5), 'Poisson\'s ratio of the same', BED),
    Parameter('friction', 0.4, '', checks.notNegative, 'coefficient of sliding friction of the same', BED),
    Parameter('normalDamping', 0.1, '', within(0, 1, False), 'Cn of equation (6)', BED),
    Parameter('tangentialDamping', 0.1, '', checks.notNegative, 'Ct of equation (12)', BED),
    Parameter('rollingFriction', 0.002, '', checks.notNegative, 'mu_r of equation (13)', BED),
    Parameter('impactorDiameter', 0.05, 'm', checks.positive, 'diameter of the impactor, a sphere', IMPACT),
    Parameter('impactorDensity', CALIBRATED_DENSITY, 'kg/m3', checks.positive, 'its density; the default reproduces the '
              'paper\'s P0', IMPACT),
    Parameter('speed', 5.0, 'm/s', checks.notNegative, 'its downward speed V0 at dropHeight', IMPACT),
    Parameter('dropHeight', 0.3, 'm', checks.notNegative, 'height above the bed\'s surface at which it has that speed', IMPACT),
    Parameter('gravity', 9.81, 'm/s2', checks.positive, 'acceleration of gravity, down', BED),
    Parameter('rainSpeed', 0.5, 'm/s', checks.notNegative, 'initial downward speed of the particles', BED),
    Parameter('rainSideways', SIDEWAYS, '', checks.notNegative, 'largest horizontal speed of the rain over rainSpeed', BED),
    Parameter('rainGap', GAP, '', checks.notNegative, 'clear distance of the particles\' bounding spheres in the rain, over their diameter', BED),
    Parameter('softening', 100.0, '', within(1, 1e4), 'Young\'s modulus is divided by this while the bed is poured', BED),
    Parameter('timeStepFraction', 0.1, '', between(0, 1 + 1e-12), 'time step over the critical one (14); the paper: 0.1 at most', BED),
    Parameter('dt', None, 's', optional(checks.positive), 'time step of the impact, instead of timeStepFraction', IMPACT),
    Parameter('restEnergy', QUIET, '', checks.positive, 'kinetic energy per particle over m g d below which the poured bed is at rest', BED),
    Parameter('thicknessTolerance', 0.03, '', between(0, 1 + 1e-12), 'the bed is poured again with another number of particles until its thickness '
              'is within this part of the one aimed at; not where particles is given', BED),
    Parameter('maxSettlingTime', 3.0, 's', checks.positive, 'simulated time after which pouring ends in any case', BED),
    Parameter('impactorX', 0.0, 'm', checks.finite, 'where it falls: distance from the container\'s axis along x', IMPACT),
    Parameter('impactorY', 0.0, 'm', checks.finite, 'the same along y', IMPACT),
    Parameter('baseYoung', None, 'Pa', optional(checks.positive), 'Young\'s modulus of the base in the impact, instead of young', IMPACT),
    Parameter('overlapLimit', OVERLAP_LIMIT, '', between(0, 1), 'bound of the curvatures in the impact, see '
              'Law2_ScGeom_CurvaturePhys_HertzMindlin', IMPACT),
    Parameter('leverArms', LEVER_ARMS, '', checks.boolean, 'whether m* of the normal damping counts lever arms in the impact, see there', IMPACT),
    Parameter('maxImpactTime', 0.05, 's', checks.positive, 'simulated time after which the impact ends in any case', IMPACT),
    Parameter('seed', 1, '', count(0), 'seed of positions, orientations and sizes', BED),
)


def defaults():
    """{name: default} of all parameters."""
    return defaultsOf(PARAMETERS)


def bedPart(parameters):
    """Those of `parameters` (a complete dict) from which the bed is poured."""
    return scopeOf(parameters, PARAMETERS, BED)


def checked(values):
    """A complete, checked dict of parameters from `values` (missing ones take their defaults).

    :raises ValueError: an unknown name, or a value that cannot be, alone or with the others
    """
    result = completed(values, PARAMETERS)
    shape = shapeOf(result)
    checkCylinder(result['containerDiameter'] / 2, result['containerHeight'],
                  (1 + result['radiusSpread']) * shape.boundingRadius)
    _checkPlace(result)
    _checkCapacity(result, shape)
    _checkDrop(result, shape)
    _checkTimeStep(result)
    return result


def shapeOf(parameters):
    """The particles' `ParticleShape`."""
    return particleShape(parameters['shape'], parameters['radius'], parameters['aspect'], parameters['n1'],
                         parameters['n2'])


def materialOf(parameters):
    """Keyword arguments of the particles' CurvatureMat."""
    return dict(young=parameters['young'], poisson=parameters['poisson'], density=parameters['density'],
                frictionAngle=math.atan(parameters['friction']), normalDamping=parameters['normalDamping'],
                tangentialDamping=parameters['tangentialDamping'], rollingFriction=parameters['rollingFriction'])


def particleCount(parameters):
    """Number of particles that the parameters ask for."""
    if parameters['particles'] is not None:
        return parameters['particles']
    container = Container(None, (), parameters['containerDiameter'] / 2, None, None, parameters['containerHeight'])
    return particleNumber(parameters['thickness'], shapeOf(parameters), container, parameters['solidFraction'])


def _checkCapacity(parameters, shape):
    count = particleCount(parameters)
    bed = count * shape.volume / (parameters['solidFraction'] or DEEP_FRACTION) / (math.pi / 4 * parameters['containerDiameter'] ** 2)
    if bed > parameters['containerHeight']:
        name = 'thickness' if parameters['particles'] is None else 'particles'
        raise ValueError(f'{name} = {parameters[name]!r}: overfull container; {count} particles make a bed of '
                         f'{bed:.4g} m, containerHeight is {parameters["containerHeight"]!r} m')


def _checkPlace(parameters):
    """The impactor has to fall into the container."""
    x, y, diameter, container = (parameters[name] for name in ('impactorX', 'impactorY', 'impactorDiameter', 'containerDiameter'))
    if diameter > container:
        raise ValueError(f'impactorDiameter = {diameter!r}: larger than the container ({container!r} m)')
    if math.hypot(x, y) + diameter / 2 > container / 2:
        name = 'impactorX' if abs(x) > abs(y) else 'impactorY'
        raise ValueError(f'{name} = {parameters[name]!r}: the impactor ({diameter!r} m) would meet the wall of the container ({container!r} m)')


def _checkDrop(parameters, shape):
    """The impactor has to start above the particles: some stand out of the surface, by two of the largest at most."""
    if surfaceSpeed(parameters['speed'], parameters['dropHeight'], parameters['gravity']) == 0:
        raise ValueError(f'speed = {parameters["speed"]!r}: with dropHeight = {parameters["dropHeight"]!r} the impactor reaches the bed without '
                         f'speed')
    highest = CLEARANCE + 4 * (1 + parameters['radiusSpread']) * shape.boundingRadius
    speedAt(highest, parameters['speed'], parameters['dropHeight'], parameters['gravity'])


def criticalImpactStep(parameters):
    """The smaller of the critical time steps (14) [s] of the smallest particle and of the impactor, in the impact."""
    material = materialOf(parameters)
    particle = (1 - parameters['radiusSpread']) * min(shapeOf(parameters).extents)
    impactor = CurvatureMat(**{**material, 'density': parameters['impactorDensity']})
    return min(CurvatureMat(**material).criticalTimeStep(particle), impactor.criticalTimeStep(parameters['impactorDiameter'] / 2))


def _checkTimeStep(parameters):
    critical = criticalImpactStep(parameters)
    if parameters['dt'] is not None and parameters['dt'] > critical:
        raise ValueError(f'dt = {parameters["dt"]!r}: above the critical time step {critical:.4g} s (eq. 14)')
