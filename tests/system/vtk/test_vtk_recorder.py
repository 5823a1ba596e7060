"""Files for ParaView: read back by VTK's own readers and held against the scene; bad input."""
import os

import numpy as np
import pytest
import pyvista
from vtkscene import last, particleBodies, scene
from yade import O, utils
from yade.minieigenHP import Matrix3, Vector3
from yade.wrapper import CurvatureMat, Facet, HollowCylinder, Sphere, Superquadric, Wall

import yade.superquadric as sq
from yade.superquadric.measure import bodyarrays
from yade.superquadric.measure.scenesnapshot import SceneSnapshot
from yade.superquadric.vtk import polydata, recorder
from yade.superquadric.vtk.recorded import RecordedSeries
from yade.superquadric.vtk.series import Series

SINGLE = 2e-7  # relative error of single precision, with room for one operation


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
    recorder.record(str(folder), normals=True)
    return folder


def test_particlesAreTheScene(recorded):
    data, bodies = last(recorded, 'particles'), particleBodies()
    assert list(data['id']) == [body.id for body in bodies] and data.n_points == 20
    assert np.unique(data['kind']).tolist() == [bodyarrays.SPHERE, bodyarrays.SUPERQUADRIC]
    touching = 0
    for k, body in enumerate(bodies):
        extents = (body.shape.radius,) * 3 if isinstance(body.shape, Sphere) else body.shape.extents
        x, y, z, w = (body.state.ori[i] for i in range(4))
        for name, expected in (('halfSizes', extents), ('orientation', (w, x, y, z)), ('velocity', body.state.vel), ('angVel', body.state.angVel)):
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
    frames, now = RecordedSeries(str(recorded)), SceneSnapshot.ofScene()
    read = frames[-1]
    assert (read.step, read.time) == (O.iter, O.time) and len(frames[1:3]) == 2
    for table in ('particles', 'contacts', 'container'):
        for column in getattr(now, table).dtype.names:
            old, new = getattr(now, table)[column], getattr(read, table)[column]
            vertices = table == 'container' and column in ('position', 'orientation')  # a facet has its vertices instead
            rows = now.container['kind'] != bodyarrays.FACET if vertices else slice(None)
            assert new[rows] == pytest.approx(old[rows], rel=1e-5, abs=1e-6), column


def test_pointsOnly(tmp_path):
    """A bed without surfaces takes a small part of the disk, and the surfaces can be had from it again."""
    scene(500, folder=str(tmp_path / 'points'), iterPeriod=400, surfaces=False, container=False)
    assert sorted(os.listdir(tmp_path / 'points')) == ['contacts', 'contacts.pvd', 'particles', 'particles.pvd']
    recorder.record(str(tmp_path / 'all'))
    frame = RecordedSeries(str(tmp_path / 'all'))[0]
    again, stored = polydata.surfaceData(frame), last(tmp_path / 'all', 'surfaces')
    assert polydata.points(again) == pytest.approx(stored.points, abs=1e-8)
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
    recorder.record(str(tmp_path))
    points, line = last(tmp_path, 'particles').points, last(tmp_path, 'contacts')
    assert points[:, 0] == pytest.approx([0.0039, 0.0961], abs=1e-6)
    assert line.n_cells == 1 and np.linalg.norm(line.points[1] - line.points[0]) == pytest.approx(0.0078, abs=1e-6)
    middle = line.points.mean(axis=0)
    assert line['contactPoint'][0] == pytest.approx(middle, abs=1e-6)


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


def test_aSliceOfASeriesIsReadWhenItIsAskedFor(recorded):
    series = RecordedSeries(str(recorded))
    part = series[1::2]
    assert isinstance(part, RecordedSeries) and [frame.step for frame in part] == [series[1].step, series[3].step] and len(series) == 5
