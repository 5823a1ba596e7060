"""The oedometer test (oedometer.OedometerRun) with few soft particles: results, conservation, Hertz, interruption, one bed for several tests."""
import json
import math
import os
import signal
import subprocess
import sys

import pytest
from project import LIMIT, PROJECT
from smalloedometer import SMALL
from yade import O
from yade.minieigenHP import Quaternion
from yade.wrapper import BreakableMat, BreakageEngine, CurvatureMat

import yade.superquadric as sq
from yade.superquadric.experiments.oedometer import case, comparison, plots, report
from yade.superquadric.experiments.oedometer.run import OedometerRun
from yade.superquadric.files import results
from yade.superquadric.scene.engines import engine, minHalfSize


def run(folder, **changes):
    return OedometerRun.begin({**SMALL, **changes}, str(folder), stream=None)


@pytest.fixture(scope='module')
def small(tmp_path_factory):
    """Folder and summary of a finished run."""
    folder = tmp_path_factory.mktemp('oedometer')
    return folder, run(folder).run()


@pytest.fixture(scope='module')
def bed(tmp_path_factory):
    folder = tmp_path_factory.mktemp('bed')
    assert run(folder).run(until='prepare') is None
    return folder


def test_resultsAreComplete(small):
    folder, summary = small
    assert sorted(os.listdir(folder)) == sorted(report.FILES)
    with open(folder / 'summary.json') as file:
        assert json.load(file) == json.loads(json.dumps(summary))
    record = case.columns(folder / 'stress.csv')
    assert len(record['strain']) > 20 and all(abs(step - 2e-3) < 1e-3 for step in record['strain'][1:] - record['strain'][:-1])
    assert record['particles'][-1] == summary['particles']['number'] and record['events'][-1] == summary['particles']['broken']
    assert 'conserved' in report.text(summary) and not list(report.warnings({**summary, 'quasiStatic': None}))


def script(output, **options):
    command = [sys.executable, sys.yade_argv[0], '-n', '-x', PROJECT / 'scripts' / 'oedometer.py', '--output', str(output), '--quiet']
    texts = [text for name, value in {**SMALL, **options}.items() for text in (f'--{name}', str(value))]
    return subprocess.run([*command, *texts], capture_output=True, text=True, timeout=LIMIT)


def test_theScriptFromEndToEnd(tmp_path):
    done = script(tmp_path, maxStrain=0.02)
    assert done.returncode == 0, done.stderr
    results = [line for line in done.stdout.splitlines() if line.startswith('results')]
    assert len(results) == 1 and all(name in results[0] for name in ('summary.json', 'grading.png', 'stress.png', 'contacts.png'))


def test_theScriptSaysInOneLineWhatIsWrong(tmp_path):
    done = script(tmp_path / 'new', particles=0)
    assert done.returncode == 2 and "oedometer.py: particles = '0'" in done.stderr and 'Traceback' not in done.stderr


def test_failedPicturesCostNoResults(tmp_path, monkeypatch):
    def fail(*_, **__):
        raise OSError('the disk is full')
    for name in ('gradings', 'specimens'):
        monkeypatch.setattr(plots, name, fail)
    summary = run(tmp_path, maxStrain=0.02).run()
    assert results.readJson(str(tmp_path / 'summary.json')) == json.loads(json.dumps(summary)) and not OedometerRun.isInterrupted(str(tmp_path))


def test_whatBreaksIsConserved(small):
    folder, summary = small
    particles, events = summary['particles'], case.columns(folder / 'events.csv')
    assert particles['broken'] > 3 and particles['number'] == 25 + 7 * particles['broken'] and len(events['time']) == particles['broken']
    assert abs(particles['volumeError']) < 1e-12 and particles['lost'] == 0
    assert all(events['value'] >= events['strength']) and all(events['size'] >= summary['parameters']['smallestSize'])
    assert all(events['children'] == 8) and summary['grading']['hardin'] > 0 and summary['breakage']['spinGains'] == 0


@pytest.mark.parametrize('own, seed', ((None, 5), (7, 7)))
def test_otherBedsHaveOtherStrengths(tmp_path, own, seed):
    """Strengths follow the bed's seed unless they get one of their own: else the weakest of all beds would be equally weak."""
    run(tmp_path, particles=3, seed=5, breakageSeed=own).run(until='compress')
    assert engine(BreakageEngine).seed == seed


def test_strainAndVoidRatioAreThoseOfThePlate(small):
    folder, summary = small
    last = {name: values[-1] for name, values in case.columns(folder / 'stress.csv').items()}
    height = summary['bed']['height'] * (1 - last['strain'])
    solid = sum(case.columns(folder / 'particles.csv')['volume'])
    assert last['voidRatio'] == pytest.approx(0.09 ** 2 * height / solid - 1, rel=1e-9)


@pytest.mark.parametrize('container', ('box', 'cylinder'))
def test_aSingleSphereAnswersAsHertzSays(tmp_path, container):
    """Between plate and base there are two contacts of E/(2 (1 - nu^2)) and the sphere's radius; each takes half of the way."""
    changes = dict(particles=1, smallestDiameter=0.04, largestDiameter=0.04, containerWidth=0.05, container=container, mode='none', maxStress=1e6,
                   maxStrain=0.1, young=2e9, inertialNumber=1e-3, sampleStrain=1e-4)
    summary = run(tmp_path, **changes).run()
    record, height = case.columns(tmp_path / 'stress.csv'), summary['bed']['height']
    area = 0.05 ** 2 * (1 if container == 'box' else math.pi / 4)
    modulus = 2e9 / (2 * (1 - 0.25 ** 2))
    chosen = [row for row in zip(record['strain'], record['plateStress'], record['baseStress']) if row[1] > 2e5]
    assert len(chosen) > 30
    for strain, plate, base in chosen:
        depth = (0.04 - height * (1 - strain + 0.5e-4)) / 2  # in the middle of the record
        assert plate * area == pytest.approx(4 / 3 * modulus * math.sqrt(0.02) * depth ** 1.5, rel=0.02)
        assert base == pytest.approx(plate, rel=0.02)
    assert max(record['lateralStress']) < 1e-2 * chosen[0][1] and summary['contacts']['after']['meanNumber'] in (2, 3)  # it may lean on the wall


def assertSameResults(folder, other):
    """Bit for bit, but for the unbalanced force, which YADE sums up in an order of the contacts that is another one after loading."""
    for name in ('particles.csv', 'events.csv'):
        assert (folder / name).read_bytes() == (other / name).read_bytes(), name
    record, expected = (case.columns(place / 'stress.csv') for place in (folder, other))
    for name, values in expected.items():
        tolerance = 1e-9 if name == 'unbalancedForce' else 0
        assert list(record[name]) == pytest.approx(list(values), rel=tolerance, abs=0), name


def test_stoppedAtAnyStepItEqualsTheUninterruptedRun(small, tmp_path, monkeypatch):
    if O.numThreads != 1:
        pytest.skip('the order of summation is only fixed on one thread')
    stops = [('settle', 333), ('seat', 30), ('compress', 77), ('compress', 900)]

    def stop(stepper):
        if stops and (stepper.stage, stepper.stageSteps) == stops[0]:
            stops.pop(0)
            os.kill(os.getpid(), signal.SIGINT)
    monkeypatch.setattr(sq.Stepper, 'report', stop)
    job = run(tmp_path)
    for left in (3, 2, 1, 0):
        with pytest.raises(sq.Interrupted):
            job.run()
        assert len(stops) == left and OedometerRun.isInterrupted(str(tmp_path))
        job = OedometerRun.resume(str(tmp_path), stream=None)
    job.run()
    assertSameResults(tmp_path, small[0])


def test_bedAndTestEqualOneRun(small, bed, tmp_path):
    if O.numThreads != 1:
        pytest.skip('the order of summation is only fixed on one thread')
    assert sorted(os.listdir(bed)) == ['bed.json', 'bed.yade.gz', 'before.npz']
    OedometerRun.onBed(str(bed), {}, str(tmp_path), stream=None).run()
    assertSameResults(tmp_path, small[0])


def test_anotherBedIsRefused(bed, tmp_path):
    with pytest.raises(ValueError, match='friction = 0.3: the bed in .* was poured with 0.5'):
        OedometerRun.onBed(str(bed), {'friction': 0.3}, str(tmp_path / 'new'), stream=None)
    with pytest.raises(ValueError, match='output = .*: holds the bed'):
        OedometerRun.onBed(str(bed), {}, str(bed), stream=None)
    assert not (tmp_path / 'new').exists()


def test_modesShareOneBedAndAreTakenAsTheyAre(tmp_path):
    changes = {**SMALL, 'maxStress': 4e4}
    first = comparison.compare(['balls4', 'none'], changes, str(tmp_path), stream=None)
    assert sorted(os.listdir(tmp_path)) == ['balls4', 'bed', 'comparison.json', 'contacts.png', 'grading.png', 'none', 'stress.png']
    assert first['balls4']['bed'] == first['none']['bed'] and first['none']['particles']['broken'] == 0
    assert first['balls4']['particles']['number'] == 25 + 3 * first['balls4']['particles']['broken']
    assert first['balls4']['grading']['fragments']['widestGap']['factor'] == pytest.approx(4 ** (1 / 3), rel=1e-6) or \
        first['balls4']['particles']['generations'] == 1
    written = os.stat(tmp_path / 'balls4' / 'summary.json').st_mtime_ns
    assert comparison.compare(['balls4', 'none'], changes, str(tmp_path), stream=None)['balls4'] == json.loads(json.dumps(first['balls4']))
    assert os.stat(tmp_path / 'balls4' / 'summary.json').st_mtime_ns == written
    assert set(results.readJson(tmp_path / 'comparison.json')) == {'balls4', 'none'} and 'balls4' in comparison.text(first)


def test_blocksBreakAndStayInside(tmp_path):
    summary = run(tmp_path, shape='block', n1=6, n2=6, particles=15, maxStress=6e4).run()
    assert summary['particles']['broken'] > 1 and abs(summary['particles']['volumeError']) < 1e-12 and summary['particles']['lost'] == 0
    assert summary['solver'].get('uncertified', 0) == 0


@pytest.mark.parametrize('shape', ('sphere', 'cube'))
def test_smallFragmentsHaveTheTimeStepOfTheInertialSize(shape):
    """Their mass is raised, at birth, so that the critical time step (14) of the raised density and the true width is that of the inertial size."""
    O.reset()
    material = BreakableMat(young=1e9, poisson=0.2, density=2500, label='stone')
    O.materials.append(material)
    O.bodies.append(sq.particleShape(shape, 0.01).body((0, 0, 0), Quaternion.Identity, material))
    breakage = BreakageEngine(forced=[0], smallestFragment=1e-3, inertialSize=8e-3, seed=3)
    O.engines = [breakage] + sq.superquadricEngines(gravity=(0, 0, 0), law='curvature')
    O.dt = material.criticalTimeStep(4e-3)
    O.step()
    fragments = [body for body in O.bodies if body is not None]
    widths = [2 * minHalfSize(body.shape) for body in fragments]
    assert len(fragments) == 8 and min(widths) < 8e-3 < max(widths)
    for body, width in zip(fragments, widths):
        factor = max(1, 8e-3 / width) ** 2
        volume = 4 / 3 * math.pi * body.shape.radius ** 3 if shape == 'sphere' else body.shape.volume()
        assert body.state.inertiaFactor == pytest.approx(factor) and body.state.mass == pytest.approx(2500 * volume * factor)
        if factor > 1:
            raised = CurvatureMat(young=1e9, poisson=0.2, density=2500 * factor)
            assert raised.criticalTimeStep(width / 2) == pytest.approx(O.dt)


def test_fragmentsOfHeavyFragmentsHaveTheirOwnMass():
    """What was added to a fragment is not handed on."""
    O.reset()
    material = BreakableMat(young=1e9, poisson=0.2, density=2500)
    O.materials.append(material)
    O.bodies.append(sq.particleShape('sphere', 0.01).body((0, 0, 0), Quaternion.Identity, material))
    breakage = BreakageEngine(forced=[0], mode='balls4', inertialSize=0.05)
    O.engines = [breakage] + sq.superquadricEngines(gravity=(0, 0, 0), law='curvature')
    O.dt = 1e-9
    O.step()
    heavy = O.bodies[1].state
    assert heavy.mass == pytest.approx(2500 * math.pi / 6 * 0.02 ** 3 / 4 * heavy.inertiaFactor) and heavy.inertiaFactor > 1
    breakage.forced, breakage.inertialSize = [1], 0
    O.step()
    masses = [body.state.mass for body in O.bodies if body is not None and body.state.generation == 2]
    assert len(masses) == 4 and sum(masses) == pytest.approx(2500 * math.pi / 6 * 0.02 ** 3 / 4)


BAD = [('particles', 0), ('particles', 1.5), ('smallestDiameter', 0.05), ('containerWidth', 0.03), ('container', 'bag'), ('shape', 'egg'),
       ('mode', 'balls5'), ('criterion', 'mood'), ('characteristicStrength', 0), ('weibullModulus', -1), ('inertialSize', 0),
       ('smallestFragment', 0.015), ('maxStress', 1e2), ('maxStrain', 1), ('maxParticles', 20), ('strainRate', 0),
       ('numericalDamping', 1), ('restitution', 0.05), ('sampleStrain', math.nan), ('wheels', 4)]


@pytest.mark.parametrize('name, value', BAD)
def test_badInputIsNamedBeforeAnythingIsWritten(tmp_path, name, value):
    with pytest.raises(ValueError, match=f'{name} = '):
        run(tmp_path / 'new', **{name: value})
    assert not (tmp_path / 'new').exists()


def test_ballsAreForSpheres(tmp_path):
    with pytest.raises(ValueError, match="mode = 'balls4'"):
        run(tmp_path / 'new', shape='cube', mode='balls4')


@pytest.mark.parametrize('text', ('', 'cube,cube', 'cube,eggs'))
def test_badModes(text):
    with pytest.raises(ValueError, match='modes = '):
        comparison.modesOf(text)
