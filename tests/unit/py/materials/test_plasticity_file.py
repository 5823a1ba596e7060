"""Material files: what is refused and how it is said, reading and writing."""
import copy
import os

import pytest
from project import PROJECT

from yade.superquadric.materials import materialfile

SHIPPED = PROJECT / 'py' / 'materials'
MATERIAL = {'name': 'Metal', 'source': 'made up for tests', 'young': 7e10, 'poisson': 0.33, 'density': 2700.0, 'yieldStress': 2e8,
            'stressStrain': [[0.0, 2e8], [0.01, 2.5e8], [0.1, 3e8]],
            'hardening': {'referenceRadius': 2.5e-3, 'm0': 2.0, 'm1': 0.1, 'm2': -0.01, 'exponent': 1.8, 'smallestRatio': 1.0, 'largestRatio': 4.0}}


def changed(path, value):
    """MATERIAL with `value` at the place `path`, such as 'hardening.m0' or 'stressStrain.1'; None: without that entry."""
    material = copy.deepcopy(MATERIAL)
    *parents, last = [int(key) if key.isdigit() else key for key in path.split('.')]
    place = material
    for key in parents:
        place = place[key]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return material


@pytest.mark.parametrize('path, value, message', [
    ('young', None, r'material\.young: is missing'),
    ('hardening', None, r'material\.hardening: is missing'),
    ('youngs', 1.0, r'material\.youngs: is unknown; possible are name, .*fit'),
    ('name', '', r"name = '': must be a text"),
    ('source', 5, r'source = 5: must be a text'),
    ('young', -1.0, r'young = -1\.0: must be positive'),
    ('young', 'stiff', r"young = 'stiff': must be a number"),
    ('density', float('nan'), r'density = nan: must be finite'),
    ('poisson', 0.5, r'poisson = 0\.5: must lie in \[0, 0\.5\)'),
    ('yieldStress', 8e10, r'yieldStress = 80000000000\.0: must be below young'),
    ('yieldStress', 2.1e8, r'stressStrain\[0\] stress = 200000000\.0: must be yieldStress = 210000000\.0'),
    ('stressStrain', [[0.0, 2e8]], r'stressStrain = .*: must be a list of at least two'),
    ('stressStrain.1', [0.01], r'stressStrain\[1\] = \[0\.01\]: must be \[plastic strain, stress\]'),
    ('stressStrain.2', [0.01, 3e8], r'stressStrain\[2\] strain = 0\.01: must be above the one before, 0\.01'),
    ('stressStrain.2', [0.1, 2.4e8], r'stressStrain\[2\] stress = 240000000\.0: must not be below the one before'),
    ('stressStrain.2', [0.1, float('inf')], r'stressStrain\[2\] stress = inf: must be finite'),
    ('stressStrain.2', [0.1, 8e10], r'stressStrain\[2\] stress = 80000000000\.0: must be below young'),
    ('stressStrain.0', [0.001, 2e8], r'stressStrain\[0\] strain = 0\.001: must be 0'),
    ('hardening.m1', None, r'hardening\.m1: is missing'),
    ('hardening.m3', 0.0, r'hardening\.m3: is unknown'),
    ('hardening.exponent', 3.0, r'hardening\.exponent = 3\.0: must lie between 0 and 3'),
    ('hardening.referenceRadius', 0.0, r'hardening\.referenceRadius = 0\.0: must be positive'),
    ('hardening.largestRatio', 0.5, r'hardening\.largestRatio = 0\.5: must be at least smallestRatio = 1\.0'),
    ('hardening.m0', -0.2, r'hardening\.m0, m1, m2 = .*: m0 \+ m1 r \+ m2 r\^2 must be positive .* it is -0\.11 at 1'),
    ('fit', {'cases': []}, r'fit\.largestOverlap: is missing'),
])
def test_bad_content_is_refused(path, value, message):
    with pytest.raises(ValueError, match=message):
        materialfile.checked(changed(path, value))


def test_parabola_that_dips_below_zero_between_the_ends_is_refused():
    dip = changed('hardening.m0', 6.0)
    dip['hardening'].update(m1=-5.2, m2=1.0)   # positive at both ends, negative at 2.6
    with pytest.raises(ValueError, match=r'it is -0\.76 at 2\.6'):
        materialfile.checked(dip)


def test_messages_name_the_file(tmp_path):
    path = tmp_path / 'metal.yaml'
    with pytest.raises(ValueError, match=r'material file = .*metal\.yaml.*: cannot be read \(No such file'):
        materialfile.read(path)
    for text, message in (('young: [', 'while parsing'), ('young: 1\nyoung: 2\n', 'young is given twice'),
                          ('name: A\n', r'material\.source: is missing'), ('', r'material = None: must be a mapping')):
        path.write_text(text)
        with pytest.raises(ValueError, match=rf'material file = .*metal\.yaml.*{message}'):
            materialfile.read(path)


def test_written_file_reads_the_same(tmp_path):
    path = tmp_path / 'metal.yaml'
    materialfile.write(path, MATERIAL)
    assert materialfile.read(path) == MATERIAL
    without = {key: value for key, value in MATERIAL.items() if key != 'hardening'}
    materialfile.write(path, without)
    assert materialfile.read(path, identified=False) == without
    assert os.listdir(tmp_path) == ['metal.yaml']


def test_bad_content_leaves_the_old_file(tmp_path):
    path = tmp_path / 'metal.yaml'
    materialfile.write(path, MATERIAL)
    with pytest.raises(ValueError, match='exponent'):
        materialfile.write(path, changed('hardening.exponent', 0.0))
    assert materialfile.read(path) == MATERIAL


def test_numbers_without_a_point_are_numbers(tmp_path):
    path = tmp_path / 'metal.yaml'
    materialfile.write(path, MATERIAL)
    path.write_text(path.read_text().replace('young: 70000000000.0', 'young: 7e10'))
    assert materialfile.read(path)['young'] == 7e10


def test_shipped_materials():
    files = sorted(name for name in os.listdir(SHIPPED) if name.endswith('.yaml'))
    assert len(files) >= 2
    for name in files:
        material = materialfile.read(os.path.join(SHIPPED, name))
        hardening, fit = material['hardening'], material['fit']
        assert len(fit['cases']) == 5 and hardening['smallestRatio'] == 1 and hardening['largestRatio'] == 4
        assert fit['hertzError'] < 0.02
        # From a disc of contact in the plastic limit (fp ~ a^2 and a hardening metal's a^(2 + n)) to Hertz's a^3.
        assert 1 < hardening['exponent'] < 3
        assert materialfile.factor(hardening, materialfile.lowestFactorRatio(hardening)) > 0
