"""Snapshots of a run on disk: taken at equal times, read when asked for, and those of a run that did not go on removed."""
import os

import pytest
from yade import O, utils
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.pictures.snapshotrecorder import SnapshotRecorder, removeSnapshots


@pytest.fixture
def scene():
    O.reset()
    O.bodies.append(utils.sphere((0, 0, 0), 5e-3, material=CurvatureMat(young=1e7, poisson=0.2, density=2500)))
    O.engines, O.dt = sq.superquadricEngines(gravity=(0, 0, 0)), 1e-4


def sample(recorder, steps):
    for _ in range(steps):
        O.step()
        recorder.sample()


def test_snapshotsAtEqualTimes(scene, tmp_path):
    recorder = SnapshotRecorder(str(tmp_path / 'frames'), None, 0.0, 1e-3)
    sample(recorder, 35)
    snapshots = recorder.snapshots()
    assert len(snapshots) == 4 and snapshots.times == pytest.approx([0, 1e-3, 2e-3, 3e-3])
    assert [snapshot.time for snapshot in snapshots] == pytest.approx([time + 1e-4 for time in snapshots.times]), 'at the end of the step'
    assert [snapshot.time for snapshot in snapshots[::3]] == [snapshots[0].time, snapshots[3].time] and snapshots[-1].step == 31
    assert sorted(os.listdir(tmp_path / 'frames')) == [f'00000{k}.npz' for k in range(4)], 'nothing half written'


def test_snapshotsOfARunThatDidNotGoOnAreRemoved(scene, tmp_path):
    folder = tmp_path / 'frames'
    recorder = SnapshotRecorder(str(folder), None, 0.0, 1e-3)
    sample(recorder, 25)
    taken = (folder / '000002.npz').read_bytes()
    for name in ('000003.npz', '000099.npz', 'mine.npz'):
        (folder / name).write_text('old')
    assert len(SnapshotRecorder(str(folder), None, 0.0, 1e-3).snapshots()) == 3
    assert sorted(os.listdir(folder)) == ['000000.npz', '000001.npz', '000002.npz', 'mine.npz']
    assert (folder / '000002.npz').read_bytes() == taken
    removeSnapshots(str(folder))
    assert os.listdir(folder) == ['mine.npz']


def test_withoutTheFirstSnapshotsThereAreNone(scene, tmp_path):
    O.run(15, True)
    recorder = SnapshotRecorder(str(tmp_path), None, 0.0, 1e-3)
    sample(recorder, 20)
    assert os.listdir(tmp_path) and len(recorder.snapshots()) == 0
