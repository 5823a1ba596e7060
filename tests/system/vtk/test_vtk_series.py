"""Series of files for ParaView over time: runs that stop, go on and begin anew, bodies that go, damaged and foreign files."""
import os
import time

import pytest
import pyvista
from vtkscene import last, particleBodies, scene
from yade import O

import yade.superquadric as sq
from yade.superquadric.vtk import recorder
from yade.superquadric.vtk.recorded import RecordedSeries
from yade.superquadric.vtk.series import Series


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
    recorder.remove(str(folder))
    assert sorted(os.listdir(folder)) == ['mine.txt', 'surfaces'] and os.listdir(folder / 'surfaces') == ['surfaces.vtp']
    (folder / 'mine.txt').unlink(), (folder / 'surfaces' / 'surfaces.vtp').unlink()
    recorder.remove(str(folder))
    assert not folder.exists()
    recorder.remove(str(folder))


def test_seriesOfOtherProgramsAreRefused(tmp_path):
    scene(1, folder=str(tmp_path), iterPeriod=1)
    file = tmp_path / Series(str(tmp_path), 'particles').entries()[0].file
    pyvista.Sphere().save(str(file))
    with pytest.raises(ValueError, match="another program's"):
        RecordedSeries(str(tmp_path))[0]
    (tmp_path / 'particles.pvd').write_text('<VTKFile><Collection><DataSet timestep="0" file="moment"/></Collection></VTKFile>')
    with pytest.raises(ValueError, match="particles.pvd: is damaged, or another program's"):
        RecordedSeries(str(tmp_path))


def test_damagedSeriesIsRefused(tmp_path):
    scene(1, folder=str(tmp_path), iterPeriod=1)
    file = tmp_path / Series(str(tmp_path), 'particles').entries()[0].file
    content = file.read_bytes()
    for share in (0.0, 0.1, 0.7, 0.99):
        file.write_bytes(content[:int(share * len(content))])
        with pytest.raises(ValueError, match='is damaged'):
            RecordedSeries(str(tmp_path))[0]
    (tmp_path / 'particles.pvd').write_text('<VTKFile')
    for attempt in (lambda: RecordedSeries(str(tmp_path)), lambda: recorder.record(str(tmp_path))):
        with pytest.raises(ValueError, match='particles.pvd: is damaged'):
            attempt()
    with pytest.raises(ValueError, match='no recorded series'):
        RecordedSeries(str(tmp_path / 'nowhere'))


def test_seriesThatCannotBeGoneOnWithIsRefusedFirst(tmp_path):
    """When the recorder is made; and when it was damaged later, before any other series has changed."""
    scene(1, folder=str(tmp_path), iterPeriod=1)
    (tmp_path / 'surfaces.pvd').write_text('<VTKFile')
    before = Series(str(tmp_path), 'particles').entries()
    for attempt in (lambda: sq.vtkRecorder(str(tmp_path), iterPeriod=1), lambda: recorder.record(str(tmp_path))):
        with pytest.raises(ValueError, match='surfaces.pvd: is damaged'):
            attempt()
    assert Series(str(tmp_path), 'particles').entries() == before and (tmp_path / before[0].file).exists()
    sq.vtkRecorder(str(tmp_path), iterPeriod=1, surfaces=False)


def test_folderThatIsAFileIsRefused(tmp_path):
    (tmp_path / 'file').write_text('mine')
    O.reset()
    with pytest.raises(OSError):
        sq.vtkRecorder(str(tmp_path / 'file'), iterPeriod=1)
    assert (tmp_path / 'file').read_text() == 'mine'
