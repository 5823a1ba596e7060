"""Material files (YAML): a metal's elastic constants and stress-strain curve, and the constants of the contact law identified from them::

    name, source              texts; where the data are from
    young [Pa], poisson, density [kg/m^3]
    yieldStress [Pa]          where the curve begins
    stressStrain              list of [plastic strain, true stress in Pa]; straight in between, constant beyond the last
    hardening                 referenceRadius R0 [m], m0, m1, m2, exponent H, smallestRatio, largestRatio (of R/R0): the plastic law of
                              Li, Gao, Zhang & Liu (2018), with the half-width a = sqrt(R d)
    fit                       how `hardening` was found: see FIT_KEYS

`hardening` and `fit` are what scripts/identify_plasticity.py adds.
"""
from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import yaml

from .. import checks
from ..files import yamlfile
from ..files.results import Replacing

if TYPE_CHECKING:
    from ..typealiases import PathLike

MATERIAL_KEYS = ('name', 'source', 'young', 'poisson', 'density', 'yieldStress', 'stressStrain')
HARDENING_KEYS = ('referenceRadius', 'm0', 'm1', 'm2', 'exponent', 'smallestRatio', 'largestRatio')
# names of the cases; largest d/dy and a/R; rms of (law - finite elements)/(finite elements) of the force; largest departure from Hertz
# with plasticity off; 95 % intervals of m0, m1, m2, exponent; fineness of the mesh; versions of the programs
FIT_KEYS = ('cases', 'largestOverlap', 'largestHalfWidth', 'residual', 'hertzError', 'intervals', 'fineness', 'versions')
SAME_STRESS = 1e-9   # relative: between numbers that mean the same and were written by hand or by program


def read(path: PathLike, identified: bool = True) -> dict[str, Any]:
    """The checked content of the material file `path`.

    :param identified: whether the file must have `hardening`
    :returns: dict as in the file, numbers as floats, `stressStrain` as a list of pairs
    :raises ValueError: naming file, key and value of what is wrong
    """
    content = yamlfile.read('material file', path)
    try:
        return checked(content, identified)
    except ValueError as error:
        raise ValueError(f'material file = {str(path)!r}: {error}') from None


def checked(content: Any, identified: bool = True) -> dict[str, Any]:
    """`content` of a material file, checked as by `read`."""
    needed = MATERIAL_KEYS + (('hardening',) if identified else ())
    _checkKeys('material', content, needed, MATERIAL_KEYS + ('hardening', 'fit'))
    result: dict[str, Any] = {key: _text(key, content[key]) for key in ('name', 'source')}
    result.update(young=checks.positive('young', content['young']),
                  poisson=checks.within('poisson', content['poisson'], 0, 0.5, highIncluded=False),
                  density=checks.positive('density', content['density']),
                  yieldStress=checks.positive('yieldStress', content['yieldStress']))
    if result['yieldStress'] >= result['young']:
        raise ValueError(f"yieldStress = {content['yieldStress']!r}: must be below young = {content['young']!r}")
    result['stressStrain'] = _stressStrain(content['stressStrain'], result['yieldStress'], result['young'])
    if content.get('hardening') is not None:
        result['hardening'] = checkedHardening(content['hardening'])
    if content.get('fit') is not None:
        result['fit'] = _checkKeys('fit', content['fit'], ('cases', 'largestOverlap', 'residual', 'hertzError', 'versions'), FIT_KEYS)
    return result


def checkedHardening(content: Any) -> dict[str, float]:
    """The constants of the plastic law as floats. The same conditions as in pkg/mechanics/ElastoplasticContact.cpp: the force must grow with the
    overlap, but less than Hertz's stiffness does."""
    _checkKeys('hardening', content, HARDENING_KEYS, HARDENING_KEYS)
    constants = {key: checks.finite(f'hardening.{key}', content[key]) for key in HARDENING_KEYS}
    for key in ('referenceRadius', 'smallestRatio'):
        checks.positive(f'hardening.{key}', constants[key])
    checks.above('hardening.exponent', constants['exponent'], 0, 3)
    low, high = constants['smallestRatio'], constants['largestRatio']
    if high < low:
        raise ValueError(f'hardening.largestRatio = {high!r}: must be at least smallestRatio = {low!r}')
    ratio = lowestFactorRatio(constants)
    if factor(constants, ratio) <= 0:
        raise ValueError(f'hardening.m0, m1, m2 = {[constants[key] for key in ("m0", "m1", "m2")]}: m0 + m1 r + m2 r^2 must be positive '
                         f'from smallestRatio to largestRatio, it is {factor(constants, ratio):.3g} at {ratio:.3g}')
    return constants


def factor(hardening: Mapping[str, float], ratio: float) -> float:
    """The hardening function G at R/R0."""
    return hardening['m0'] + ratio * (hardening['m1'] + ratio * hardening['m2'])


def lowestFactorRatio(hardening: Mapping[str, float]) -> float:
    """R/R0 within the fit where G is lowest: at an end, or at the parabola's vertex."""
    low, high = hardening['smallestRatio'], hardening['largestRatio']
    vertex = -hardening['m1'] / (2 * hardening['m2']) if hardening['m2'] else low
    return min((low, high, min(max(vertex, low), high)), key=lambda ratio: factor(hardening, ratio))


def write(path: PathLike, content: Mapping[str, Any]) -> None:
    """Write the material file `path`; it takes the place of an older one only when it is complete.

    :raises ValueError: `content` is none that `read` would accept
    """
    content = checked(content, identified='hardening' in content)
    ordered = {key: content[key] for key in MATERIAL_KEYS + ('hardening', 'fit') if key in content}
    with Replacing(path) as file:
        yaml.dump(ordered, file, _Dumper, sort_keys=False, allow_unicode=True, width=120, default_flow_style=None)


class _Dumper(yaml.SafeDumper):
    """YAML's safe dumper that gives numbers with a power of ten the point that YAML 1.1 asks for."""


def _number(dumper: yaml.SafeDumper, value: float) -> yaml.ScalarNode:
    text = repr(float(value))
    text = re.sub(r'^(-?\d+)e', r'\1.0e', text)
    return dumper.represent_scalar('tag:yaml.org,2002:float', text)


_Dumper.add_representer(float, _number)


def _checkKeys(place: str, content: Any, needed: Sequence[str], allowed: Sequence[str]) -> dict[str, Any]:
    if not isinstance(content, dict):
        raise ValueError(f'{place} = {content!r}: must be a mapping of names to values')
    for key in content:
        if key not in allowed:
            raise ValueError(f'{place}.{key}: is unknown; possible are {", ".join(allowed)}')
    for key in needed:
        if content.get(key) is None:
            raise ValueError(f'{place}.{key}: is missing')
    return content


def _text(key: str, value: Any) -> str:
    if not isinstance(value, str) or not value.strip():
        raise ValueError(f'{key} = {value!r}: must be a text')
    return value


def _stressStrain(rows: Any, yieldStress: float, young: float) -> list[list[float]]:
    """The curve as a list of pairs of floats."""
    if not isinstance(rows, list) or len(rows) < 2:
        raise ValueError(f'stressStrain = {rows!r}: must be a list of at least two [plastic strain, stress]')
    curve: list[list[float]] = []
    for i, row in enumerate(rows):
        name = f'stressStrain[{i}]'
        if not isinstance(row, list) or len(row) != 2:
            raise ValueError(f'{name} = {row!r}: must be [plastic strain, stress]')
        strain, stress = checks.notNegative(f'{name} strain', row[0]), checks.positive(f'{name} stress', row[1])
        if curve and strain <= curve[-1][0]:
            raise ValueError(f'{name} strain = {row[0]!r}: must be above the one before, {curve[-1][0]!r}')
        if curve and stress < curve[-1][1]:
            raise ValueError(f'{name} stress = {row[1]!r}: must not be below the one before, {curve[-1][1]!r}')
        if stress >= young:
            raise ValueError(f'{name} stress = {row[1]!r}: must be below young = {young!r}')
        curve.append([strain, stress])
    if curve[0][0] != 0:
        raise ValueError(f'stressStrain[0] strain = {rows[0][0]!r}: must be 0')
    if not math.isclose(curve[0][1], yieldStress, rel_tol=SAME_STRESS):
        raise ValueError(f'stressStrain[0] stress = {rows[0][1]!r}: must be yieldStress = {yieldStress!r}')
    return curve
