"""Bad input: a ValueError that names parameter and value, before anything changes; from the script exit code 2."""
import math
import os
import subprocess
import sys

import pytest
from project import LIMIT, PROJECT
from yade import O
from yade.minieigenHP import Quaternion
from yade.wrapper import CurvatureMat, Superquadric

import yade.superquadric as sq
from yade.superquadric.experiments.impact.parameters import ImpactParameters

NAN, INF = float('nan'), float('inf')


@pytest.fixture
def material():
    O.reset()
    result = CurvatureMat(young=1e9, poisson=0.2, density=2500, frictionAngle=0.38)
    O.materials.append(result)
    return result


@pytest.mark.parametrize('value', [(0, 1, 1), (1, -1, 1), (1, 1, NAN), (INF, 1, 1)])
def test_extents(material, value):
    bad = next(x for x in value if not (x > 0 and math.isfinite(x)))
    with pytest.raises(ValueError, match=rf'extents.*{bad}'):
        sq.superquadric((0, 0, 0), value, 8, 8, material)
    with pytest.raises(ValueError, match='extents'):
        Superquadric(extents=value)
    assert len(O.bodies) == 0


def test_twoExtents(material):
    with pytest.raises(ValueError, match=r'extents = \(1, 1\)'):
        sq.superquadric((0, 0, 0), (1, 1), 8, 8, material)


@pytest.mark.parametrize('value', [(1, 2), (1, 2, 3, 4), 5, (0, 0, NAN)])
def test_center(material, value):
    with pytest.raises(ValueError, match='center.* = '):
        sq.superquadric(value, (1, 1, 1), 8, 8, material)


@pytest.mark.parametrize('value', [Quaternion(0, 0, 0, 0), Quaternion(1, NAN, 0, 0), (1, 0, 0)])
def test_orientation(material, value):
    for shape in (sq.particleShape('cube'), sq.particleShape('sphere')):
        with pytest.raises(ValueError, match='orientation = '):
            shape.body((0, 0, 0), value, material)


def test_orientationIsNormalised(material):
    body = sq.superquadric((0, 0, 0), (1, 1, 1), 8, 8, material, Quaternion(0, 3, 0, 4))
    assert [body.state.ori[k] for k in range(4)] == pytest.approx([0.6, 0, 0.8, 0])  # x, y, z, w


@pytest.mark.parametrize('value', [1.9, 0, -3, 20.5, NAN, INF])
def test_exponents(material, value):
    for name, pair in (('n1', (value, 8)), ('n2', (8, value))):
        with pytest.raises(ValueError, match=f'{name} = {value}'):
            sq.superquadric((0, 0, 0), (1, 1, 1), *pair, material)
        with pytest.raises(ValueError, match=name):
            Superquadric(extents=(1, 1, 1), **{name: value})


@pytest.mark.parametrize('name, value', [
    ('frictionAngle', -0.1), ('normalDamping', -0.01), ('normalDamping', 1.0), ('normalDamping', 1.5),
    ('tangentialDamping', -1.0), ('rollingFriction', -0.002), ('young', 0.0), ('density', -2500.0), ('poisson', 0.6)])
def test_materials(name, value):
    material = CurvatureMat(young=1e9, poisson=0.2, density=2500)
    before = getattr(material, name)
    with pytest.raises(ValueError, match=name):
        setattr(material, name, value)
    assert getattr(material, name) == before


def test_containerSmallerThanAParticle(material):
    shape = sq.particleShape('cube')
    for radius, height, name in ((5e-3, 0.3, 'radius'), (0.095, 0.01, 'height')):
        with pytest.raises(ValueError, match=f'container {name} = {radius if name == "radius" else height}'):
            sq.cylinderContainer(radius, height, material, shape.boundingRadius)
    with pytest.raises(ValueError, match='container depth = 0.01'):
        sq.boxContainer(0.1, 0.01, 0.1, material, shape.boundingRadius)
    assert len(O.bodies) == 0


def test_timeStepAboveTheCriticalOne(material):
    O.bodies.append(sq.superquadric((0, 0, 0), (5e-3,) * 3, 8, 8, material))
    critical = sq.criticalTimeStep()
    # (14): pi Rmin / (0.163 nu + 0.8766) sqrt(density/G)
    assert critical == pytest.approx(math.pi * 5e-3 / (0.163 * 0.2 + 0.8766) * math.sqrt(2500 / (1e9 / 2.4)), rel=1e-12)
    assert sq.checkTimeStep(0.1 * critical) == 0.1 * critical
    with pytest.raises(ValueError, match=f'dt = {1.01 * critical!r}: above the critical'):
        sq.checkTimeStep(1.01 * critical)


def test_emptySceneHasNoCriticalTimeStep(material):
    with pytest.raises(ValueError, match='bodies'):
        sq.criticalTimeStep()


BAD_PARAMETERS = [
    ('shape', 'egg'), ('n1', 1.0), ('n2', 21), ('aspect', 2.0), ('radius', 0), ('radius', NAN), ('thickness', -0.01),
    ('thickness', 0.4), ('particles', 2.5), ('particles', 100000), ('solidFraction', 0.9), ('containerDiameter', 0.01),
    ('containerHeight', 0.005), ('density', 0), ('young', -1e9), ('poisson', 0.5), ('friction', -0.4),
    ('normalDamping', 1.0), ('tangentialDamping', -0.1), ('rollingFriction', -1), ('impactorDiameter', 0.2),
    ('impactorDensity', INF), ('speed', -5), ('dropHeight', -0.3), ('pouringSoftening', 0.5), ('timeStepFraction', 1.5),
    ('dt', 1e-4), ('seed', -1), ('seed', 'abc')]


@pytest.mark.parametrize('name, value', BAD_PARAMETERS)
def test_studyParameters(name, value, tmp_path):
    O.reset()
    output = str(tmp_path / 'out')
    expected = {('aspect', 2.0): 'aspect', ('containerDiameter', 0.01): 'container radius',
                ('containerHeight', 0.005): 'container height'}.get((name, value), f'{name} = {value!r}')
    with pytest.raises(ValueError, match=expected.replace('(', r'\(')):
        sq.ImpactRun.begin({name: value}, output)
    assert len(O.bodies) == 0 and not os.path.exists(output)


def test_dropThatEndsWithinTheParticles(material):
    """An impactor that has never been above them."""
    for speed, height in ((0.15, 0.0), (0.0, 0.02)):
        with pytest.raises(ValueError, match=f'dropHeight = {height}: too low; with speed = {speed} m/s'):
            ImpactParameters.checked({'speed': speed, 'dropHeight': height})
    ids = [O.bodies.append(sq.superquadric((0, 0, 0.1), (5e-3,) * 3, 2, 2, material))]
    before = len(O.materials)
    with pytest.raises(ValueError, match=r'dropHeight = 0.05: too low; with speed = 1.0 m/s .* 0.1055 m above'):
        sq.addImpactor(0.02, 3000, material, 1, 0.05, 0.0, ids)
    assert len(O.bodies) == 1 and len(O.materials) == before


@pytest.mark.parametrize('place', [5, (1,), (1, 2, 3), ('a', 'b'), (1j, 0), (float('nan'), 0), (10 ** 400, 0), {0: 1, 1: 2}])
def test_placeOfTheImpactor(material, place):
    """Also where no obstacle has to be looked for beneath it."""
    before = len(O.materials)
    with pytest.raises(ValueError, match='place'):
        sq.addImpactor(0.02, 3000, material, 1, 0.3, 0.0, (), place=place)
    assert len(O.bodies) == 0 and len(O.materials) == before


def test_bareImpactWithoutSpeed(material):
    with pytest.raises(ValueError, match='speed = 0.0: with dropHeight = 0.0'):
        sq.bareImpact(0.02, 3000, material, 0.0, 0.0)
    with pytest.raises(ValueError, match='dropHeight = 0.0: too low'):
        sq.bareImpact(0.02, 3000, material, 0.01, 0.0)
    assert len(O.materials) == 1


def test_timeStepAboveTheCriticalOneOfTheImpactor():
    """A small impactor of low density has a shorter critical step than the particles."""
    values = {'impactorDiameter': 2e-3, 'impactorDensity': 1000}
    critical = math.pi * 1e-3 / (0.163 * 0.2 + 0.8766) * math.sqrt(1000 / (1e9 / 2.4))
    assert ImpactParameters.checked(values).criticalImpactStep() == pytest.approx(critical, rel=1e-12)
    with pytest.raises(ValueError, match=r'dt = .*: above the critical'):
        ImpactParameters.checked({**values, 'dt': 1.01 * critical})
    assert ImpactParameters.checked({'dt': 1.01 * critical}).dt == 1.01 * critical


def test_bedWithoutParticlesAndVoxelsWithoutNumber(material):
    container = sq.cylinderContainer(0.05, 0.1, material)
    with pytest.raises(ValueError, match='no particles'):
        sq.measureBed(sq.Snapshot.ofBodies([]), container)
    body = O.bodies.append(sq.superquadric((0, 0, 5e-3), (5e-3,) * 3, 8, 8, material))
    with pytest.raises(ValueError, match='voxel = 1e-05: too small.* 1e[+]11 voxels'):
        sq.measureBed(sq.Snapshot.ofBodies([body]), container, voxel=1e-5)


def test_containerThatIsNotEmpty(material):
    container = sq.cylinderContainer(0.05, 0.1, material)
    O.bodies.append(sq.superquadric((0.2, 0, 0.01), (5e-3,) * 3, 8, 8, material))  # beside it
    _, container = sq.rainFilling([sq.particleShape('cube')] * 3, container, material, seed=1)
    with pytest.raises(ValueError, match='container: body 3 is in it already'):
        sq.rainFilling([sq.particleShape('cube')] * 3, container, material, seed=1)
    assert len(O.bodies) == 6


def test_unknownParameter():
    with pytest.raises(ValueError, match='thikness = 0.1'):
        ImpactParameters.checked({'thikness': 0.1})


def runScript(*arguments, script='impact.py'):
    command = [sys.executable, sys.yade_argv[0], '-n', '-x', PROJECT / 'scripts' / script, *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)


@pytest.mark.parametrize('arguments, message', [
    (['--normalDamping', '1'], 'normalDamping = \'1\''), (['--thickness', '0.4'], 'overfull'),
    (['--dt', '1e-4'], 'critical'), (['--resume'], 'no checkpoint')])
def test_scriptSaysItAndEndsWithCodeTwo(arguments, message, tmp_path):
    output = tmp_path / 'out'
    done = runScript('--output', str(output), *arguments)
    assert done.returncode == 2
    assert message in done.stderr and 'Traceback' not in done.stdout + done.stderr
    assert not output.exists()


@pytest.mark.parametrize('arguments, message', [
    (['--count', '0'], 'count = 0'), (['--steps', '5'], 'every = 10: must not be above steps = 5'),
    (['--bed', '/dev/null/bed.yade.gz'], '/dev/null')])
def test_parallelBedSaysItInOneLine(arguments, message, tmp_path):
    """Before it pours anything."""
    done = runScript('--bed', str(tmp_path / 'bed.yade.gz'), *arguments, script='parallel_bed.py')
    assert done.returncode == 2 and 'Traceback' not in done.stdout + done.stderr
    assert [line for line in done.stderr.splitlines() if line.startswith('parallel_bed.py: ') and message in line]
    assert os.listdir(tmp_path) == []
