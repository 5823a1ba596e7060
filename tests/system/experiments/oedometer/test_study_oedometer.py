"""Oedometer tests as a study, from the study file to the page, with YADE really running; and what such studies refuse."""
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
from smalloedometer import SMALL

from yade.superquadric.experiments.oedometer.study import OEDOMETERS
from yade.superquadric.study.plan import planOf
from yade.superquadric.study.studyfile import checkedStudy

FIGURES = ('gradings', 'stresses', 'contacts')
STUDY = {'experiment': 'oedometer', 'title': 'Few soft particles', 'base': SMALL, 'seeds': [1, 2], 'groups': {'modes': {
    'x': {'maxStress': [8e4]}, 'series': {'cube': {'mode': 'cube'}, 'none': {'mode': 'none'}},
    'figures': {**{kind: {'kind': kind} for kind in FIGURES}, 'strains': {'kind': 'variants', 'y': ['strain']}},
    'findings': [{'paper': 'the volume is kept', 'test': 'within', 'y': 'volumeError', 'low': -1e-12, 'high': 1e-12},
                 {'paper': 'the others do not break', 'test': 'within', 'y': 'broken', 'high': 0, 'series': ['none']},
                 {'paper': 'nothing breaks', 'test': 'within', 'y': 'broken', 'high': 0, 'series': ['cube']}]}}}


@pytest.fixture(scope='module')
def study(tmp_path_factory):
    """(folder, plan) of a finished study."""
    folder = tmp_path_factory.mktemp('study')
    (folder / 'study.yaml').write_text(yaml.safe_dump(STUDY))
    environment = {**os.environ, 'PYTHONPATH': os.path.dirname(os.path.dirname(os.path.abspath(yade.__file__)))}
    done = subprocess.run([sys.executable, PROJECT / 'scripts' / 'study.py', folder / 'study.yaml', '--output', folder / 'out',
                           '--cores', '1'], env=environment, capture_output=True, text=True, timeout=LIMIT)
    assert done.returncode == 0, done.stderr
    for sentence in ('supported     the volume is kept', 'supported     the others do not break', 'contradicted  nothing breaks'):
        assert sentence in done.stdout
    return folder / 'out', json.loads((folder / 'out' / 'plan.json').read_text())


def rows(folder):
    with open(folder / 'results.csv') as file:
        return list(csv.DictReader(file))


def test_modesShareTheirBeds(study):
    folder, plan = study
    assert len(plan['beds']) == 2 and len(plan['runs']) == 4 and sorted(os.listdir(folder / 'beds')) == sorted(plan['beds'])
    table = rows(folder)
    for bed in plan['beds']:
        assert sorted(row['mode'] for row in table if row['bed'] == bed) == ['cube', 'none']
        assert len({row['C0'] for row in table if row['bed'] == bed}) == 1
    assert len({row['C0'] for row in table}) == 2


def test_tableHoldsEveryTest(study):
    folder, plan = study
    for row in rows(folder):
        summary = json.loads((folder / 'tests' / row['run'] / 'summary.json').read_text())
        compression, contacts = summary['compression'], summary['contacts']['after']
        assert float(row['stress']) == compression['stress'] > 0 and float(row['voidRatio']) == compression['voidRatio']['end']
        assert float(row['carryingContactNumber']) == contacts['meanNumberWithoutRattlers'] and float(row['lost']) == 0
        assert float(row['bedSeconds']) == summary['bed']['wallSeconds'] > 0
        if row['mode'] == 'none':
            assert row['fragmentsWidestGap'] == row['onsetStress'] == '' and abs(float(row['hardin'])) < 1e-12
        else:
            assert float(row['fragmentsWidestGap']) == summary['grading']['fragments']['widestGap']['factor'] > 1
            assert float(row['number']) == 25 + 7 * float(row['broken']) > 25


@pytest.mark.parametrize('change, words', [
    ({}, None), ({'lost': 1}, 'tests with particles outside the container: 1 of 2'), ({'volumeError': -1e-6}, 'is not conserved: 1 of 2'),
    ({'waiting': 3}, 'maxEvents is too small: 1 of 2'), ({'plateOverBase': 1.11}, 'too fast: plate and base differ by more than 5 %: 1 of 2'),
    ({'plateOverBase': 1.3, 'wallFriction': 0.2}, None)])
def test_concernsTellWhatIsWrong(change, words):
    good = {'lost': 0, 'volumeError': 1e-16, 'waiting': 0, 'plateOverBase': 1.01, 'wallFriction': 0.0}
    concerns = OEDOMETERS.concerns(pandas.DataFrame([good, {**good, **change}]))
    assert len(concerns) == (words is not None) and all(concern.endswith(words) for concern in concerns)


def test_picturesShowSomething(study):
    for name in (*FIGURES, 'strains'):
        pixels = imread(study[0] / 'figures' / f'{name}.png')[..., :3]
        assert pixels.shape[1] >= 800 and 0.0005 < (numpy.ptp(pixels, axis=2) > 0.15).mean() < 0.5, name


def planWith(series):
    """Of the same study with other series, without its findings."""
    group = {**STUDY['groups']['modes'], 'series': series, 'findings': []}
    return planOf(checkedStudy({**STUDY, 'groups': {'modes': group}}))


def test_bedsOfEqualParticlesAreOne():
    """A block with the exponents of a cube is the same particle by another name, and so the same bed."""
    plan = planWith({'block': {'shape': 'block', 'n1': 6, 'n2': 6}, 'cube': {'shape': 'cube', 'n1': 6, 'n2': 6}, 'spheres': {}})
    assert len(plan['beds']) == 4 and len(plan['runs']) == 4


@pytest.mark.parametrize('change, message', [
    ({'places': 2}, 'places = 2: a bed of the experiment oedometer has no places'),
    ({'base': {'thickness': 0.02}}, 'base.thickness = 0.02: there is no such parameter'),
    ({'base': {**SMALL, 'weibullModulus': 0}}, "groups.modes, series 'cube', maxStress = 80000.0: weibullModulus = 0: must be positive"),
    ({'base': {**SMALL, 'cutExponent': -1}}, "groups.modes, series 'cube', maxStress = 80000.0: cutExponent = -1: must be positive"),
    ({'validations': {'cylinderOnPlane': True}}, "validations: 'cylinderOnPlane' is unknown; possible are singleParticleCrushing")])
def test_badStudies(change, message):
    with pytest.raises(ValueError) as error:
        planOf(checkedStudy({**copy.deepcopy(STUDY), **change}))
    assert str(error.value).startswith(message)


def test_ballsOfBlocksAreRefused():
    with pytest.raises(ValueError, match="series 'blocks', .*mode = 'balls4': for spheres only"):
        planWith({'blocks': {'shape': 'block', 'mode': 'balls4'}})
