"""The material of the elastoplastic law: what it refuses, and how it is made from what is known of it."""
import math
import re

import pytest
from yade.wrapper import ElastoplasticMat

import yade.superquadric as sq
from yade.superquadric.materials.shipped import FOLDER, materialAt

SOFT = dict(young=1e8, poisson=0.3, density=2500, frictionAngle=0.4, normalDamping=0.05, tangentialDamping=0.05, rollingFriction=0.02,
            rollingDamping=0.1, yieldStress=1e5, m0=2.5, exponent=1.8)
HARDENING = dict(referenceRadius=2.5e-3, m0=2.5, m1=0.1, m2=-0.01, exponent=1.8, smallestRatio=0.5, largestRatio=5)


@pytest.mark.parametrize('name, value', [
    ('yieldStress', 0.0), ('yieldStress', -1e6), ('yieldStress', math.nan), ('yieldStress', 1e8), ('young', 9e4), ('young', -1.0),
    ('m0', -5.0), ('m0', math.nan), ('m1', -3.0), ('m2', math.inf), ('exponent', 0.0), ('exponent', 3.0), ('referenceRadius', 0.0),
    ('smallestRatio', -1.0),
    ('largestRatio', 0.5), ('rollingDamping', -0.1), ('rollingDamping', math.inf), ('frictionAngle', 2.0)])
def test_refused_values_are_put_back(name, value):
    material = ElastoplasticMat(**SOFT)
    before = material.dict()
    said = 'yieldStress must be below' if value == 9e4 else 'm0 [+] m1 r' if value in (-5.0, -3.0) else name
    with pytest.raises(ValueError, match=said):
        setattr(material, name, value)
    assert material.dict() == before
    with pytest.raises(ValueError, match=said):
        material.updateAttrs({name: value})
    assert material.dict() == before
    with pytest.raises(ValueError, match=said):
        ElastoplasticMat(**{**SOFT, name: value})


def test_numbers_that_depend_on_each_other_can_be_changed_together():
    material = ElastoplasticMat(**SOFT)
    other = dict(m0=-1, m1=2.5, m2=0.1, smallestRatio=2, largestRatio=3)
    with pytest.raises(ValueError, match='m0 [+] m1 r'):
        material.m0 = other['m0']
    material.updateAttrs(other)
    assert material.m0 == -1 and material.largestRatio == 3
    fresh = ElastoplasticMat(young=1e8, poisson=0.3, density=2500)
    assert fresh.yieldStress == math.inf
    with pytest.raises(ValueError, match='exponent must be between 0 and 3, got 0'):
        fresh.yieldStress = 1e5
    fresh.m0, fresh.exponent = 2, 1.5
    fresh.yieldStress = 1e5
    assert fresh.yieldStress == 1e5


PROPERTIES = dict(name='AlMg', source='made up', young=70e9, poisson=0.33, density=2700, yieldStress=1e8, hardening=HARDENING,
                  stressStrain=[[0, 1e8]], fit={})


def test_material_from_a_dict():
    material = sq.elastoplasticMat(PROPERTIES, frictionAngle=0.3, density=2800)
    assert material.label == 'AlMg' and material.density == 2800 and material.frictionAngle == 0.3
    assert {name: getattr(material, name) for name in HARDENING} == HARDENING
    assert sq.elastoplasticMat({**PROPERTIES, 'yieldStress': math.inf}).yieldStress == math.inf


@pytest.mark.parametrize('change, message', [
    ({'young': None}, 'young = None: must be a number'), ({'yieldStress': 'high'}, "yieldStress = 'high': must be a number"),
    ({'yieldStress': 8e10}, 'yieldStress must be below'),
    ({'hardening': 3}, 'hardening = 3: must be a dict'), ({'hardening': {'m0': 1}}, 'referenceRadius is missing'),
    ({'hardening': {**HARDENING, 'm3': 1}}, 'there is no m3 = 1'), ({'hardening': {**HARDENING, 'm0': 'x'}}, "m0 = 'x': must be a number"),
    ({'colour': 1}, 'there is no colour = 1')])
def test_material_from_a_bad_dict(change, message):
    with pytest.raises(ValueError, match=message):
        sq.elastoplasticMat({**PROPERTIES, **change})


def test_material_without_what_it_needs():
    for key in ('young', 'yieldStress', 'hardening'):
        with pytest.raises(ValueError, match=f'{"referenceRadius" if key == "hardening" else key} is missing'):
            sq.elastoplasticMat({k: v for k, v in PROPERTIES.items() if k != key})


def test_material_from_a_file(tmp_path):
    shipped = sq.elastoplasticMat('steel-4340', frictionAngle=0.3)
    assert (shipped.young, shipped.poisson, shipped.yieldStress) == (200e9, 0.32, 792e6) and shipped.frictionAngle == 0.3
    own = tmp_path / 'own.yaml'
    own.write_text(open(FOLDER + '/steel-4340.yaml').read().replace('200000000000.0', '190000000000.0'))
    assert sq.elastoplasticMat(own).young == 190e9
    assert materialAt('material', own) == str(own) and materialAt('material', 'steel-4340') == 'steel-4340'


@pytest.mark.parametrize('value', ('steel.yaml', 3, None))
def test_no_such_material(value):
    with pytest.raises(ValueError, match=re.escape(f'material = {value!r}: must be a material file, or one of aluminium-2024-T351, steel-4340')):
        sq.elastoplasticMat(value)


def test_material_file_that_was_never_identified(tmp_path):
    lines = open(FOLDER + '/steel-4340.yaml').read()
    (tmp_path / 'raw.yaml').write_text(lines[:lines.index('hardening:')])
    with pytest.raises(ValueError, match='material.hardening: is missing'):
        sq.elastoplasticMat(tmp_path / 'raw.yaml')


@pytest.mark.parametrize('value', (0, -1, 0.01, 1.1, math.nan, 'x'))
def test_no_damping_for_an_impossible_restitution(value):
    with pytest.raises(ValueError, match=f'restitution = {value!r}'):
        sq.normalDampingFor(value)
