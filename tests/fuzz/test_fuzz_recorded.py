"""The recorder for ParaView, recorded series and frames in files: any arguments, any damage; the same frames as from the whole files, or a ValueError
that names the file."""
import os
import shutil

import pytest
from damage import copyWith, damage
from fuzzing import anything, fuzz, refused
from hypothesis import strategies as st
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, PyRunner

import yade.superquadric as sq
from yade.superquadric.vtk import recorder as vtkrecorder
from yade.superquadric.vtk.series import Series

TABLES = 'particles', 'contacts', 'container'
GOOD = {'iterPeriod': 1, 'virtPeriod': None, 'realPeriod': None, 'surfaces': True, 'contacts': True, 'container': True,
        'detail': 0.1, 'normals': False, 'ids': None, 'initRun': True, 'label': ''}
WHOLE = {}  # folder of a series, its frames, and its files in it


def scene():
    """Three particles that touch, on a facet in a cylinder."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    O.materials.append(material)
    sq.cylinderContainer(0.02, 0.06, material)
    O.bodies.append(utils.facet([(-0.02, 0, 0.001), (0.02, 0, 0.001), (0, 0.02, 0.004)], material=material))
    for z in (4e-3, 11.9e-3):
        O.bodies.append(sq.superquadric((0, 0, z), (4e-3,) * 3, 8, 8, material))
    O.bodies.append(utils.sphere((0.01, 0, 4e-3), 4e-3, material=material))
    O.bodies[4].state.vel = Vector3(0, 0, -1)
    O.engines = sq.superquadricEngines()
    O.dt = 1e-7


@pytest.fixture(scope='module', autouse=True)
def series(tmp_path_factory):
    """A series of two moments."""
    folder = WHOLE['folder'] = str(tmp_path_factory.mktemp('whole'))
    scene()
    for _ in range(2):
        O.run(5, True)
        vtkrecorder.record(folder, detail=0.2)
    WHOLE['frame'] = str(tmp_path_factory.mktemp('frame'))
    for name in ('frame.npz', 'later.npz'):
        sq.SceneSnapshot.ofScene().save(os.path.join(WHOLE['frame'], name))
        O.step()
    WHOLE['frames'] = list(sq.RecordedSeries(folder))
    WHOLE['files'] = [os.path.relpath(os.path.join(here, name), folder)
                      for here, _, names in os.walk(folder) for name in names if 'surfaces' not in os.path.join(here, name)]


@pytest.fixture(scope='module')
def place(tmp_path_factory):
    return str(tmp_path_factory.mktemp('damaged') / 'copy')


def alike(one, other):
    return (one.step, one.time) == (other.step, other.time) and all(
        getattr(one, table).tobytes() == getattr(other, table).tobytes() for table in TABLES)


@fuzz(weight=6, data=st.data(), how=damage)
def test_damagedSeries(place, data, how):
    """What is left out of a whole series, or is another number in it, is noticed: in each frame, or when it is opened."""
    name = data.draw(st.sampled_from(sorted(WHOLE['files'])))
    isOther = copyWith(WHOLE['folder'], place, name, how)
    frames, no = refused(lambda: list(sq.RecordedSeries(place)), place)
    if no:
        assert isinstance(frames, ValueError) and isOther
        assert name in str(frames) or name.endswith('.pvd')
    else:
        assert len(frames) == 2 and all(map(alike, frames, WHOLE['frames']))


@fuzz(weight=3, name=st.sampled_from(('particles', 'container', 'surfaces')), how=damage)
def test_goingOnWithADamagedSeries(place, name, how):
    """A run that cannot read its list says so, and keeps the files; one that can has its moment behind the others."""
    copyWith(WHOLE['folder'], place, f'{name}.pvd', how)
    before = sorted(os.listdir(os.path.join(place, name)))
    answer, no = refused(lambda: Series(place, name).append(99, 1.0, lambda path: shutil.copy(os.path.join(place, 'particles.pvd'), path)), place)
    if no:
        assert isinstance(answer, ValueError) and sorted(os.listdir(os.path.join(place, name))) == before
    else:
        assert Series(place, name).entries()[-1] == (99, 1.0, f'{name}/{name}.0000000099.vtp')
        assert set(before) < set(os.listdir(os.path.join(place, name)))


@fuzz(weight=5, how=damage)
def test_damagedFrames(place, how):
    isOther = copyWith(WHOLE['frame'], place, 'frame.npz', how)
    path = os.path.join(place, 'frame.npz')
    wholes = [sq.SceneSnapshot.load(os.path.join(WHOLE['frame'], name)) for name in ('frame.npz', 'later.npz')]
    frame, no = refused(lambda: sq.SceneSnapshot.load(path), path)
    if no:
        assert isinstance(frame, ValueError) and isOther
    else:
        assert any(alike(frame, whole) for whole in wholes[:1 + (how[0] == 'other')])


@fuzz(weight=2, particles=anything, contacts=st.one_of(st.none(), anything), container=st.one_of(st.none(), anything), step=anything, time=anything,
      keep=st.booleans())
def test_framesOfAnything(particles, contacts, container, step, time, keep):
    given = WHOLE['frames'][0].particles if keep else particles
    frame, no = refused(lambda: sq.SceneSnapshot(given, contacts, container, step, time), *TABLES, 'step', 'time')
    if not no:
        assert frame.box().shape == (2, 3) and len(frame.speeds()) == len(frame.largestForces()) == len(frame.particles)


@fuzz(ids=st.one_of(st.none(), st.lists(st.integers(-2, 8), max_size=4), anything), erased=st.integers(0, 5))
def test_framesOfAnyBodies(ids, erased):
    scene()
    O.bodies.erase(erased)
    frame, no = refused(lambda: sq.SceneSnapshot.ofScene(ids), 'ids')
    if not no and ids is not None:
        assert set(frame.particles['id']) <= set(map(int, ids))


@fuzz(weight=5, change=st.dictionaries(st.sampled_from(tuple(GOOD)), anything, max_size=2), folder=st.one_of(st.none(), st.none(), anything))
def test_recorders(place, change, folder):
    """An accepted recorder is an engine that records; a refused one has made no folder and changed no scene."""
    shutil.rmtree(place, ignore_errors=True)
    scene()
    target, before = place if folder is None else folder, sorted(os.listdir(os.path.dirname(place)))
    if isinstance(folder, str):
        target = os.path.join(place, folder.lstrip('/').replace('..', ''))
    recorder, no = refused(lambda: sq.vtkRecorder(target, **{**GOOD, **change}), *GOOD, 'folder', also=OSError)
    if no:
        assert len(O.engines) == 4 and sorted(os.listdir(os.path.dirname(place))) == before or isinstance(recorder, OSError)
        return
    assert isinstance(recorder, PyRunner) and os.path.isdir(target)
    if isinstance(change.get('detail', 0.1), float) and 0.02 < change.get('detail', 0.1) and recorder.initRun:
        recorder.label = ''
        O.engines = [*O.engines, recorder]
        O.step()
        assert len(sq.RecordedSeries(target)) == 1


@fuzz(folder=anything)
def test_seriesOfAnything(folder):
    error, no = refused(lambda: sq.RecordedSeries(folder), 'folder')
    assert no
