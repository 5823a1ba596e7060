"""From a stress-strain curve to a material file: the whole way on coarse meshes, and what the command refuses. Needs getfem (tools/packages/fem)."""
import os
import subprocess
import sys

import pytest
from project import LIMIT, PROJECT

from yade.superquadric.materials import materialfile
from yade.superquadric.plasticity import cases, fit
from yade.superquadric.plasticity.identify import Identification

METAL = {'name': 'Metal', 'source': 'made up for tests', 'young': 7e10, 'poisson': 0.33, 'density': 2700.0, 'yieldStress': 3e8,
         'stressStrain': [[0.0, 3e8], [0.01, 3.6e8], [0.5, 6e8]]}
COARSE = cases.QUICK._replace(fineness=0.35, steps=14, unloadSteps=3, largest=0.1, convergence=(0.25, 0.35))
EQUAL = {f'{d}-{d}': (d * 1e-3, d * 1e-3) for d in (5, 10, 20)}   # the quickest pairs of three effective radii


def command(*arguments):
    environment = {**os.environ, 'PYTHONPATH': os.path.join(os.environ['YADE_PREFIX'], 'python')}
    return subprocess.run([sys.executable, PROJECT / 'scripts' / 'identify_plasticity.py', *arguments], capture_output=True,
                          text=True, timeout=LIMIT, env=environment)


def test_whole_way(tmp_path, monkeypatch):
    monkeypatch.setattr(cases, 'CASES', EQUAL)
    monkeypatch.setattr(cases, 'ELASTIC_CASES', ('5-5',))
    monkeypatch.setattr(cases, 'REFERENCE_UNLOADINGS', (0.3, 0.5, 0.75, 1.0))
    monkeypatch.setattr(cases, 'UNLOADINGS', (1.0,))
    lines = []
    found = Identification(METAL, COARSE, lines.append)
    assert [line.split(':')[0] for line in lines[-3:]] == list(EQUAL)
    found.write(tmp_path, 'metal')
    material = materialfile.read(tmp_path / 'metal.yaml')
    assert {key: material[key] for key in METAL} == METAL
    assert material['fit']['cases'] == list(EQUAL) and material['fit']['hertzError'] < 0.02
    assert 1.5 < material['hardening']['exponent'] < 2.5
    # Without a length in the material similar pairs are the same contact.
    assert fit.collapse(fit.points(found.curves)) < 1e-5
    assert found.law.rms < 0.2
    # Plastic contacts give back less the further they go.
    own = [one.returned for one in found.unloadings if one.case == cases.REFERENCE_CASE]
    assert len(own) == 4 and all(later < earlier for earlier, later in zip(own, own[1:]))
    page = (tmp_path / 'page.md').read_text()
    assert f'{found.law.constants["exponent"]:.4g}' in page
    for picture in ('hertz', 'convergence', 'collapse', 'unloading', 'restitution'):
        assert f'({picture}.png)' in page and (tmp_path / f'{picture}.png').read_bytes().startswith(b'\x89PNG')
    assert sorted(os.listdir(tmp_path)) == sorted(['metal.yaml', 'page.md', 'elastic.csv', 'loading.csv', 'unloading.csv', 'hertz.png',
                                                   'convergence.png', 'collapse.png', 'unloading.png', 'restitution.png'])


@pytest.mark.parametrize('arguments, message', [
    (['missing.yaml'], r"identify_plasticity.py: material file = 'missing.yaml': cannot be read"),
    (['metal.yaml', '--largest', '0.5'], 'identify_plasticity.py: largest = 0.5: must lie in [0.02, 0.3]'),
])
def test_command_refuses_bad_input(tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    materialfile.write('metal.yaml', METAL)
    done = command(*arguments, '--output', 'out')
    assert done.returncode == 2 and message in done.stderr
    assert not os.path.exists('out')
