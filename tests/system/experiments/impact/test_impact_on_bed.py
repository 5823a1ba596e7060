"""A bed is poured once and hit many times: what an impact may change about it, and the control of its thickness."""
import os
import shutil

import pytest
from yade import O
from yade.wrapper import InteractionLoop

import yade.superquadric as sq
from yade.superquadric.experiments.impact import report
from yade.superquadric.experiments.oedometer.run import OedometerRun
from yade.superquadric.files import results, sealed
from yade.superquadric.pictures import renderer
from yade.superquadric.runs import checkpoint
from yade.superquadric.scene.engines import engine

SMALL = {'containerDiameter': 0.07, 'thickness': 0.012, 'impactorDiameter': 0.03, 'thicknessTolerance': 1}


@pytest.fixture(autouse=True)
def noPicturesOfParticles(monkeypatch):
    """They take longer than these impacts."""
    monkeypatch.setattr(renderer, 'missing', lambda: 'not wanted here')


@pytest.fixture(scope='module')
def bed(tmp_path_factory):
    output = tmp_path_factory.mktemp('bed')
    sq.ImpactRun.begin(SMALL, str(output), stream=None).run(until='prepare')
    return output


def impact(bed, output, **parameters):
    return sq.ImpactRun.onBed(str(bed), parameters, str(output), stream=None).run()


def test_bedFolderHoldsTheBedOnly(bed):
    assert sorted(os.listdir(bed)) == ['bed.json', 'bed.yade.gz', 'before.npz']
    assert results.readJson(str(bed / 'bed.json'))['stage'] == 'prepare'


def test_bedAndImpactEqualOneRun(bed, tmp_path):
    """Bit for bit, on one thread."""
    if O.numThreads != 1:
        pytest.skip('the order of summation is only fixed on one thread')
    whole = sq.ImpactRun.begin(SMALL, str(tmp_path / 'whole'), stream=None).run()
    parts = impact(bed, tmp_path / 'parts')
    assert (tmp_path / 'whole' / 'force.csv').read_bytes() == (tmp_path / 'parts' / 'force.csv').read_bytes()
    assert sorted(os.listdir(tmp_path / 'whole')) == sorted(os.listdir(tmp_path / 'parts'))
    assert whole['parameters'] == parts['parameters']
    assert whole['solver']['solves'] == pytest.approx(parts['solver']['solves'], rel=0.01)  # a loaded scene has to look at all pairs anew
    assert {**whole['bed'], 'wallSeconds': 0} == {**parts['bed'], 'wallSeconds': 0}


def test_impactsOnOneBedDiffer(bed, tmp_path):
    """A heavier impactor pushes harder on the same bed."""
    light, heavy = (impact(bed, tmp_path / str(density), impactorDensity=density) for density in (1500, 6000))
    assert heavy['impact']['impulse'] > 2 * light['impact']['impulse'] and heavy['P0'] > light['P0']
    assert light['bed']['thickness'] == heavy['bed']['thickness']


def test_placeOfTheImpact(bed, tmp_path):
    """Above another place the impactor meets other particles; it has the same speed at the surface."""
    middle, beside = impact(bed, tmp_path / 'middle'), impact(bed, tmp_path / 'beside', impactorX=0.012, impactorY=-0.01)
    start = O.bodies[len(O.bodies) - 1].state.refPos
    assert (start[0], start[1]) == (0.012, -0.01)
    assert middle['impact']['peak'] != beside['impact']['peak'] and middle['bed']['staticForce'] == beside['bed']['staticForce']
    assert middle['impactor'] == beside['impactor']
    with pytest.raises(ValueError, match='impactorY = 0.03: the impactor .* would meet the wall'):
        impact(bed, tmp_path / 'wall', impactorY=0.03)


def test_theLawsBoundsReachTheLaw(bed, tmp_path):
    peaks = [impact(bed, tmp_path / str(i), **change)['impact']['peak']
             for i, change in enumerate(({}, {'overlapLimit': 0.3}, {'effectiveMassAtContact': False}))]
    assert len(set(peaks)) == 3
    law = engine(InteractionLoop).lawDispatcher.functors[0]
    assert law.effectiveMassAtContact is False and law.overlapLimit == 0.1


def test_aStifferBaseIsInTheContactsAndInP0(bed, tmp_path):
    """Between two equal bodies E* is E/(2(1 - nu^2)), on a rigid one twice that: P0 then grows by 2^0.4 for undamped spheres."""
    own, rigid = impact(bed, tmp_path / 'own'), impact(bed, tmp_path / 'rigid', baseYoung=1e15)
    # Of the bed at rest: an impact ends with the bed in the air, and whether a particle touches the base just then is chance.
    sq.ImpactRun.onBed(str(bed), {'baseYoung': 1e15}, str(tmp_path / 'rest'), stream=None).run(until='static')
    contacts = [i.phys for i in O.interactions.all(onlyReal=True) if i.id1 == 0]
    assert len(contacts) > 5 and all(phys.effectiveModulus == pytest.approx(1e9 / (1 - 0.2 ** 2), rel=1e-5) for phys in contacts)
    assert rigid['P0'] / own['P0'] == pytest.approx(2 ** 0.4, rel=0.03)
    assert rigid['bed']['atRest']['true']
    assert rigid['bed']['staticForce'] + rigid['bed']['staticWallForce'] == pytest.approx(rigid['bed']['weight'], rel=1e-2)


def test_anotherBedIsRefused(bed, tmp_path):
    with pytest.raises(ValueError, match=r'friction = 0.3: the bed in .* was poured with 0.4'):
        impact(bed, tmp_path, friction=0.3)
    with pytest.raises(ValueError, match=r'bed = .*: there is no finished bed'):
        impact(tmp_path, tmp_path / 'other')
    with pytest.raises(ValueError, match=r'overlapLimit = 2'):
        impact(bed, tmp_path, overlapLimit=2)
    with pytest.raises(ValueError, match=r"effectiveMassAtContact = 'maybe': must be true or false"):
        impact(bed, tmp_path, effectiveMassAtContact='maybe')
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize('name, content, message', [
    ('bed.json', b'', 'bed.json is damaged'), ('bed.json', b'{}', 'bed.json is damaged'), ('bed.json', b'[]', 'bed.json is damaged'),
    ('bed.yade.gz', None, 'bed.yade.gz is missing'), ('before.npz', None, 'before.npz is missing'),
    ('bed.yade.gz', b'scene', 'bed.yade.gz is damaged'), ('before.npz', b'particles', 'before.npz is damaged')])
def test_damagedBedsAreRefused(bed, tmp_path, name, content, message):
    """In one line, and before the results of an earlier run in the output folder are removed."""
    shutil.copytree(bed, tmp_path / 'bed')
    (tmp_path / 'bed' / name).unlink()
    if content is not None:
        (tmp_path / 'bed' / name).write_bytes(content)
    (tmp_path / 'impact').mkdir()
    (tmp_path / 'impact' / 'summary.json').write_text('earlier')
    with pytest.raises(ValueError, match=f'bed = .*: {message}') as error:
        impact(tmp_path / 'bed', tmp_path / 'impact')
    assert '\n' not in str(error.value)
    assert (tmp_path / 'impact' / 'summary.json').read_text() == 'earlier'


def test_bedsOfAnotherVersionAreRefused(bed, tmp_path):
    shutil.copytree(bed, tmp_path / 'bed')
    sealed.write(str(tmp_path / 'bed' / 'bed.json'), {'parameters': {'shape': 'cube'}}, ('bed.yade.gz', 'before.npz'))
    with pytest.raises(ValueError, match='bed = .*: bed.json is of another version .the parameter n1 is missing.; make the bed again'):
        impact(tmp_path / 'bed', tmp_path / 'impact')


def test_theBedsFolderIsNotTheOutput(bed, tmp_path):
    """A run removes what an earlier one has left in its folder: the bed must not be in it."""
    shutil.copytree(bed, tmp_path / 'bed')
    (tmp_path / 'link').symlink_to(tmp_path / 'bed')
    for output in (tmp_path / 'bed', tmp_path / 'link'):
        with pytest.raises(ValueError, match='output = .*: holds the bed'):
            impact(tmp_path / 'bed', output)
    assert sorted(os.listdir(tmp_path / 'bed')) == ['bed.json', 'bed.yade.gz', 'before.npz']


def test_damagedCheckpointIsNamed(bed, tmp_path):
    sq.ImpactRun.onBed(str(bed), {}, str(tmp_path), stream=None).run(until='static')
    state = (tmp_path / 'checkpoint.json').read_bytes()
    for name, content in (('checkpoint.json', b''), ('checkpoint.yade.gz', b'scene')):
        (tmp_path / 'checkpoint.json').write_bytes(state)
        (tmp_path / name).write_bytes(content)
        with pytest.raises(ValueError, match='output = .*: its checkpoint is damaged .*remove checkpoint.json'):
            sq.ImpactRun.resume(str(tmp_path), stream=None)


def test_interruptedImpactOnABedResumes(bed, tmp_path):
    whole = impact(bed, tmp_path / 'whole', baseYoung=1e10)
    sq.ImpactRun.onBed(str(bed), {'baseYoung': 1e10}, str(tmp_path / 'parts'), stream=None).run(until='impact')
    assert sq.ImpactRun.isInterrupted(str(tmp_path / 'parts'))
    parts = sq.ImpactRun.resume(str(tmp_path / 'parts'), stream=None).run()
    assert parts['impact'] == whole['impact']


def test_thicknessIsControlled(tmp_path):
    """From a poor guess of the packing fraction, within the tolerance; the attempts are told."""
    parameters = {**SMALL, 'thickness': 0.02, 'thicknessTolerance': 0.05, 'solidFraction': 0.45, 'shape': 'sphere'}
    summary = sq.ImpactRun.begin(parameters, str(tmp_path), stream=None).run()
    pours = summary['bed']['pours']
    assert len(pours) > 1 and abs(pours[0]['thickness'] / 0.02 - 1) > 0.05
    assert summary['bed']['thickness'] == pytest.approx(0.02, rel=0.05)
    assert summary['particle']['number'] == pours[-1]['number']
    assert 'WARNING' not in report.text(summary)


def test_aPoorGuessDoesNotMakeAContainerOverfull(tmp_path):
    """The guess says that the bed just fits; the first pour shows that there is room for twice as many particles."""
    parameters = {**SMALL, 'thickness': 0.02, 'containerHeight': 0.021, 'thicknessTolerance': 0.1, 'solidFraction': 0.33, 'shape': 'sphere',
                  'pouringSoftening': 1000, 'restEnergy': 1e-4}
    run = sq.ImpactRun.begin(parameters, str(tmp_path), stream=None)
    run.run(until='stiffen')
    assert len(run.state.pours) > 1 and run.state.pours[-1]['thickness'] == pytest.approx(0.02, rel=0.1)


def test_thicknessThatIsMissedIsTold(bed, tmp_path):
    shutil.copytree(bed, tmp_path / 'bed')
    state = sealed.read(str(tmp_path / 'bed' / 'bed.json'))
    state['parameters']['thicknessTolerance'] = 1e-4
    sealed.write(str(tmp_path / 'bed' / 'bed.json'), state, ('bed.yade.gz', 'before.npz'))
    assert 'WARNING    the bed is' in report.text(impact(tmp_path / 'bed', tmp_path / 'impact'))


def kill(*_):
    raise KeyboardInterrupt


def test_killedInTheFirstSavingThereIsNoCheckpoint(bed, tmp_path, monkeypatch):
    """The run begins anew instead of going on from halves that do not fit."""
    run = sq.ImpactRun.onBed(str(bed), {}, str(tmp_path), stream=None)
    monkeypatch.setattr(results, 'writeJson', kill)
    with pytest.raises(KeyboardInterrupt):
        run.run(until='static')
    monkeypatch.undo()
    assert not sq.ImpactRun.isInterrupted(str(tmp_path)) and (tmp_path / 'checkpoint.yade.gz').exists()
    assert impact(bed, tmp_path)['impact']['over']
    assert not (tmp_path / 'checkpoint.yade.gz').exists()


@pytest.mark.parametrize('module, name, stepsLost', [(results, 'writeJson', 1), (os, 'replace', 1), (os, 'remove', 0)])
def test_killedInALaterSavingOneCheckpointIsWhole(bed, tmp_path, monkeypatch, module, name, stepsLost):
    """That of before, or the new one; also when it was killed there twice in a row."""
    run = sq.ImpactRun.onBed(str(bed), {}, str(tmp_path), stream=None)
    run.run(until='static')
    for _ in range(2):
        O.step()
        monkeypatch.setattr(module, name, kill)
        with pytest.raises(KeyboardInterrupt):
            run.save()
        monkeypatch.undo()
        steps = O.iter
        sq.ImpactRun.resume(str(tmp_path), stream=None)
        assert O.iter == steps - stepsLost
    run.save()
    assert len([file for file in os.listdir(tmp_path) if 'checkpoint' in file]) == 2
    checkpoint.remove(str(tmp_path))
    assert not [file for file in os.listdir(tmp_path) if 'checkpoint' in file]


def test_runsOfAnotherKindAreNotResumed(bed, tmp_path):
    sq.ImpactRun.onBed(str(bed), {}, str(tmp_path), stream=None).run(until='static')
    bodies = len(O.bodies)
    O.reset()
    with pytest.raises(ValueError, match='output = .*: the interrupted run there is of the kind ImpactRun, not OedometerRun'):
        OedometerRun.resume(str(tmp_path), stream=None)
    assert len(O.bodies) == 0 and sq.ImpactRun.isInterrupted(str(tmp_path))
    sq.ImpactRun.resume(str(tmp_path), stream=None)
    assert len(O.bodies) == bodies


def test_aStageThatIsPastIsRefused(bed, tmp_path):
    sq.ImpactRun.onBed(str(bed), {}, str(tmp_path), stream=None).run(until='static')
    run = sq.ImpactRun.resume(str(tmp_path), stream=None)
    for until, message in (('prepare', "the run in .* is already in the stage 'static'"), ('nap', 'must be one of pour, ')):
        with pytest.raises(ValueError, match=f'until = {until!r}: {message}'):
            run.run(until=until)
    run.run(until='impact')
    assert run.state.stage == 'impact'
