"""The impact study as a whole, on a small bed: forces in balance, same seed same record, stop and resume."""
import io
import math
import os
import signal
import subprocess
import sys
import time

import pytest
from PIL import Image
from project import LIMIT, PROJECT
from yade import O
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.experiments.impact import forceplot, report
from yade.superquadric.experiments.impact.fall import surfaceSpeed
from yade.superquadric.experiments.impact.impactor import supportForce
from yade.superquadric.experiments.impact.parameters import ImpactParameters
from yade.superquadric.experiments.impact.run import ImpactState
from yade.superquadric.files import results, sealed
from yade.superquadric.pictures import render

SMALL = {'containerDiameter': 0.08, 'thickness': 0.015, 'impactorDiameter': 0.03, 'thicknessTolerance': 1}
SMALL_OPTIONS = [text for name, value in SMALL.items() for text in ('--' + name, str(value))]
FILES = ['after.npz', 'bed.png', 'before.npz', 'chains.png', 'force.csv', 'force.png', 'impact.gif', 'summary.json']


def run(output, pictures=False, **parameters):
    job = sq.ImpactRun.begin({**SMALL, **parameters}, str(output), stream=None)
    job.pictures = pictures
    return job.run()


@pytest.fixture(scope='module')
def small(tmp_path_factory):
    output = tmp_path_factory.mktemp('small')
    return output, run(output, pictures=True)


def record(output):
    columns, rows = results.readCsv(str(output / 'force.csv'))
    return {name: [row[k] for row in rows] for k, name in enumerate(columns)}


def test_filesAreThere(small):
    output, _ = small
    assert sorted(os.listdir(output)) == FILES
    for name in ('bed.png', 'chains.png', 'force.png', 'impact.gif'):
        assert os.path.getsize(output / name) > 10000


def test_animationOfTheImpact(small):
    with Image.open(small[0] / 'impact.gif') as film:
        assert 20 < film.n_frames <= 60 and os.path.getsize(small[0] / 'impact.gif') < 2e6


def test_seriesForParaView(tmp_path):
    """--vtk: frames at equal times from the start of the impact, at all of which the impactor is there."""
    done = script(tmp_path, *SMALL_OPTIONS, '--particles', '20', '--noPictures', '--vtk')
    assert done.communicate(timeout=LIMIT) and done.returncode == 0
    series = sq.RecordedSeries(str(tmp_path / 'vtk'))
    times = [moment.time for moment in series.moments]
    steps = {round((later - earlier) / 1.5e-4, 1) for earlier, later in zip(times, times[1:])}
    assert len(times) > 20 and steps == {1.0}
    assert [len(frame.particles) for frame in series[:2]] == [21, 21]
    assert series[0].speeds().max() == pytest.approx(surfaceSpeed(5, 0.3), rel=0.05)
    assert sorted(name for name in os.listdir(tmp_path) if name in ('frames', 'vtk', 'bed.png')) == ['vtk']


def test_bedIsAtRest(small):
    """Also in the 200 steps before the impact, without numerical damping."""
    bed = small[1]['bed']
    assert bed['atRest'] == {'soft': True, 'true': True}
    assert bed['staticForce'] + bed['staticWallForce'] == pytest.approx(bed['weight'], rel=1e-2)


def test_baseAndWallCarryTheWeight():
    """The base's mean force on a settled bed is the bed's weight less what the wall carries, within 0.1 %."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                            tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(material)
    container = sq.cylinderContainer(0.025, 0.2, material)
    ids, container = sq.rainFilling([sq.particleShape('cube')] * 60, container, material, seed=4)
    O.engines = sq.superquadricEngines()
    O.dt = 0.1 * sq.criticalTimeStep()
    stepper, base, wall = sq.Stepper(stream=None), [], []
    assert sq.settle(stepper, sq.RestCriterion(ids, (container.baseId, *container.sideIds), 1e-7, 1e-3), maxTime=1.5)
    stepper.run(500, lambda: (base.append(supportForce([container.baseId])), wall.append(supportForce(container.sideIds))))
    weight = 9.81 * sum(O.bodies[i].state.mass for i in ids)
    assert sum(base) / len(base) == pytest.approx(weight - sum(wall) / len(wall), rel=1e-3)
    assert abs(sum(wall) / len(wall)) > 5e-3 * weight  # else the wall's share would not be tested


def test_summaryFollowsFromTheRecord(small):
    output, summary = small
    assert results.readJson(str(output / 'summary.json')) == summary
    assert summary['parameters'] == ImpactParameters.checked(SMALL).asDict()
    force = [f - summary['bed']['staticForce'] for f in record(output)['baseForce']]
    assert summary['impact']['peak'] == max(force)
    assert summary['bufferingRatio'] == pytest.approx(1 - max(force) / summary['P0'])
    assert summary['bed']['thickness'] == pytest.approx(0.015, rel=0.2)


def test_momentumBalanceOfTheImpactor(small):
    """The impulse of the recorded contact force and of gravity is the change of the impactor's momentum."""
    output, summary = small
    columns, mass, dt = record(output), summary['impactor']['mass'], summary['timeStep']['impact']
    impulse = sum(columns['impactorForce'][1:]) * dt - mass * 9.81 * dt * (len(columns['time']) - 1)
    change = mass * (columns['impactorVelocity'][-1] - columns['impactorVelocity'][0])
    assert impulse == pytest.approx(change, rel=1e-9)


def test_impactorReachesTheSurfaceWithItsSpeed(small):
    output, summary = small
    columns = record(output)
    thickness = summary['bed']['thickness']
    speed, height = -columns['impactorVelocity'][0], columns['impactorHeight'][0]
    assert speed ** 2 + 2 * 9.81 * (height - thickness) == pytest.approx(5 ** 2 + 2 * 9.81 * 0.3, rel=1e-4)
    assert summary['impactor']['surfaceSpeed'] == pytest.approx(5.558, abs=5e-4)


def test_sameSeedSameRecord(small, tmp_path):
    """Bit for bit, on one thread."""
    if O.numThreads != 1:
        pytest.skip('the order of summation is only fixed on one thread')
    run(tmp_path)
    assert (tmp_path / 'force.csv').read_bytes() == (small[0] / 'force.csv').read_bytes()


def test_yadeSpheresRunToo(tmp_path):
    summary = run(tmp_path, shape='sphere', radiusSpread=0.1)
    assert summary['particle']['yadeSphere'] and summary['bed']['atRest']['true']
    assert 0 < summary['bufferingRatio'] < 1


def test_pulseOfAKnownForce():
    times = [1e-5 * i for i in range(1001)]
    forces = [20 + (1000 * math.sin(math.pi * (t - 2e-3) / 4e-3) if 2e-3 <= t <= 6e-3 else 0) for t in times]
    pulse = sq.pulse(times, forces, staticForce=20)
    assert pulse.peak == pytest.approx(1000) and pulse.peakTime == pytest.approx(4e-3)
    # sin > 0.1 for all but 2 asin(0.1) of pi
    assert pulse.duration == pytest.approx(4e-3 * (1 - 2 * math.asin(0.1) / math.pi), abs=2e-5)
    assert pulse.impulse == pytest.approx(1000 * 4e-3 / math.pi * 2 * math.cos(math.asin(0.1)), rel=5e-3)


def test_batchTable(tmp_path):
    """As yade-batch starts a job: the table's line gives the parameters, its description the folder."""
    table = tmp_path / 'some.table'
    table.write_text("description shape thickness containerDiameter impactorDiameter\n"
                     "flat 'sphere' 0.01 0.06 0.02\nhigh 'sphere' 0.02 0.06 0.02\n")
    command = [sys.executable, sys.yade_argv[0], '-n', '-x', PROJECT / 'scripts' / 'impact.py', '--noPictures']
    done = subprocess.run(command, cwd=tmp_path, env={**os.environ, 'YADE_BATCH': f'{table}:3'}, capture_output=True,
                          text=True, timeout=LIMIT)
    assert done.returncode == 0, done.stderr
    parameters = results.readJson(str(tmp_path / 'results' / 'high' / 'summary.json'))['parameters']
    assert parameters == ImpactParameters.checked({'shape': 'sphere', 'thickness': 0.02, 'containerDiameter': 0.06,
                                                   'impactorDiameter': 0.02}).asDict()


def script(output, *arguments):
    command = [sys.executable, sys.yade_argv[0], '-n', '-x', PROJECT / 'scripts' / 'impact.py', '--output',
               str(output), *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def test_ctrlCLeavesACheckpointThatResumes(small, tmp_path):
    output = tmp_path / 'stopped'
    first = script(output, *SMALL_OPTIONS)
    while first.poll() is None and 'step' not in first.stderr.readline():
        time.sleep(0.05)
    first.send_signal(signal.SIGINT)
    _, message = first.communicate(timeout=LIMIT)
    assert first.returncode == 130 and '--resume' in message and 'Traceback' not in message
    assert (output / 'checkpoint.yade.gz').exists() and not (output / 'summary.json').exists()
    O.load(str(output / 'checkpoint.yade.gz'))
    assert len(O.bodies) == 2 + small[1]['particle']['number']
    again = script(output, *SMALL_OPTIONS)  # --resume forgotten
    assert 'holds an interrupted run; use --resume' in again.communicate(timeout=LIMIT)[1] and again.returncode == 2
    second = script(output, '--resume', '--noPictures')
    text, _ = second.communicate(timeout=LIMIT)
    assert second.returncode == 0 and 'peak P' in text
    assert (output / 'force.csv').read_bytes() == (small[0] / 'force.csv').read_bytes()
    assert sorted(os.listdir(output)) == [name for name in FILES if not name.endswith(('png', 'gif'))]


# Within a portion of steps, before its first and before its last; the steps count from the resumption before.
STOPS = [('pour', 100), ('pour', 5000), ('stiffen', 0), ('stiffen', 700), ('rest', 149), ('static', 77), ('impact', 0),
         ('impact', 555), ('impact', 244)]


def test_stoppedAtAnyStepItEqualsTheUninterruptedRun(small, tmp_path, monkeypatch):
    """Bit for bit, on one thread: a run stopped in every stage and resumed as often."""
    if O.numThreads != 1:
        pytest.skip('the order of summation is only fixed on one thread')
    stops = list(STOPS)

    def stop(stepper):
        if stops and (stepper.stage, stepper.stageSteps) == stops[0]:
            stops.pop(0)
            os.kill(os.getpid(), signal.SIGINT)
    monkeypatch.setattr(sq.Stepper, 'report', stop)
    job = sq.ImpactRun.begin(SMALL, str(tmp_path), stream=None)
    for left in range(len(STOPS) - 1, -1, -1):
        with pytest.raises(sq.Interrupted):
            job.run()
        assert len(stops) == left
        job = sq.ImpactRun.resume(str(tmp_path), stream=None)
    summary = job.run()
    assert (tmp_path / 'force.csv').read_bytes() == (small[0] / 'force.csv').read_bytes()
    for part in ('bed', 'impact', 'P0', 'bufferingRatio', 'timeStep'):
        assert summary[part] == small[1][part]
    assert summary['solver']['solves'] == pytest.approx(small[1]['solver']['solves'], rel=0.01)  # those of all parts
    films = [Image.open(folder / 'impact.gif') for folder in (tmp_path, small[0])]
    assert films[0].n_frames == films[1].n_frames > 20, 'the frames from before the stops are there'


def test_blowThatDoesNotArriveKeepsItsRecord(tmp_path):
    output = tmp_path / 'short'
    done = script(output, *SMALL_OPTIONS, '--noPictures', '--particles', '20', '--maxImpactTime', '1e-4')
    _, message = done.communicate(timeout=LIMIT)
    assert done.returncode == 2 and 'Traceback' not in message
    assert 'no blow reached the base' in message and 'maxImpactTime' in message
    assert len(record(output)['time']) >= 100
    # With more time the same run finds its blow.
    state = sealed.read(str(output / 'checkpoint.json'))
    state['parameters']['maxImpactTime'] = 0.05
    sealed.write(str(output / 'checkpoint.json'), state, ('checkpoint.yade.gz',))
    assert not (output / 'chains.png').exists()
    resumed = sq.ImpactRun.resume(str(output), stream=None)
    resumed.pictures = False
    summary = resumed.run()
    assert summary['impact']['over'] and summary['impact']['peak'] > 10 * summary['bed']['weight']


def test_doubtfulResultsCarryAWarning(small):
    summary = small[1]
    assert 'WARNING' not in report.text(summary)
    bed, impact, solver = summary['bed'], summary['impact'], summary['solver']
    assert solver['solves'] > 0
    for doubtful, words in (({'bed': {**bed, 'atRest': {'soft': False, 'true': True}}}, 'maxSettlingTime'),
                            ({'bed': {**bed, 'atRest': {'soft': True, 'true': False}}}, 'not at rest'),
                            ({'impact': {**impact, 'over': False}}, 'maxImpactTime'),
                            ({'solver': {**solver, 'uncertified': 3}}, '3 of')):
        lines = [line for line in report.text({**summary, **doubtful}).splitlines() if line.startswith('WARNING')]
        assert len(lines) == 1 and words in lines[0]


def test_newRunInAFolderRemovesTheOldResults(tmp_path):
    for name in FILES:
        (tmp_path / name).write_text('old')
    (tmp_path / 'mine.txt').write_text('mine')
    for folder in ('vtk', 'frames'):
        (tmp_path / folder).mkdir()
    (tmp_path / 'frames' / '000001.npz').write_text('old')
    sq.ImpactRun.begin({**SMALL, 'particles': 3}, str(tmp_path), stream=None)
    assert os.listdir(tmp_path) == ['mine.txt']
    (tmp_path / 'frames').mkdir()
    for name in ('000002.npz', '000003.npz.part', 'mine.npz'):
        (tmp_path / 'frames' / name).write_text('old')
    sq.ImpactRun.begin({**SMALL, 'particles': 3}, str(tmp_path), stream=None)
    assert os.listdir(tmp_path / 'frames') == ['mine.npz'], 'only what a run writes goes'


def test_failedPicturesCostNoResults(tmp_path, monkeypatch):
    """Frames are kept then, until the next run in the folder; without pictures none are left."""
    def fail(*_, **__):
        raise OSError('the disk is full')
    monkeypatch.setattr(render, 'picture', fail)
    monkeypatch.setattr(forceplot, 'forcePicture', fail)
    said = io.StringIO()
    job = sq.ImpactRun.begin({**SMALL, 'particles': 20}, str(tmp_path), stream=said)
    summary = job.run()
    assert results.readJson(str(tmp_path / 'summary.json')) == summary and len(os.listdir(tmp_path / 'frames')) > 20
    assert 'no pictures of the particles: the disk is full' in said.getvalue() and 'no pictures of the force' in said.getvalue()
    job.pictures = False
    job.state.stage = 'report'
    job.run()
    assert not (tmp_path / 'frames').exists()


def test_aSeriesBelongsToTheImpact(tmp_path):
    """Not to the bed."""
    done = script(tmp_path / 'bed', '--bedOnly', '--vtk')
    message = done.communicate(timeout=LIMIT)[1]
    assert done.returncode == 2 and 'vtk: the series is of the impact' in message and not (tmp_path / 'bed').exists()
    run = sq.ImpactRun.inFolder(str(tmp_path), ImpactParameters.checked(SMALL), ImpactState(stage='prepare', vtk=True), stream=None)
    assert run.state.vtk is False


def test_aFinishedBedIsNotPouredAgain(tmp_path):
    done = script(tmp_path / 'new', '--bed', str(tmp_path), '--bedOnly')
    message = done.communicate(timeout=LIMIT)[1]
    assert done.returncode == 2 and 'bedOnly: the bed in' in message and not (tmp_path / 'new').exists()
