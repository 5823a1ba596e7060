"""The parameters of an oedometer test: one list for command line, checks and summary.

The defaults are a rockfill of 20 to 40 mm (the sizes of Zhao & Chi, J. Northeastern Univ. Nat. Sci. 44(3), 408-414 (2023)); the part of that
paper that gives its specimen is lost in our copy. Young's modulus is softened (docs/oedometer.md).
"""
import math

from yade.wrapper import BreakableMat, CurvatureMat

from ... import checks
from ...scene.shapes import SHAPES, particleShape
from ...scene.expectedbed import DEEP_FRACTION
from ...runs.parameters import Parameter, between, completed, count, defaultsOf, oneOf, optional, scopeOf, within
from ...scene.restitution import normalDampingFor

BED, TEST = 'bed', 'test'  # scopes: of the bed, and of what is done to it
CONTAINERS = ('box', 'cylinder')
MODES = ('cube', 'balls4', 'balls18', 'none')
CRITERIA = ('force', 'octahedral')
LOOSE_FRACTION = 0.5  # no bed that was rained in is looser: for the container's height


PARAMETERS = (
    Parameter('shape', 'sphere', '', oneOf(SHAPES), 'shape of the particles: ' + ', '.join(SHAPES), BED),
    Parameter('n1', None, '', optional(checks.exponent), 'exponent along z, instead of the shape\'s own', BED),
    Parameter('n2', None, '', optional(checks.exponent), 'exponent in the x-y plane, instead of the shape\'s own', BED),
    Parameter('aspect', 1.0, '', checks.positive, 'c/a, for ellipsoid, cylinder and block', BED),
    Parameter('particles', 1500, '', count(1), 'number of particles', BED),
    Parameter('smallestDiameter', 0.02, 'm', checks.positive, 'sizes (diameters of the spheres of the particles\' volumes) are uniformly '
              'distributed by number, from this one ...', BED),
    Parameter('largestDiameter', 0.04, 'm', checks.positive, '... to this one', BED),
    Parameter('container', 'box', '', oneOf(CONTAINERS), 'box (of square section) or cylinder', BED),
    Parameter('width', 0.36, 'm', checks.positive, 'inner width of the box, or diameter of the cylinder', BED),
    Parameter('density', 2700.0, 'kg/m3', checks.positive, 'density of the particles', BED),
    Parameter('young', 2e9, 'Pa', checks.positive, 'Young\'s modulus of particles, container and plate', BED),
    Parameter('poisson', 0.25, '', between(-1, 0.5), 'Poisson\'s ratio of the same', BED),
    Parameter('friction', 0.5, '', checks.notNegative, 'coefficient of sliding friction between particles', BED),
    Parameter('wallFriction', 0.0, '', checks.notNegative, 'the same with container and plate', BED),
    Parameter('rollingFriction', 0.01, '', checks.notNegative, 'mu_r of equation (13)', BED),
    Parameter('restitution', 0.5, '', checks.finite, 'restitution coefficient of the viscous normal force, from which its damping (and the '
              'tangential one) follows', BED),
    Parameter('gravity', 9.81, 'm/s2', checks.positive, 'acceleration of gravity, along -z', BED),
    Parameter('settlingTime', 2.0, 's', checks.positive, 'simulated time after which the rain counts as settled in any case', BED),
    Parameter('seatingStress', 1e4, 'Pa', checks.positive, 'axial stress under which the plate is put on; strain counts from there', BED),
    Parameter('timeStepFraction', 0.3, '', between(0, 1), 'time step over the critical one (14) of the smallest particle', BED),
    Parameter('seed', 1, '', count(0), 'seed of positions, orientations and sizes', BED),
    Parameter('mode', 'cube', '', oneOf(MODES), 'how particles break: ' + ', '.join(MODES), TEST),
    Parameter('criterion', 'octahedral', '', oneOf(CRITERIA), 'when: ' + ', '.join(CRITERIA), TEST),
    Parameter('characteristicStrength', 6e6, 'Pa', checks.positive, 'that the part 1/e of the particles of referenceSize survive', TEST),
    Parameter('referenceSize', 0.03, 'm', checks.positive, 'size of particles to which it belongs', TEST),
    Parameter('weibullModulus', 3.0, '', checks.positive, 'of the strengths\' scatter; strength goes as size^(-3/modulus)', TEST),
    Parameter('smallestSize', 0.01, 'm', checks.positive, 'particles below do not break', TEST),
    Parameter('smallestFragment', 1e-3, 'm', checks.notNegative, 'no fragment is smaller (no width of one, if it is not a sphere): such a '
              'cut is drawn again', TEST),
    Parameter('cutExponent', 2.0, '', checks.positive, 'p of the cube\'s cut: u^p, u uniform', TEST),
    Parameter('maxEvents', 100, '', count(1), 'particles that break in one step, at most', TEST),
    Parameter('breakageSeed', None, '', optional(count(0)), 'seed of strengths, cuts and orientations of the fragments; default: the bed\'s', TEST),
    Parameter('inertialSize', 0.01, 'm', checks.positive, 'fragments of a smaller width get the inertia with which their critical time step is that '
              'of this width', TEST),
    Parameter('strainRate', 1.0, '1/s', checks.positive, 'largest axial strain rate', TEST),
    Parameter('inertialNumber', 2e-3, '', checks.positive, 'the plate is slower where the inertial number would be above', TEST),
    Parameter('damping', 0.3, '', within(0, 1, False), 'YADE\'s non-viscous damping', TEST),
    Parameter('maxStress', 3e6, 'Pa', checks.positive, 'axial stress at which the test ends', TEST),
    Parameter('maxStrain', 0.3, '', between(0, 1), 'axial strain at which it ends', TEST),
    Parameter('maxParticles', None, '', optional(count(1)), 'number of particles at which it ends', TEST),
    Parameter('sampleStrain', 5e-4, '', between(0, 1), 'strain between two records', TEST),
)


def defaults():
    """{name: default} of all parameters."""
    return defaultsOf(PARAMETERS)


def bedPart(parameters):
    """Those of `parameters` (a complete dict) from which the bed is made."""
    return scopeOf(parameters, PARAMETERS, BED)


def checked(values):
    """A complete, checked dict of parameters from `values` (missing ones take their defaults).

    :raises ValueError: an unknown name, or a value that cannot be, alone or with the others
    """
    result = completed(values, PARAMETERS)
    normalDampingFor(result['restitution'])
    _checkSizes(result)
    _checkEnd(result)
    if result['mode'] in ('balls4', 'balls18') and not shapeOf(result, 1.0).asSphere:
        raise ValueError(f'mode = {result["mode"]!r}: for spheres only; other shapes break by the mode cube')
    return result


def _checkSizes(p):
    if p['smallestDiameter'] > p['largestDiameter']:
        raise ValueError(f'smallestDiameter = {p["smallestDiameter"]!r}: above largestDiameter = {p["largestDiameter"]!r}')
    largest = shapeOf(p, p['largestDiameter']).boundingRadius
    if p['width'] < 2 * largest:
        raise ValueError(f'width = {p["width"]!r}: the container is smaller than a particle (bounding diameter {2 * largest:g} m)')
    if p['smallestFragment'] > p['smallestDiameter'] / 2:
        raise ValueError(f'smallestFragment = {p["smallestFragment"]!r}: above half of smallestDiameter = {p["smallestDiameter"]!r}; such '
                         f'particles cannot be cut into eight')


def _checkEnd(p):
    if p['maxStress'] <= p['seatingStress']:
        raise ValueError(f'maxStress = {p["maxStress"]!r}: not above seatingStress = {p["seatingStress"]!r}')
    if p['maxParticles'] is not None and p['maxParticles'] <= p['particles']:
        raise ValueError(f'maxParticles = {p["maxParticles"]!r}: not above particles = {p["particles"]!r}')


def shapeOf(parameters, diameter):
    """`ParticleShape` of a particle of that `diameter` (of the sphere of its volume) [m]."""
    return particleShape(parameters['shape'], diameter / 2, parameters['aspect'], parameters['n1'], parameters['n2'])


def meanCube(parameters):
    """Mean of the cube of the particles' diameters [m3]; uniform distribution."""
    low, high = parameters['smallestDiameter'], parameters['largestDiameter']
    return (low + high) * (low * low + high * high) / 4


def section(parameters):
    """Inner cross section of the container [m2]."""
    return parameters['width'] ** 2 * (1 if parameters['container'] == 'box' else math.pi / 4)


def containerHeight(parameters):
    """Height [m] that holds the settled bed in any case."""
    solid = parameters['particles'] * math.pi / 6 * meanCube(parameters)
    return solid / (LOOSE_FRACTION * section(parameters)) * DEEP_FRACTION / LOOSE_FRACTION + 2 * shapeOf(
        parameters, parameters['largestDiameter']).boundingRadius


def materialOf(parameters):
    """Keyword arguments of the particles' BreakableMat, as long as they do not break."""
    damping = normalDampingFor(parameters['restitution'])
    return dict(young=parameters['young'], poisson=parameters['poisson'], density=parameters['density'],
                frictionAngle=math.atan(parameters['friction']), normalDamping=damping, tangentialDamping=damping,
                rollingFriction=parameters['rollingFriction'])


def strengthOf(parameters):
    """Attributes of the particles' BreakableMat that make them break."""
    return {name: parameters[name] for name in ('characteristicStrength', 'referenceSize', 'weibullModulus', 'smallestSize')}


def breakageSeed(parameters):
    """Seed of strengths and cuts: unless it is given, another bed has other strengths."""
    return parameters['seed'] if parameters['breakageSeed'] is None else parameters['breakageSeed']


def timeStepOf(parameters, size):
    """Time step [s] for particles of `size` (diameter of the sphere of the same volume) [m]."""
    return parameters['timeStepFraction'] * CurvatureMat(**materialOf(parameters)).criticalTimeStep(size / 2)


def bedTimeStep(parameters):
    """Time step [s] before anything breaks."""
    return timeStepOf(parameters, 2 * min(shapeOf(parameters, parameters['smallestDiameter']).extents))


def testTimeStep(parameters):
    """Time step [s] of the test: fragments below inertialSize are as slow as those of that width."""
    smallest = bedTimeStep(parameters)
    return smallest if parameters['mode'] == 'none' else min(smallest, timeStepOf(parameters, parameters['inertialSize']))


def newMaterials(parameters):
    """The materials of particles and walls, not yet in the scene."""
    common = materialOf(parameters)
    return (BreakableMat(**common, label='particles'),
            CurvatureMat(**{**common, 'frictionAngle': math.atan(parameters['wallFriction'])}, label='walls'))
