"""Materials from what is known of them: a material file's numbers, a wanted restitution."""
import math
from collections.abc import Mapping
from functools import lru_cache

from yade.wrapper import ElastoplasticMat

from . import checks

OF_THE_MATERIAL = ('young', 'poisson', 'density', 'yieldStress')
HARDENING = ('referenceRadius', 'm0', 'm1', 'm2', 'exponent', 'smallestRatio', 'largestRatio')
TOLD_ONLY = ('name', 'source', 'stressStrain', 'fit')  # of a material file: not needed by the contact law

RESTITUTION_STEPS = 4000  # of the integration over one collision: restitution to 1e-5
LARGEST_DAMPING = 0.999   # CurvatureMat takes Cn below 1


def elastoplasticMat(properties, **others):
    """An `ElastoplasticMat`.

    :param properties: what a material file says, as a dict: young [Pa], poisson, density [kg/m3], yieldStress [Pa], hardening
        (a dict with referenceRadius [m], m0, m1, m2, exponent and, if not 1 to 4, smallestRatio, largestRatio) and, not needed here,
        name, source, stressStrain, fit. Its name becomes the label.
    :param others: further attributes, such as frictionAngle, or ones that replace those of the dict
    :raises ValueError: a key that is missing or unknown, or a value that the material refuses
    """
    if not isinstance(properties, Mapping):
        raise ValueError(f'properties = {properties!r}: must be a dict')
    hardening = properties.get('hardening', {})
    if not isinstance(hardening, Mapping):
        raise ValueError(f'hardening = {hardening!r}: must be a dict')
    _checkKeys('properties', properties, OF_THE_MATERIAL, ('hardening', *TOLD_ONLY))
    yieldStress = properties['yieldStress']
    if yieldStress != math.inf:
        yieldStress = checks.finite('yieldStress', yieldStress)
    if 'hardening' in properties or yieldStress != math.inf:
        _checkKeys('hardening', hardening, HARDENING[:5], HARDENING[5:])
    own = {name: checks.finite(name, properties[name]) for name in OF_THE_MATERIAL if name != 'yieldStress'}
    own.update({name: checks.finite(name, value) for name, value in hardening.items()})
    return ElastoplasticMat(**{'label': properties.get('name', ''), **own, 'yieldStress': yieldStress, **others})


def _checkKeys(name, given, needed, allowed):
    for key in needed:
        if key not in given:
            raise ValueError(f'{name} = {dict(given)!r}: {key} is missing')
    for key in given:
        if key not in (*needed, *allowed):
            raise ValueError(f'{name}: there is no {key} = {given[key]!r} in a material')


def normalDampingFor(restitution):
    """Cn with which an elastic collision has the `restitution` (speed after over speed before), at any speed.

    For the laws that have equations (6)-(8) of Wang & Ji (2018), where the normal force never pulls.

    :param restitution: in (0, 1], and not below what Cn = 0.999 gives
    :raises ValueError: it is not
    """
    wanted = checks.within('restitution', restitution, 0, 1)
    if wanted == 1:
        return 0.0
    low, high = 0.0, LARGEST_DAMPING
    if wanted < restitutionFor(high):
        raise ValueError(f'restitution = {restitution!r}: Cn must be below 1, which gives at least {restitutionFor(high):.4f}')
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if restitutionFor(middle) > wanted else (low, middle)
    return (low + high) / 2


@lru_cache(maxsize=None)
def restitutionFor(damping):
    """Restitution of an elastic collision with the normal damping Cn in [0, 1).

    With mass and Kn of (7) as units, (6)-(8) are x'' = -max(x^(3/2) + Cn sqrt(6) x^(1/4) x', 0), the same at any speed.
    Integrated by half steps (second order) until the force has ended.
    """
    damping = checks.within('damping', damping, 0, 1, highIncluded=False)
    place, speed = 0.0, 1.0
    step = 3.2 / RESTITUTION_STEPS  # Hertz's collision at unit speed takes 3.218 of these units
    viscosity = damping * math.sqrt(6)
    while place >= 0:
        place += step / 2 * speed
        if place <= 0:
            break
        root = math.sqrt(place)
        # The viscous part by the mean of the speeds before and after.
        drag = step / 2 * viscosity * math.sqrt(root)
        after = (speed * (1 - drag) - step * place * root) / (1 + drag)
        force = (speed - after) / step
        if force <= 0:
            break  # the bodies part
        speed = after
        place += step / 2 * speed
    return -speed
