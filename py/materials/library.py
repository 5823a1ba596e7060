"""Elastoplastic materials: those that are shipped (`materials/*.yaml`), from a user's material file, or from its numbers."""
import math
import os
from collections.abc import Mapping

from yade.wrapper import ElastoplasticMat

from .. import checks
from . import file as materialfile

FOLDER, SUFFIX = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'materials'), '.yaml'

OF_THE_MATERIAL = ('young', 'poisson', 'density', 'yieldStress')
HARDENING = ('referenceRadius', 'm0', 'm1', 'm2', 'exponent', 'smallestRatio', 'largestRatio')
TOLD_ONLY = ('name', 'source', 'stressStrain', 'fit')  # of a material file: not needed by the contact law


def shipped():
    """Names of the materials that come with the package."""
    return tuple(sorted(name[:-len(SUFFIX)] for name in os.listdir(FOLDER) if name.endswith(SUFFIX)))


def materialAt(name, value):
    """`value` if it is the name of a shipped material, else the absolute path of the material file that it is; ValueError if it is neither."""
    isName = isinstance(value, (str, os.PathLike)) and '\0' not in os.fspath(value)
    if isName and value in shipped():
        return value
    if not isName or not os.path.isfile(value):
        raise ValueError(f'{name} = {value!r}: must be a material file, or one of {", ".join(shipped())}')
    return os.path.abspath(value)


def properties(material):
    """What the file of a `material` (a shipped name, or a path) says, a dict as of `plasticity.materialfile.read`.

    :raises ValueError: there is no such file, or something is wrong with it
    """
    known = materialAt('material', material)
    return materialfile.read(os.path.join(FOLDER, known + SUFFIX) if known in shipped() else known)


def elastoplasticMat(material, **others):
    """An `ElastoplasticMat`.

        sq.elastoplasticMat('aluminium-2024-T351', frictionAngle=0.4, normalDamping=sq.normalDampingFor(0.8))

    :param material: name of a shipped material, path of a material file (docs/plasticity), or a dict as it is in one: young [Pa], poisson,
        density [kg/m3], yieldStress [Pa], hardening (a dict with referenceRadius [m], m0, m1, m2, exponent and, if not 1 to 4, smallestRatio,
        largestRatio) and, not needed here, name, source, stressStrain, fit. Its name becomes the label.
    :param others: further attributes, such as frictionAngle, or ones that replace those of the dict
    :raises ValueError: no such file, a key that is missing or unknown, or a value that the material refuses
    """
    for name, value in others.items():
        if name not in ElastoplasticMat().dict():
            raise ValueError(f'{name} = {value!r}: an ElastoplasticMat has no such attribute')
    known = material if isinstance(material, Mapping) else properties(material)
    hardening = known.get('hardening', {})
    if not isinstance(hardening, Mapping):
        raise ValueError(f'hardening = {hardening!r}: must be a dict')
    _checkKeys('material', known, OF_THE_MATERIAL, ('hardening', *TOLD_ONLY))
    yieldStress = known['yieldStress']
    if yieldStress != math.inf:
        yieldStress = checks.finite('yieldStress', yieldStress)
    if 'hardening' in known or yieldStress != math.inf:
        _checkKeys('hardening', hardening, HARDENING[:5], HARDENING[5:])
    own = {name: checks.finite(name, known[name]) for name in OF_THE_MATERIAL if name != 'yieldStress'}
    own.update({name: checks.finite(name, value) for name, value in hardening.items()})
    return ElastoplasticMat(**{'label': known.get('name', ''), **own, 'yieldStress': yieldStress, **others})


def _checkKeys(name, given, needed, allowed):
    for key in needed:
        if key not in given:
            raise ValueError(f'{name} = {dict(given)!r}: {key} is missing')
    for key in given:
        if key not in (*needed, *allowed):
            raise ValueError(f'{name}: there is no {key} = {given[key]!r} in a material')
