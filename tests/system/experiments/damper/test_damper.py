"""The run of a particle damper (damper.DamperRun) with few soft particles: results, energies, interruption, bad input."""
import cmath
import csv
import json
import math
import os
import signal

import pytest
from yade import O
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.experiments.damper import run as damper
from yade.superquadric.experiments.damper.parameters import DamperParameters
from yade.superquadric.experiments.damper.report import FILES, text
from yade.superquadric.experiments.damper.run import DamperRun

SMALL = dict(particles=60, radius=1.5e-3, boxWidth=0.015, boxDepth=0.015, boxHeight=0.016, totalParticleMass=0.05, boxMass=0.1, stiffness=4000,
             forceAmplitude=5, frequency=30, transientTime=0.05, periods=5, samples=40, softening=1e4, maxSettlingTime=0.1)


def run(folder, **changes):
    return DamperRun.begin({**SMALL, **changes}, str(folder), stream=None)


@pytest.fixture(scope='module')
def small(tmp_path_factory):
    """Folder and summary of a finished run."""
    folder = tmp_path_factory.mktemp('damper')
    return folder, run(folder).run()


def test_resultsAreComplete(small):
    folder, summary = small
    assert sorted(os.listdir(folder)) == sorted(FILES)
    with open(folder / 'summary.json') as file:
        assert json.load(file) == json.loads(json.dumps(summary))
    with open(folder / 'motion.csv') as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == (2 + 5) * 40  # 0.05 s are one and a half periods
    times = [float(row['time']) for row in rows]
    assert times[0] == pytest.approx(summary['timeStep']['step'] / 2, rel=1e-6)
    assert times[-1] - times[0] == pytest.approx((len(rows) - 1) / (30 * 40), rel=1e-9)
    assert 'balance' in text(summary) and '30 Hz' in text(summary)


def test_particlesAreThoseAskedFor(small):
    particles = small[1]['particles']
    assert particles['number'] == 60 and particles['mass'] == pytest.approx(0.05, rel=1e-3)  # the sizes scatter
    assert small[1]['naturalFrequency']['withParticles'] == pytest.approx(math.sqrt(4000 / 0.15) / 2 / math.pi, rel=1e-3)


def test_energyBalanceCloses(small):
    energy = small[1]['energy']
    assert abs(energy['balanceError']) < 0.01  # particles so soft turn about each other while they touch, which the law books to first order
    assert energy['work'] > 0 and energy['dissipated'] > 0.5 * energy['work'] and sum(energy['shares'].values()) == pytest.approx(1)
    assert energy['shares']['normDampDissip'] > 0.1 and energy['shares']['yieldDissip'] > 0.01 and energy['shares']['boxDashpot'] == 0
    assert energy['work'] + energy['gravityWork'] == pytest.approx(energy['dissipated'] + energy['stored'] + energy['nonconservative'], rel=0.01)


def test_stoppedAtAnyStepItEqualsTheUninterruptedRun(small, tmp_path, monkeypatch):
    if O.numThreads != 1:
        pytest.skip('the order of summation is only fixed on one thread')
    stops = [('settle', 333), ('drive', 77), ('drive', 2000)]

    def stop(stepper):
        if stops and (stepper.stage, stepper.stageSteps) == stops[0]:
            stops.pop(0)
            os.kill(os.getpid(), signal.SIGINT)
    monkeypatch.setattr(sq.Stepper, 'report', stop)
    job = run(tmp_path)
    for left in (2, 1, 0):
        with pytest.raises(sq.Interrupted):
            job.run()
        assert len(stops) == left and DamperRun.isInterrupted(str(tmp_path))
        job = DamperRun.resume(str(tmp_path), stream=None)
    summary = job.run()
    assert (tmp_path / 'motion.csv').read_bytes() == (small[0] / 'motion.csv').read_bytes()
    assert summary['box'] == small[1]['box']
    assert summary['energy']['shares'] == pytest.approx(small[1]['energy']['shares'], rel=1e-9)


@pytest.mark.parametrize('frequency', (20, 45))
def test_emptyBoxThatStartsSteadyHasNoTransient(tmp_path, frequency):
    """Without a dashpot a free vibration would never die out."""
    changes = dict(particles=0, frequency=frequency, transientTime=0, samples=100)
    expected = 5 / abs(4000 - 0.1 * (2 * math.pi * frequency) ** 2)
    steady, rest = (run(tmp_path / start, start=start, **changes).run()['box'] for start in ('steady', 'rest'))
    assert steady['amplitude'] == pytest.approx(expected, rel=1e-3) and steady['fundamentalShare'] == pytest.approx(1, abs=1e-5)
    assert rest['fundamentalShare'] < 0.9


def test_startOfTheBox():
    def start(**changes):
        return DamperParameters.checked({**SMALL, 'frequency': 10, 'forceAmplitude': 1, **changes}).startOfTheBox()
    omega = 2 * math.pi * 10
    assert start() == pytest.approx((0, omega / (4000 - 0.15 * omega ** 2)))   # 1.2 m/s2: the particles ride along
    assert start(forceAmplitude=30)[1] == pytest.approx(30 * omega / (4000 - 0.1 * omega ** 2))
    damped = start(particles=0, dashpot=8.0)
    amplitude = 1 / complex(4000 - 0.1 * omega ** 2, 8 * omega)
    assert damped == pytest.approx((amplitude.imag, omega * amplitude.real))
    resonant = {'particles': 0, 'frequency': 200 / (2 * math.pi), 'forceAmplitude': 5}
    assert start(**resonant) == pytest.approx((-SMALL['boxHeight'], 0), abs=1e-9)
    assert start(**resonant, start='rest') == (0, 0)


@pytest.mark.parametrize('frequency', (20, 45))
def test_emptyBoxAnswersAsTheClosedFormDoes(tmp_path, frequency):
    changes = dict(particles=0, dashpot=4, frequency=frequency, transientTime=1, samples=100)
    summary = run(tmp_path, **changes).run()
    omega = 2 * math.pi * frequency
    expected = 5 / complex(4000 - 0.1 * omega ** 2, 4 * omega)
    assert summary['box']['amplitude'] == pytest.approx(abs(expected), rel=1e-4)
    assert summary['box']['phaseLag'] == pytest.approx(math.degrees(-cmath.phase(expected)) % 360, abs=0.05)
    assert summary['box']['period'] == 1 and summary['centroid'] is None and summary['energy']['shares'] == {'boxDashpot': 1}


@pytest.mark.parametrize('changes', (dict(axis='x'), dict(law='curvature', softening=1000), dict(shape='cube'),
                                     dict(shape='cylinder', aspect=1.2, radiusSpread=0)))
def test_otherDirectionsLawsAndShapesClose(tmp_path, changes):
    summary = run(tmp_path, periods=2, timeStepFraction=0.1, **changes).run()
    assert abs(summary['energy']['balanceError']) < 0.02
    assert summary['box']['peakToPeak'] > 1e-3 and summary['solver'].get('uncertified', 0) == 0
    assert summary['particles']['mass'] == pytest.approx(0.05, rel=1e-3)


def test_materialGivesWhatIsNotGiven(tmp_path):
    given = DamperParameters.checked(dict(material='steel-4340', young=190e9))
    assert (given.young, given.poisson, given.density) == (190e9, 0.32, 7830)
    assert DamperParameters.checked(given.asDict()) == given
    assert damper.newMaterial(given).yieldStress == 792e6
    assert isinstance(damper.newMaterial(given.changed({'law': 'curvature'})), CurvatureMat)


@pytest.mark.parametrize('softening', (10, 1000))
def test_softeningKeepsTheSpeedAtWhichItYields(softening):
    """The energy of a collision that just yields is fy dy/2.5, with fy as py^3/E^2 and dy as (py/E)^2: as py^5/E^4."""
    hard, soft = (damper.newMaterial(DamperParameters.checked(dict(softening=s))) for s in (1, softening))
    assert hard.young == pytest.approx(softening * soft.young)
    assert soft.yieldStress ** 5 / soft.young ** 4 == pytest.approx(hard.yieldStress ** 5 / hard.young ** 4, rel=1e-12)


BAD = [('material', 'cheese.yaml'), ('young', 1e8), ('rollingDamping', -1), ('particles', -1), ('particles', 1.5), ('particles', 10000),
       ('radius', 0), ('boxHeight', 1e-3), ('boxMass', 0), ('stiffness', -1),
       ('dashpot', -1), ('axis', 'xy'), ('frequency', 0), ('forceAmplitude', math.nan),
       ('restitution', 0.05), ('restitution', 1.1), ('periods', 1), ('samples', 5), ('law', 'magic'), ('start', 'soon'),
       ('shape', 'egg'), ('softening', 0.5), ('radiusSpread', 1), ('timeStepFraction', 2), ('wheels', 4)]


@pytest.mark.parametrize('name, value', BAD)
def test_badInputIsNamedBeforeAnythingIsWritten(tmp_path, name, value):
    with pytest.raises(ValueError, match=f'{name} = '):
        run(tmp_path / 'new', **{name: value})
    assert not (tmp_path / 'new').exists()


def test_interruptedFolderIsNotOverwritten(tmp_path, monkeypatch):
    monkeypatch.setattr(sq.Stepper, 'report', lambda stepper: stepper.stageSteps == 10 and os.kill(os.getpid(), signal.SIGINT))
    with pytest.raises(sq.Interrupted):
        run(tmp_path).run()
    with pytest.raises(ValueError, match='holds an interrupted run'):
        run(tmp_path)


def test_sizesAreNormalAndCut():
    radii = [shape.extents[0] / 1e-3 - 1 for shape in DamperParameters.checked({'particles': 4000}).drawnShapes(4000, seed=1)]
    assert max(map(abs, radii)) <= 0.01
    assert math.sqrt(sum(r * r for r in radii) / 4000) == pytest.approx(0.01 / 3, rel=0.05)
    assert len(set(radii)) == 4000


def test_paperNumbers():
    """What the paper prints of its system, and where its mass is ten times that of its spheres."""
    paper = DamperParameters.checked({})
    assert paper.filling() == pytest.approx(0.2, abs=0.003)
    assert paper.naturalFrequency() == pytest.approx(28.7, abs=0.06)
    assert paper.naturalFrequency(0.222) == pytest.approx(21.7, abs=0.05)
    assert 2000 * paper.meanShape.volume * 2700 == pytest.approx(0.0226, abs=1e-4)
    assert paper.changed({'totalParticleMass': 0.222}).particleDensity() == pytest.approx(26500, rel=1e-3)
