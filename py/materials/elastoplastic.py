"""The elastoplastic material of a scene: from a shipped material, a user's material file, or its numbers."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from yade.wrapper import ElastoplasticMat

from .. import checks
from .shipped import properties

if TYPE_CHECKING:
    from ..typealiases import PathLike

OF_THE_MATERIAL = ('young', 'poisson', 'density', 'yieldStress')
HARDENING = ('referenceRadius', 'm0', 'm1', 'm2', 'exponent', 'smallestRatio', 'largestRatio')
TOLD_ONLY = ('name', 'source', 'stressStrain', 'fit')  # of a material file: not needed by the contact law


def elastoplasticMat(material: PathLike | Mapping[str, Any], **others: Any) -> ElastoplasticMat:
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


def _checkKeys(name: str, given: Mapping[str, Any], needed: Sequence[str], allowed: Sequence[str]) -> None:
    for key in needed:
        if key not in given:
            raise ValueError(f'{name} = {dict(given)!r}: {key} is missing')
    for key in given:
        if key not in (*needed, *allowed):
            raise ValueError(f'{name}: there is no {key} = {given[key]!r} in a material')
