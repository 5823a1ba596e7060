"""Files for ParaView: read back by VTK's own readers and held against the scene; series that go on; bad input."""
import os
import time

import numpy as np
import pytest
import pyvista
from yade import O, utils
from yade.minieigenHP import Matrix3, Vector3
from yade.wrapper import CurvatureMat, Facet, HollowCylinder, Sphere, Superquadric, Wall

import yade.superquadric as sq
from yade.superquadric import bodyarrays, vtkfiles, vtkrecorder
from yade.superquadric.frame import Frame
from yade.superquadric.vtkframes import RecordedSeries
from yade.superquadric.vtkseries import Series

SINGLE = 2e-7  # relative error of single precision, with room for one operation
R = 4e-3
SHAPES = [sq.particleShape('cube', R), sq.particleShape('ellipsoid', R, aspect=1.6), sq.particleShape('cylinder', R, aspect=1.5),
          sq.particleShape('sphere', R)]


def scene(steps=400, **recorder):
    """Particles of all kinds that fall onto each other in a cylinder, a facet among its walls."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4, normalDamping=0.1, tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(material)
    container = sq.cylinderContainer(0.02, 0.06, material)
    O.bodies.append(utils.facet([(-0.02, 0, 0.001), (0.02, 0, 0.001), (0, 0.02, 0.004)], material=material))
    sq.rainFilling(SHAPES * 5, container._replace(height=1.0), material, seed=2)
    for body in O.bodies:
        body.state.vel = Vector3(0, 0, -2) if not body.state.blockedDOFs else Vector3.Zero
    O.engines = sq.superquadricEngines()
    O.dt = 0.1 * sq.criticalTimeStep()
    if recorder:
        O.engines = O.engines + [sq.vtkRecorder(**recorder)]
    O.run(steps, True)


def particleBodies():
    return [body for body in O.bodies if isinstance(body.shape, (Sphere, Superquadric))]


def stressOf(body):
    """Mean stress [Pa] by its definition, from YADE's own lists."""
    total, shape = np.zeros((3, 3)), body.shape
    volume = 4 / 3 * np.pi * shape.radius ** 3 if isinstance(shape, Sphere) else shape.volume()
    for contact in body.intrs():
        if contact.isReal:
            sign = 1 if contact.id2 == body.id else -1
            total += sign * np.outer(contact.geom.contactPoint - body.state.pos, contact.phys.normalForce + contact.phys.shearForce)
    return total / volume


@pytest.fixture(scope='module')
def recorded(tmp_path_factory):
    """A folder with four moments, the last one the present scene."""
    folder = tmp_path_factory.mktemp('series')
    scene(15001, folder=str(folder), iterPeriod=5000, normals=True)
    vtkrecorder.record(str(folder), normals=True)
    return folder


def last(folder, name):
    """What VTK reads of the series' last moment."""
    return pyvista.read(str(folder / Series(str(folder), name).entries()[-1].file))


def test_particlesAreTheScene(recorded):
    data, bodies = last(recorded, 'particles'), particleBodies()
    assert list(data['id']) == [body.id for body in bodies] and data.n_points == 20
    assert np.unique(data['kind']).tolist() == [bodyarrays.SPHERE, bodyarrays.SUPERQUADRIC]
    touching = 0
    for k, body in enumerate(bodies):
        extents = (body.shape.radius,) * 3 if isinstance(body.shape, Sphere) else body.shape.extents
        x, y, z, w = (body.state.ori[i] for i in range(4))
        for name, expected in (('halfSizes', extents), ('orientation', (w, x, y, z)), ('velocity', body.state.vel), ('spin', body.state.angVel)):
            assert data[name][k] == pytest.approx(tuple(expected), rel=SINGLE, abs=1e-12)
        assert data.points[k] == pytest.approx(tuple(body.state.pos), rel=SINGLE, abs=1e-9)
        assert data['stress'][k] == pytest.approx(stressOf(body).ravel(), rel=1e-5, abs=1e-3)
        assert data['contacts'][k] == sum(i.isReal and i.phys.normalForce.norm() > 0 for i in body.intrs())
        touching += data['contacts'][k]
    assert touching > 20, 'the test must meet contacts'
    assert data['pressure'] == pytest.approx(-data['stress'][:, ::4].sum(axis=1) / 3, rel=1e-4, abs=1)
    assert data['material'].tolist() == [0] * 20


def test_octahedralStressIsThatOfBreakage(recorded):
    data = last(recorded, 'particles')
    for stress, value in zip(data['stress'].reshape(-1, 3, 3).astype(float), data['octahedralStress']):
        s1, s2, s3 = np.linalg.eigvalsh((stress + stress.T) / 2)
        assert value == pytest.approx(np.sqrt((s1 - s2) ** 2 + (s2 - s3) ** 2 + (s3 - s1) ** 2) / 3, rel=1e-4, abs=1e-2)


def test_surfacesAreThoseOfTheParticles(recorded):
    """Closed, of nearly the particle's volume, every point on it, normals outward and across."""
    data = last(recorded, 'surfaces')
    corners = data.faces.reshape(-1, 4)[:, 1:]
    for body in particleBodies():
        own = data['id'] == body.id
        local = np.array([tuple(body.state.ori.conjugate() * (Vector3(*map(float, point)) - body.state.pos)) for point in data.points[own]])
        shape = body.shape if isinstance(body.shape, Superquadric) else Superquadric(extents=(body.shape.radius,) * 3, n1=2, n2=2)
        assert np.array([shape.gauge(point) for point in local]) == pytest.approx(1, abs=1e-5)
        triangles = data.points[corners[own[corners[:, 0]]]].astype(float) - np.array(body.state.pos)
        volume = np.linalg.det(triangles).sum() / 6
        assert 0.95 < volume / shape.volume() < 1, 'inscribed'
        sides = np.concatenate([corners[own[corners[:, 0]]][:, [i, (i + 1) % 3]] for i in range(3)])
        assert len(np.unique(sides, axis=0)) == len(sides) == len(np.unique(np.sort(sides, axis=1), axis=0)) * 2
        outward = data.points[own] - np.array(body.state.pos)
        assert (np.einsum('ni,ni->n', data.point_data['normals'][own], outward) > 0).all()


def test_contactsAreTheScene(recorded):
    data = last(recorded, 'contacts')
    contacts = {(i.id1, i.id2): i for i in O.interactions if i.isReal}
    assert data.n_cells == len(contacts) > 15
    ends = data.points[data.lines.reshape(-1, 3)[:, 1:]]
    withContainer = 0
    for k, ids in enumerate(zip(data['id1'].tolist(), data['id2'].tolist())):
        contact = contacts[ids]
        assert data['normalForce'][k] == pytest.approx(tuple(contact.phys.normalForce), rel=SINGLE, abs=1e-9)
        assert data['shearForce'][k] == pytest.approx(tuple(contact.phys.shearForce), rel=SINGLE, abs=1e-9)
        assert data['overlap'][k] == pytest.approx(contact.geom.penetrationDepth, rel=SINGLE)
        assert data['force'][2 * k] == data['force'][2 * k + 1] == pytest.approx(contact.phys.normalForce.norm(), rel=SINGLE)
        for body, end in zip(ids, ends[k]):
            particle = isinstance(O.bodies[body].shape, (Sphere, Superquadric))
            withContainer += not particle
            assert end == pytest.approx(tuple(O.bodies[body].state.pos if particle else contact.geom.contactPoint), abs=1e-8)
    assert withContainer > 0


def test_containerIsTheScene(recorded):
    data = last(recorded, 'container')
    corners = data.points[data.faces.reshape(-1, 4)[:, 1:]]
    for body in O.bodies:
        mine = np.asarray(corners[data['id'] == body.id].reshape(-1, 3))
        if isinstance(body.shape, Wall):
            assert np.abs(mine[:, 2]).max() == 0 and np.hypot(*mine.T[:2]).max() == pytest.approx(0.02)
        elif isinstance(body.shape, HollowCylinder):
            assert np.hypot(*mine.T[:2]) == pytest.approx(0.02, abs=1e-8)
            assert np.unique(mine[:, 2]) == pytest.approx([0, body.shape.height], rel=SINGLE)
        elif isinstance(body.shape, Facet):
            assert mine == pytest.approx(np.array([tuple(body.state.pos + v) for v in body.shape.vertices]), abs=1e-9)


def test_seriesIsInTheOrderOfTime(recorded):
    """As another reader of .pvd sees it."""
    reader = pyvista.PVDReader(str(recorded / 'particles.pvd'))
    assert len(reader.time_values) == 5 and reader.time_values[-1] == O.time
    assert np.diff(reader.time_values)[:3] == pytest.approx(5000 * O.dt, rel=1e-6)
    assert pyvista.read(str(recorded / reader.datasets[2].path)).field_data['TimeValue'][0] == reader.time_values[2]


def test_recordedFramesAreTheScene(recorded):
    frames, now = RecordedSeries(str(recorded)), Frame.ofScene()
    read = frames[-1]
    assert (read.step, read.time) == (O.iter, O.time) and len(frames[1:3]) == 2
    for table in ('particles', 'contacts', 'container'):
        for column in getattr(now, table).dtype.names:
            old, new = getattr(now, table)[column], getattr(read, table)[column]
            vertices = table == 'container' and column in ('position', 'orientation')  # a facet has its vertices instead
            rows = now.container['kind'] != bodyarrays.FACET if vertices else slice(None)
            assert new[rows] == pytest.approx(old[rows], rel=1e-5, abs=1e-6), column


def test_loadedSceneGoesOnWithItsSeries(tmp_path):
    """What came after the saved moment is written again, all else stays; nothing is twice. One thread: the same bytes."""
    folder, saved = str(tmp_path / 'series'), str(tmp_path / 'scene.yade.gz')
    scene(1500, folder=folder, iterPeriod=500)
    O.save(saved)
    first = os.path.join(folder, Series(folder, 'surfaces').entries()[1].file)
    written = os.stat(first).st_mtime_ns
    O.run(2000, True)
    whole = {name: Series(folder, name).entries() for name in ('particles', 'surfaces', 'contacts', 'container')}
    contents = [open(os.path.join(folder, entry.file), 'rb').read() for entry in whole['particles']]
    O.load(saved)
    O.run(700, True)
    assert len(Series(folder, 'contacts').entries()) < len(whole['contacts'])
    assert len(os.listdir(os.path.join(folder, 'contacts'))) == len(Series(folder, 'contacts').entries())
    O.run(1300, True)
    assert {name: Series(folder, name).entries() for name in whole} == whole
    if O.numThreads == 1:
        assert [open(os.path.join(folder, entry.file), 'rb').read() for entry in whole['particles']] == contents
    assert os.stat(first).st_mtime_ns == written
    assert not [name for _, _, names in os.walk(folder) for name in names if name.endswith('.part')]


def test_newRunBeginsTheSeriesAnew(tmp_path):
    for _ in range(2):
        scene(1100, folder=str(tmp_path), iterPeriod=500)
        assert [entry.step for entry in Series(str(tmp_path), 'particles').entries()] == [0, 500, 1000]
    assert len(os.listdir(tmp_path / 'particles')) == 3


def test_pointsOnly(tmp_path):
    """A bed without surfaces takes a small part of the disk, and the surfaces can be had from it again."""
    scene(500, folder=str(tmp_path / 'points'), iterPeriod=400, surfaces=False, container=False)
    assert sorted(os.listdir(tmp_path / 'points')) == ['contacts', 'contacts.pvd', 'particles', 'particles.pvd']
    vtkrecorder.record(str(tmp_path / 'all'))
    frame = RecordedSeries(str(tmp_path / 'all'))[0]
    again, stored = vtkfiles.surfaceData(frame), last(tmp_path / 'all', 'surfaces')
    assert vtkfiles.points(again) == pytest.approx(stored.points, abs=1e-8)
    files = [os.path.getsize(tmp_path / 'all' / Series(str(tmp_path / 'all'), name).entries()[0].file) for name in ('particles', 'surfaces')]
    assert files[0] < 0.2 * files[1]


def test_chosenBodies(tmp_path):
    scene(300, folder=str(tmp_path), iterPeriod=200, ids=[5, 9, 3], surfaces=False)
    assert last(tmp_path, 'particles')['id'].tolist() == [5, 9, 3]


def test_contactsAcrossThePeriodicBorderAreShort(tmp_path):
    """The particle is put into the cell, its contact goes with it and ends at the image that touches."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    O.materials.append(material)
    O.periodic, O.cell.hSize = True, Matrix3(0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1)
    for x in (0.0039, 0.2 + 0.0961):
        O.bodies.append(utils.sphere((x, 0.05, 0.05), 0.004, material=material))
    O.engines, O.dt = sq.superquadricEngines(gravity=(0, 0, 0)), 1e-9
    O.run(2, True)
    vtkrecorder.record(str(tmp_path))
    points, line = last(tmp_path, 'particles').points, last(tmp_path, 'contacts')
    assert points[:, 0] == pytest.approx([0.0039, 0.0961], abs=1e-6)
    assert line.n_cells == 1 and np.linalg.norm(line.points[1] - line.points[0]) == pytest.approx(0.0078, abs=1e-6)
    middle = line.points.mean(axis=0)
    assert line['contactPoint'][0] == pytest.approx(middle, abs=1e-6)


def test_readersFindCompleteFilesOnly(tmp_path):
    """Whoever reads while a run goes on finds each file that the .pvd names."""
    scene(2, folder=str(tmp_path), iterPeriod=20)
    O.run(600)
    seen = 0
    while O.running:
        for entry in Series(str(tmp_path), 'surfaces').entries()[-2:]:
            assert pyvista.read(str(tmp_path / entry.file)).n_points > 0
            seen += 1
        time.sleep(0.01)
    assert seen > 5


@pytest.mark.parametrize('arguments, words', [
    (dict(), 'iterPeriod = None'), (dict(iterPeriod=0), 'iterPeriod = 0'), (dict(iterPeriod=2.5), 'iterPeriod = 2.5'),
    (dict(virtPeriod=-1), 'virtPeriod = -1'), (dict(virtPeriod='x'), "virtPeriod = 'x'"), (dict(realPeriod=float('nan')), 'realPeriod = nan'),
    (dict(iterPeriod=1, surfaces='yes'), "surfaces = 'yes'"), (dict(iterPeriod=1, detail=0), 'detail = 0'),
    (dict(iterPeriod=1, detail=1.5), 'detail = 1.5'), (dict(iterPeriod=1, ids=[0, 99]), 'got 99'), (dict(iterPeriod=1, ids=5), 'ids = 5'),
    (dict(iterPeriod=1, ids='0'), "ids = '0'"), (dict(iterPeriod=1, folder=''), "folder = ''"),
    (dict(iterPeriod=1, folder=7), 'folder = 7')])
def test_badInput(tmp_path, arguments, words):
    O.reset()
    target = tmp_path / 'series'
    O.bodies.append(utils.sphere((0, 0, 0), 1))
    with pytest.raises(ValueError, match=words.replace('(', r'\(')):
        sq.vtkRecorder(**{'folder': str(target), **arguments})
    assert not target.exists()


def test_chosenParticlesMayGo(tmp_path):
    """As when they break: the rest is recorded."""
    scene(1)
    chosen = [body.id for body in particleBodies()][:3]
    O.engines = O.engines + [sq.vtkRecorder(str(tmp_path), iterPeriod=1, ids=(i for i in chosen))]
    O.step()
    assert list(last(tmp_path, 'particles')['id']) == chosen
    O.bodies.erase(chosen[1])
    O.step()
    assert list(last(tmp_path, 'particles')['id']) == [chosen[0], chosen[2]]
    O.bodies.erase(chosen[0]), O.bodies.erase(chosen[2])
    O.step()
    assert last(tmp_path, 'particles').n_points == 0


def test_removingASeriesLeavesWhatIsNotIts(tmp_path):
    folder = tmp_path / 'vtk'
    scene(1, folder=str(folder), iterPeriod=1)
    for name in ('mine.txt', 'surfaces/surfaces.vtp'):
        (folder / name).write_text('mine')
    vtkrecorder.remove(str(folder))
    assert sorted(os.listdir(folder)) == ['mine.txt', 'surfaces'] and os.listdir(folder / 'surfaces') == ['surfaces.vtp']
    (folder / 'mine.txt').unlink(), (folder / 'surfaces' / 'surfaces.vtp').unlink()
    vtkrecorder.remove(str(folder))
    assert not folder.exists()
    vtkrecorder.remove(str(folder))


def test_seriesOfOtherProgramsAreRefused(tmp_path):
    scene(1, folder=str(tmp_path), iterPeriod=1)
    file = tmp_path / Series(str(tmp_path), 'particles').entries()[0].file
    pyvista.Sphere().save(str(file))
    with pytest.raises(ValueError, match="another program's"):
        RecordedSeries(str(tmp_path))[0]
    (tmp_path / 'particles.pvd').write_text('<VTKFile><Collection><DataSet timestep="0" file="moment"/></Collection></VTKFile>')
    with pytest.raises(ValueError, match="particles.pvd: is damaged, or another program's"):
        RecordedSeries(str(tmp_path))


def test_aSliceOfASeriesIsReadWhenItIsAskedFor(recorded):
    series = RecordedSeries(str(recorded))
    part = series[1::2]
    assert isinstance(part, RecordedSeries) and [frame.step for frame in part] == [series[1].step, series[3].step] and len(series) == 5


def test_damagedSeriesIsRefused(tmp_path):
    scene(1, folder=str(tmp_path), iterPeriod=1)
    file = tmp_path / Series(str(tmp_path), 'particles').entries()[0].file
    content = file.read_bytes()
    for share in (0.0, 0.1, 0.7, 0.99):
        file.write_bytes(content[:int(share * len(content))])
        with pytest.raises(ValueError, match='is damaged'):
            RecordedSeries(str(tmp_path))[0]
    (tmp_path / 'particles.pvd').write_text('<VTKFile')
    for attempt in (lambda: RecordedSeries(str(tmp_path)), lambda: vtkrecorder.record(str(tmp_path))):
        with pytest.raises(ValueError, match='particles.pvd: is damaged'):
            attempt()
    with pytest.raises(ValueError, match='no recorded series'):
        RecordedSeries(str(tmp_path / 'nowhere'))


def test_folderThatIsAFileIsRefused(tmp_path):
    (tmp_path / 'file').write_text('mine')
    O.reset()
    with pytest.raises(OSError):
        sq.vtkRecorder(str(tmp_path / 'file'), iterPeriod=1)
    assert (tmp_path / 'file').read_text() == 'mine'
