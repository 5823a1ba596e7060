"""A small sweep of a damper as a study, from the study file to the page, with YADE really running; and what such studies refuse."""
import copy
import csv
import json
import os
import subprocess
import sys

import numpy
import pandas
import pytest
import yade
import yaml
from matplotlib.image import imread
from project import LIMIT, PROJECT

from yade.superquadric.experiments.damper.study import DAMPERS
from yade.superquadric.study.plan import planOf
from yade.superquadric.study.studyfile import checkedStudy

SMALL = dict(particles=40, radius=1.5e-3, boxWidth=0.015, boxDepth=0.015, boxHeight=0.016, totalParticleMass=0.03, boxMass=0.1, stiffness=4000,
             forceAmplitude=5, transientTime=0.03, periods=4, samples=40, softening=1e4, maxSettlingTime=0.05)
STUDY = {'experiment': 'damper', 'title': 'A small sweep', 'base': SMALL, 'seeds': [3], 'groups': {'sweep': {
    'x': {'frequency': [20, 30.5]}, 'series': {'spheres': {}, 'empty': {'particles': 0, 'dashpot': 4}},
    'figures': {'response': {'kind': 'response'}, 'shares': {'kind': 'shares', 'series': ['spheres']},
                'spectra': {'kind': 'spectra', 'series': ['spheres']}, 'planes': {'kind': 'phasePlanes', 'series': ['spheres'], 'x': [30.5]},
                'lag': {'kind': 'trend', 'y': ['phaseLag']}},
    'findings': [{'paper': 'the account closes', 'test': 'within', 'y': 'balanceError', 'low': -0.03, 'high': 0.03},
                 {'paper': 'the particles move', 'test': 'within', 'y': 'centroidRatio', 'low': 0.01, 'series': ['spheres']},
                 {'paper': 'they rest', 'test': 'within', 'y': 'centroidRatio', 'high': 0.01, 'series': ['spheres']}]}}}


@pytest.fixture(scope='module')
def sweep(tmp_path_factory):
    """(folder, plan, function that runs the command again) of a finished study."""
    folder = tmp_path_factory.mktemp('sweep')
    (folder / 'study.yaml').write_text(yaml.safe_dump(STUDY))
    environment = {**os.environ, 'PYTHONPATH': os.path.dirname(os.path.dirname(os.path.abspath(yade.__file__)))}

    def run():
        done = subprocess.run([sys.executable, PROJECT / 'scripts' / 'study.py', folder / 'study.yaml', '--output', folder / 'out',
                               '--cores', '1'], env=environment, capture_output=True, text=True, timeout=LIMIT)
        assert done.returncode == 0, done.stderr
        return done.stdout
    text = run()
    assert 'supported     the account closes' in text and 'contradicted  they rest' in text
    return folder / 'out', json.loads((folder / 'out' / 'plan.json').read_text()), run


def test_tableHoldsEveryRun(sweep):
    with open(sweep[0] / 'results.csv') as file:
        rows = list(csv.DictReader(file))
    assert sorted((float(row['frequency']), int(row['particles'])) for row in rows) == [(20, 0), (20, 40), (30.5, 0), (30.5, 40)]
    for row in rows:
        summary = json.loads((sweep[0] / 'vibrations' / row['run'] / 'summary.json').read_text())
        assert float(row['amplitude']) == summary['box']['amplitude'] and float(row['work']) == summary['energy']['work']
        assert float(row['period']) == (summary['box']['period'] or 0)
        if summary['centroid']:
            others = [share for name, share in summary['energy']['shares'].items() if name != 'normDampDissip']
            assert float(row['normalViscousLead']) == summary['energy']['shares']['normDampDissip'] - max(others)
            assert float(row['centroidLoopFill']) == summary['centroid']['loopFill']
        else:
            assert row['centroidAmplitude'] == ''


def test_picturesShowSomething(sweep):
    for name in ('response', 'shares', 'spectra', 'planes', 'lag'):
        pixels = imread(sweep[0] / 'figures' / f'{name}.png')[..., :3]
        assert pixels.shape[1] >= 800 and 0.0005 < (numpy.ptp(pixels, axis=2) > 0.15).mean() < 0.5, name


def test_finishedRunsAreNotDoneAgain(sweep):
    folder, plan, run = sweep
    times = {path: path.stat().st_mtime_ns for path in folder.glob('vibrations/*/summary.json')}
    assert len(times) == len(plan['runs']) == 4 and '4 vibrations are finished' in run()
    assert {path: path.stat().st_mtime_ns for path in times} == times and not (folder / 'beds').exists()


def test_concernsNameEachFrequencyOnce():
    done = pandas.DataFrame({'frequency': [30.5, 20, 20, 20], 'balanceError': [0, 0.5, -0.5, 0.5], 'storedShare': [0.9, 0, 0, 0]})
    account, steady = DAMPERS.concerns(done)
    assert account.endswith('of the work: 20 Hz') and steady.endswith('dying out: 30.5 Hz')


@pytest.mark.parametrize('change, message', [
    ({'places': 2}, 'places = 2: a bed of the experiment damper has no places'),
    ({'experiment': 'dampers'}, "experiment = 'dampers': must be one of impact, damper"),
    ({'validations': {'cylinderOnPlane': True}}, "validations: 'cylinderOnPlane' is unknown"),
    ({'base': {'thickness': 0.02}}, 'base.thickness = 0.02: there is no such parameter'),
    ({'base': {'stiffness': -1}}, "groups.sweep, series 'spheres', frequency = 20: stiffness = -1: must not be negative"),
    ({'base': {'material': 'cheese'}}, "groups.sweep, series 'spheres', frequency = 20: material = 'cheese': must be a material file")])
def test_badStudies(change, message):
    with pytest.raises(ValueError) as error:
        planOf(checkedStudy({**copy.deepcopy(STUDY), **change}))
    assert str(error.value).startswith(message)


def test_materialFileIsFoundFromTheStudysFolder(tmp_path, monkeypatch):
    """Jobs run in another folder than the command: the plan has the whole path."""
    from yade.superquadric.materials.shipped import FOLDER
    (tmp_path / 'own.yaml').write_text(open(os.path.join(FOLDER, 'steel-4340.yaml')).read())
    monkeypatch.chdir(tmp_path)
    plan = planOf(checkedStudy({**STUDY, 'base': {**SMALL, 'material': 'own.yaml'}}))
    assert {run['parameters']['material'] for run in plan['runs'].values()} == {str(tmp_path / 'own.yaml')}
