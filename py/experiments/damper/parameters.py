"""The parameters of a particle damper: one list for command line, checks and summary.

The defaults are the system of Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39(8), 1211-1216 (2018). Its table of contact parameters
is lost in our copy: tangential and rolling damping, rolling friction and the width of the size distribution are choices. Of its material
E = 70 GPa, nu = 0.33 and 2700 kg/m3 are known; the shipped aluminium alloy comes near.
"""
import math

from yade.wrapper import CurvatureMat

from ... import checks
from ...scene.shapes import SHAPES, particleShape
from ...scene.contactlaws import CONTACT_LAWS
from ...scene.expectedbed import DEEP_FRACTION
from ...materials.elastoplastic import elastoplasticMat
from ...materials.shipped import materialAt, properties
from ...runs.parameters import Parameter, between, completed, count, defaultsOf, oneOf, optional, within
from ...scene.restitution import collisionDuration, normalDampingFor

BOX, DRIVE = 'box', 'drive'  # scopes: of what the box holds, and of what is done to it
STARTS = ('steady', 'rest')
OF_THE_MATERIAL = ('density', 'young', 'poisson')  # parameters that the material gives unless they are given themselves


PARAMETERS = (
    Parameter('shape', 'sphere', '', oneOf(SHAPES), 'shape of the particles: ' + ', '.join(SHAPES), BOX),
    Parameter('n1', None, '', optional(checks.exponent), 'exponent along z, instead of the shape\'s own', BOX),
    Parameter('n2', None, '', optional(checks.exponent), 'exponent in the x-y plane, instead of the shape\'s own', BOX),
    Parameter('aspect', 1.0, '', checks.positive, 'c/a, for ellipsoid, cylinder and block', BOX),
    Parameter('particles', 2000, '', count(0), 'number of particles', BOX),
    Parameter('radius', 1e-3, 'm', checks.positive, 'mean radius of the spheres that have the particles\' volumes', BOX),
    Parameter('radiusSpread', 0.01, '', within(0, 1, False), 'radii lie within (1 - spread, 1 + spread) times radius: normally distributed with '
              'a third of that as standard deviation, and cut', BOX),
    Parameter('particleMass', None, 'kg', optional(checks.positive), 'total mass of the particles, instead of what their density gives', BOX),
    Parameter('boxWidth', 0.042, 'm', checks.positive, 'inner size of the box along x', BOX),
    Parameter('boxDepth', 0.042, 'm', checks.positive, 'the same along y', BOX),
    Parameter('boxHeight', 0.024, 'm', checks.positive, 'the same along z', BOX),
    Parameter('law', 'elastoplastic', '', oneOf(CONTACT_LAWS), 'contact law: ' + ', '.join(CONTACT_LAWS), BOX),
    Parameter('material', 'aluminium-2024-T351', '', materialAt, 'of particles and box: a shipped material, or a material file', BOX),
    Parameter('density', None, 'kg/m3', optional(checks.positive), 'density of the particles, instead of the material\'s', BOX),
    Parameter('young', None, 'Pa', optional(checks.positive), 'Young\'s modulus of particles and box, instead of the material\'s', BOX),
    Parameter('poisson', None, '', optional(between(-1, 0.5)), 'Poisson\'s ratio of the same, instead of the material\'s', BOX),
    Parameter('friction', 0.5, '', checks.notNegative, 'coefficient of sliding friction of the same', BOX),
    Parameter('restitution', 0.5, '', checks.finite, 'restitution coefficient of the viscous normal force, from which its damping follows', BOX),
    Parameter('tangentialDamping', None, '', optional(checks.notNegative), 'Ct of equation (12), instead of the normal one\'s value', BOX),
    Parameter('rollingFriction', 0.002, '', checks.notNegative, 'mu_r of equation (13)', BOX),
    Parameter('rollingDamping', 0.3, '', checks.notNegative, 'damping of rolling as a part of the critical one (elastoplastic law)', BOX),
    Parameter('gravity', 9.81, 'm/s2', checks.positive, 'acceleration of gravity, along -z', BOX),
    Parameter('softening', 1.0, '', within(1, 1e4), 'Young\'s modulus is divided by this, for longer time steps', BOX),
    Parameter('settlingTime', 0.15, 's', checks.positive, 'simulated time after which the drive begins in any case', BOX),
    Parameter('boxMass', 0.3, 'kg', checks.positive, 'mass of the box', DRIVE),
    Parameter('stiffness', 9720.0, 'N/m', checks.notNegative, 'of the spring', DRIVE),
    Parameter('dashpot', 0.0, 'N s/m', checks.notNegative, 'viscous damping of the box itself', DRIVE),
    Parameter('axis', 'z', '', oneOf(('x', 'y', 'z')), 'along which the box moves: z is along gravity', DRIVE),
    Parameter('forceAmplitude', 9.72, 'N', checks.positive, 'of the driving force', DRIVE),
    Parameter('frequency', 25.5, 'Hz', checks.positive, 'of the driving force', DRIVE),
    Parameter('start', 'steady', '', oneOf(STARTS), 'how the box begins: \'steady\', on the response of the empty box (that of the box with the '
              'particles frozen to it where these are not thrown); \'rest\', from which it takes the free vibration long to die out', DRIVE),
    Parameter('transientTime', 1.0, 's', checks.notNegative, 'of the drive before the measurement, rounded up to whole periods', DRIVE),
    Parameter('periods', 30, '', count(2), 'of the drive that are measured', DRIVE),
    Parameter('samples', 200, '', count(20), 'records of the motion per period', DRIVE),
    Parameter('stepsPerCollision', 20.0, '', checks.positive, 'time steps in an elastic collision of two of the smallest particles', DRIVE),
    Parameter('collisionSpeed', 1.0, 'm/s', checks.positive, 'their speed of approach', DRIVE),
    Parameter('timeStepFraction', 0.3, '', between(0, 1), 'time step over the critical one (14), at most', DRIVE),
    Parameter('seed', 1, '', count(0), 'seed of positions, orientations and sizes', BOX),
)


def defaults():
    """{name: default} of all parameters."""
    return defaultsOf(PARAMETERS)


def checked(values):
    """A complete, checked dict of parameters from `values` (missing ones take their defaults).

    :raises ValueError: an unknown name, or a value that cannot be, alone or with the others
    """
    result = completed(values, PARAMETERS)
    known = properties(result['material'])
    result.update({name: known[name] for name in OF_THE_MATERIAL if result[name] is None})
    makeMaterial(result)
    _checkRoom(result)
    return result


def _checkRoom(parameters):
    """The settled particles have to leave room below the lid."""
    shape = shapeOf(parameters)
    largest = (1 + parameters['radiusSpread']) * shape.boundingRadius
    for name in ('boxWidth', 'boxDepth', 'boxHeight'):
        if parameters[name] < 2 * largest:
            raise ValueError(f'{name} = {parameters[name]!r}: the box is smaller than a particle (bounding diameter {2 * largest:g} m)')
    if filling(parameters) > DEEP_FRACTION:
        raise ValueError(f'particles = {parameters["particles"]!r}: overfull box; they fill {filling(parameters):.3g} of it, and pack to '
                         f'{DEEP_FRACTION:g} at most')


def shapeOf(parameters):
    """The particles' mean `ParticleShape`."""
    return particleShape(*(parameters[name] for name in ('shape', 'radius', 'aspect', 'n1', 'n2')))


def boxVolume(parameters):
    """Inner volume of the box [m3]."""
    return parameters['boxWidth'] * parameters['boxDepth'] * parameters['boxHeight']


def filling(parameters):
    """Volume of the particles, with the mean size, over that of the box [-]."""
    return parameters['particles'] * shapeOf(parameters).volume / boxVolume(parameters)


def densityOf(parameters):
    """Density of the particles [kg/m3]; with particleMass the one that gives it with the mean size."""
    if parameters['particleMass'] is None or parameters['particles'] == 0:
        return parameters['density']
    return parameters['particleMass'] / (parameters['particles'] * shapeOf(parameters).volume)


def elasticOf(parameters):
    """Keyword arguments of the material that both laws have."""
    p, normalDamping = parameters, normalDampingFor(parameters['restitution'])
    return dict(young=p['young'] / p['softening'], poisson=p['poisson'], density=densityOf(p), frictionAngle=math.atan(p['friction']),
                normalDamping=normalDamping, tangentialDamping=normalDamping if p['tangentialDamping'] is None else p['tangentialDamping'],
                rollingFriction=p['rollingFriction'])


def makeMaterial(parameters, **others):
    """The material of particles and box.

    Softening divides the yield stress by its power 4/5: the speed at which a collision begins to yield is as sigma_y^(5/2)/(E^2 density^(1/2))
    (Johnson 1985, section 11.5), and with it the restitution at any speed, stays.
    """
    p, common = parameters, {**elasticOf(parameters), **others}
    if p['law'] == 'curvature':
        return CurvatureMat(**common)
    known = properties(p['material'])
    yieldStress = known['yieldStress'] * p['softening'] ** -0.8
    if yieldStress >= common['young']:
        raise ValueError(f'young = {p["young"]!r}: with softening = {p["softening"]:g} it is {common["young"]:g} Pa, not above the yield stress of '
                         f'{p["material"]!r}, then {yieldStress:g} Pa')
    return elastoplasticMat({**known, 'yieldStress': yieldStress}, **{'rollingDamping': p['rollingDamping'], **common})


def collisionTime(parameters):
    """Duration [s] of an elastic collision of two of the smallest particles at collisionSpeed."""
    radius = (1 - parameters['radiusSpread']) * min(shapeOf(parameters).extents)
    material = elasticOf(parameters)
    mass = 4 / 3 * math.pi * material['density'] * radius ** 3
    modulus = material['young'] / (2 * (1 - material['poisson'] ** 2))
    return collisionDuration(mass / 2, radius / 2, modulus, parameters['collisionSpeed'])


def criticalStep(parameters):
    """Critical time step (14) [s] of the smallest particle."""
    smallest = (1 - parameters['radiusSpread']) * min(shapeOf(parameters).extents)
    return CurvatureMat(**elasticOf(parameters)).criticalTimeStep(smallest)


def sampleSteps(parameters):
    """Time steps between two records: as many as keep the time step below both bounds while a period has a whole number of records."""
    longest = min(collisionTime(parameters) / parameters['stepsPerCollision'], parameters['timeStepFraction'] * criticalStep(parameters))
    return math.ceil(1 / (parameters['frequency'] * parameters['samples'] * longest))


def timeStep(parameters):
    """Time step of the drive [s]."""
    return 1 / (parameters['frequency'] * parameters['samples'] * sampleSteps(parameters))


def startOf(parameters):
    """Displacement [m] and velocity [m/s] of the box when the force begins.

    'steady': those of Im(A exp(i omega t)) at t = 0, with the closed form A = F/(k - M omega^2 + i c omega), cut at the height of the box. M is
    the box alone, or with the particles where then its acceleration stays below gravity, so that they are not thrown.
    """
    p, omega = parameters, 2 * math.pi * parameters['frequency']
    if p['start'] == 'rest':
        return 0.0, 0.0
    for mass in (p['boxMass'] + massOf(p), p['boxMass']):
        ratio = complex(p['stiffness'] - mass * omega ** 2, p['dashpot'] * omega)
        size = p['forceAmplitude'] / max(abs(ratio), p['forceAmplitude'] / p['boxHeight'])
        if size * omega ** 2 < p['gravity']:
            break
    amplitude = size * (ratio.conjugate() / abs(ratio) if ratio else -1j)
    return amplitude.imag, amplitude.real * omega


def massOf(parameters):
    """Mass of the particles with the mean size [kg]."""
    return parameters['particles'] * densityOf(parameters) * shapeOf(parameters).volume


def naturalFrequency(parameters, addedMass=0.0):
    """Of the box on its spring with an `addedMass` [kg] frozen to it [Hz]."""
    return math.sqrt(parameters['stiffness'] / (parameters['boxMass'] + addedMass)) / (2 * math.pi)
