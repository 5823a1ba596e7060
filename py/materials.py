"""Elastoplastic materials from the numbers of a material file."""
import math
from collections.abc import Mapping

from yade.wrapper import ElastoplasticMat

from . import checks

OF_THE_MATERIAL = ('young', 'poisson', 'density', 'yieldStress')
HARDENING = ('referenceRadius', 'm0', 'm1', 'm2', 'exponent', 'smallestRatio', 'largestRatio')
TOLD_ONLY = ('name', 'source', 'stressStrain', 'fit')  # of a material file: not needed by the contact law


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
