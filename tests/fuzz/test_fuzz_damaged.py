"""Files that were cut short, overwritten, exchanged or flipped a bit in: a ValueError that names the file or folder, or the same as from the whole
file.

Whatever is damaged, YADE is never handed it (it may die of it) and its present scene stays.
"""
import os
import shutil

import numpy
import pandas
import pytest
from damage import copyWith, damage, damaged
from fuzzing import fuzz, refused
from hypothesis import strategies as st
from yade import O

import yade.superquadric as sq
from yade.superquadric.experiments.oedometer import case as oedometercase
from yade.superquadric.files import results, sealed
from yade.superquadric.runs import checkpoint, finishedbed
from yade.superquadric.study import plan as plans
from yade.superquadric.study import studyfile, table

SMALL = {'containerDiameter': 0.07, 'particles': 12, 'impactorDiameter': 0.03, 'maxSettlingTime': 0.02, 'maxImpactTime': 1e-3}
STUDY = {'title': 'Test', 'seeds': [1], 'groups': {'layers': {
    'x': {'speed': [2, 3]}, 'base': {'thickness': 0.01}, 'series': {'die': {'shape': 'cube'}}}}}
WHOLE = {}  # {kind: folder with undamaged files}


@pytest.fixture(scope='module', autouse=True)
def wholeFiles(tmp_path_factory):
    """A bed, an interrupted impact on it, a study with one finished run, and files of every kind that the package reads."""
    for kind in ('bed', 'checkpoint', 'study', 'files', 'oedometer'):
        WHOLE[kind] = str(tmp_path_factory.mktemp(kind))
    sq.ImpactRun.begin(SMALL, WHOLE['bed'], stream=None).run(until='prepare')
    run = sq.ImpactRun.onBed(WHOLE['bed'], {}, WHOLE['checkpoint'], stream=None)
    run.run(until='impact')
    plan = plans.planOf(studyfile.checkedStudy(STUDY))
    plans.write(plan, WHOLE['study'])
    results.writeCsv(os.path.join(WHOLE['files'], 'record.csv'), ('time', 'force'), [(i / 7, i ** 2) for i in range(30)])
    results.writeJson(os.path.join(WHOLE['files'], 'content.json'), {'parameters': SMALL, 'values': [i / 7 for i in range(20)], 'text': 'ü'})
    shutil.copy(os.path.join(WHOLE['bed'], 'before.npz'), WHOLE['files'])
    finishedOedometer(WHOLE['oedometer'])


@pytest.fixture(scope='module')
def place(tmp_path_factory):
    return str(tmp_path_factory.mktemp('damaged') / 'copy')


def marked():
    """YADE's scene as one that can be told from any other."""
    O.reset()
    O.tags['description'] = 'mine'


def stillMine():
    return O.tags['description'] == 'mine' and len(O.bodies) == 0


@fuzz(weight=5, name=st.sampled_from(('bed.json', 'bed.yade.gz', 'before.npz')), how=damage)
def test_beds(place, name, how):
    isOther = copyWith(WHOLE['bed'], place, name, how)
    marked()
    answer, no = refused(lambda: (finishedbed.read(place), finishedbed.load(place)), place)
    if no:
        assert isinstance(answer, ValueError) and stillMine() and isOther
    else:
        assert answer[0] == sealed.read(os.path.join(WHOLE['bed'], 'bed.json')) and len(O.bodies) == 2 + SMALL['particles']


@fuzz(weight=5, name=st.sampled_from(('checkpoint.json', 'checkpoint.yade.gz')), how=damage)
def test_checkpoints(place, name, how):
    isOther = copyWith(WHOLE['checkpoint'], place, name, how)
    marked()
    answer, no = refused(lambda: checkpoint.load(place), place)
    if no:
        assert isinstance(answer, ValueError) and stillMine() and isOther
    else:
        whole = sealed.read(os.path.join(WHOLE['checkpoint'], 'checkpoint.json'))
        assert {**answer, 'scene': 'checkpoint.yade.gz'} == whole and len(O.bodies) == 3 + SMALL['particles']


@fuzz(first=st.sampled_from(('bed', 'checkpoint')), how=damage, second=damage)
def test_bothFilesOfACheckpoint(place, first, how, second):
    copyWith(WHOLE['checkpoint'], place, 'checkpoint.json', how)
    with open(os.path.join(place, 'checkpoint.yade.gz'), 'wb') as stream, open(os.path.join(WHOLE[first], f'{first}.yade.gz'), 'rb') as whole:
        stream.write(damaged(whole.read(), *second) if second[0] != 'other' else whole.read())
    marked()
    if refused(lambda: checkpoint.load(place), place)[1]:
        assert stillMine()


READERS = {'record.csv': results.readCsv, 'content.json': results.readJson, 'before.npz': sq.Snapshot.load}


@fuzz(weight=5, name=st.sampled_from(tuple(READERS)), how=damage)
def test_readers(place, name, how):
    """Their files carry no sums: a flipped digit is another number; but what is read has the right form."""
    isOther = copyWith(WHOLE['files'], place, name, how)
    path = os.path.join(place, name)
    answer, no = refused(lambda: READERS[name](path), path)
    if no:
        assert isinstance(answer, ValueError) and isOther
    elif name == 'record.csv':
        assert all(len(row) == len(answer[0]) for row in answer[1])
    elif name == 'before.npz':
        assert answer.positions.shape == (len(answer), 3) and answer.rotations.shape == (len(answer), 3, 3)


def finishedRun(folder, how):
    """Give the first run of the study a summary like that of a finished run, damaged. Returns plan, run and whether it is damaged."""
    plan = results.readJson(os.path.join(folder, 'plan.json'))
    run = next(iter(plan['runs']))
    summary = {
        'parameters': plan['runs'][run]['parameters'], 'particle': {'number': 100}, 'P0': 4000.0, 'bufferingRatio': 0.9, 'threads': 1,
        'bed': {'thickness': 0.01, 'packingFraction': 0.6, 'innerPackingFraction': None, 'staticForce': 10.0, 'weight': 10.1,
                'atRest': {'soft': True, 'true': True}, 'pours': [{}], 'wallSeconds': 1.0},
        'impactor': {'surfaceSpeed': 5.5}, 'timeStep': {'impact': 1e-6}, 'wallSeconds': 2.0,
        'impact': {'peak': 400.0, 'peakTime': 1e-3, 'duration': 2e-3, 'lastTime': 3e-3, 'impulse': 1.0, 'over': True},
        'solver': {'solves': 5, 'iterations': 9, 'fallbacks': 0, 'uncertified': 0},
        'versions': {'yade': '1', 'yade-superquadric': '2', 'python': '3', 'numpy': '4'}}
    results.writeJson(os.path.join(folder, 'content.json'), summary)
    os.makedirs(os.path.dirname(table.summaryPath(plan, folder, run)), exist_ok=True)
    with open(os.path.join(folder, 'content.json'), 'rb') as stream, open(table.summaryPath(plan, folder, run), 'wb') as target:
        content = stream.read()
        target.write(damaged(content, *how) if how[0] != 'other' else b'{}')
    return plan, run


@fuzz(weight=3, how=damage)
def test_summariesOfAStudy(place, how):
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(WHOLE['study'], place)
    plan, run = finishedRun(place, how)
    rows, no = refused(lambda: table.tableOf(plan, place), table.summaryPath(plan, place, run))
    if no:
        assert isinstance(rows, ValueError)
    else:
        table.write(rows, os.path.join(place, 'results.csv'))
        assert len(pandas.read_csv(os.path.join(place, 'results.csv'))) == 1


@fuzz(weight=2, how=damage)
def test_plansAreWrittenAgain(place, how):
    copyWith(WHOLE['study'], place, 'plan.json', how)
    plan = plans.planOf(studyfile.checkedStudy(STUDY))
    plans.write(plan, place)
    assert results.readJson(os.path.join(place, 'plan.json')) == plan


def finishedOedometer(folder):
    """Just the files that are read back, of two particles, one of them a fragment."""
    results.writeJson(os.path.join(folder, 'summary.json'), {'parameters': {}})
    results.writeCsv(os.path.join(folder, oedometercase.STRESS), ('strain', 'stress'), [(0, 0), (0.1, 1e5)])
    results.writeCsv(os.path.join(folder, oedometercase.PARTICLES), ('id', 'diameter', 'volume', 'ancestor', 'contacts', 'meanForce'),
                     [(1, 0.02, 4.2e-6, -1, 3, 1.0), (2, 0.01, 5.2e-7, 0, 2, 0.5)])
    sq.Snapshot(ids=[0, 1], positions=numpy.zeros((2, 3)), rotations=numpy.array([numpy.eye(3)] * 2), extents=numpy.full((2, 3), 0.01),
                exponents=numpy.full((2, 2), 2.0)).save(os.path.join(folder, 'before.npz'))


@fuzz(weight=3, name=st.sampled_from(('summary.json', oedometercase.STRESS, oedometercase.PARTICLES, 'before.npz')), how=damage)
def test_finishedOedometers(place, name, how):
    isOther = copyWith(WHOLE['oedometer'], place, name, how)
    case, no = refused(lambda: oedometercase.load(place), place)
    if no:
        assert isinstance(case, ValueError) and isOther
