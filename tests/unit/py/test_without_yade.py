"""What needs no YADE is imported without it: in a fresh interpreter, in which the package `yade` holds nothing but this one."""
import json
import os
import subprocess
import sys

import pytest
from project import LIMIT, PROJECT, SUPPORT

# Modules that make or read a scene, and those that need getfem; every other module of py/ is plain Python.
OF_YADE = {
    'experiments.damper.report', 'experiments.damper.run', 'experiments.impact.impactor', 'experiments.impact.pictures', 'experiments.impact.pouring',
    'experiments.impact.report', 'experiments.impact.run', 'experiments.oedometer.comparison', 'experiments.oedometer.record',
    'experiments.oedometer.report', 'experiments.oedometer.run',
    'materials.elastoplastic', 'measure.scenearrays', 'mesh.packing', 'mesh.regions', 'mesh.stl', 'pictures.snapshotrecorder',
    'runs.checkpoint', 'runs.finishedbed', 'runs.onbed', 'runs.staged', 'runs.versions',
    'scene.bodies', 'scene.engines', 'scene.filling', 'scene.parallel', 'scene.settling', 'scene.stepping', 'scene.walls',
    'validations.cylinderimpact', 'validations.elastoplasticimpact', 'validations.restingcube', 'validations.singlecrushing', 'vtk.recorder'}
OF_GETFEM = {'plasticity.body', 'plasticity.cases', 'plasticity.identify'}
PROGRAMS = {'pictures.renderprocess'}  # run as they are imported
PLAIN_ROOMS = ('statistics', 'files', 'study')  # nothing in them may need YADE

IMPORT_EACH = """
import importlib, json, sys
import plainpackage
failed = {}
for name in json.load(sys.stdin):
    plainpackage.provide()
    try:
        importlib.import_module(f'yade.superquadric.{name}')
    except ImportError as error:
        failed[name] = str(error)
json.dump(failed, sys.stdout)
"""


def modules():
    """Names of all modules of py/ within yade.superquadric."""
    for path in sorted((PROJECT / 'py').rglob('*.py')):
        parts = path.relative_to(PROJECT / 'py').with_suffix('').parts
        if parts[-1] != '__init__':
            yield '.'.join(parts)


@pytest.fixture(scope='module')
def failed():
    """{module: why it could not be imported without YADE}"""
    wanted = [name for name in modules() if name not in PROGRAMS]
    environment = {name: value for name, value in os.environ.items() if name != 'PYTHONPATH'}
    done = subprocess.run([sys.executable, '-c', IMPORT_EACH], input=json.dumps(wanted), capture_output=True, text=True, timeout=LIMIT,
                          env={**environment, 'PYTHONPATH': str(SUPPORT)})
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.parametrize('name', [name for name in modules() if name not in OF_YADE | OF_GETFEM | PROGRAMS])
def test_moduleNeedsNoYade(failed, name):
    assert name not in failed, failed[name]


@pytest.mark.parametrize('name', sorted(OF_YADE))
def test_listedModuleNeedsYade(failed, name):
    """Else it belongs among the plain ones, and has to be taken off the list."""
    assert 'yade' in failed.get(name, 'it needs no YADE: take it off the list')


def test_plainRoomsHoldPlainModules():
    assert not [name for name in OF_YADE if name.split('.')[0] in PLAIN_ROOMS]
