"""Frames of a run on disk: taken at equal times, read when asked for, and those of a run that did not go on removed."""
import os

import pytest
from yade import O, utils
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.pictures.film import Film, removeFrames


@pytest.fixture
def scene():
    O.reset()
    O.bodies.append(utils.sphere((0, 0, 0), 5e-3, material=CurvatureMat(young=1e7, poisson=0.2, density=2500)))
    O.engines, O.dt = sq.superquadricEngines(gravity=(0, 0, 0)), 1e-4


def shoot(film, steps):
    for _ in range(steps):
        O.step()
        film.sample()


def test_framesAtEqualTimes(scene, tmp_path):
    film = Film(str(tmp_path / 'frames'), None, 0.0, 1e-3)
    shoot(film, 35)
    frames = film.frames()
    assert len(frames) == 4 and frames.times == pytest.approx([0, 1e-3, 2e-3, 3e-3])
    assert [frame.time for frame in frames] == pytest.approx([time + 1e-4 for time in frames.times]), 'at the end of the step'
    assert [frame.time for frame in frames[::3]] == [frames[0].time, frames[3].time] and frames[-1].step == 31
    assert sorted(os.listdir(tmp_path / 'frames')) == [f'00000{k}.npz' for k in range(4)], 'nothing half written'


def test_framesOfARunThatDidNotGoOnAreRemoved(scene, tmp_path):
    folder = tmp_path / 'frames'
    film = Film(str(folder), None, 0.0, 1e-3)
    shoot(film, 25)
    taken = (folder / '000002.npz').read_bytes()
    for name in ('000003.npz', '000099.npz', 'mine.npz'):
        (folder / name).write_text('old')
    assert len(Film(str(folder), None, 0.0, 1e-3).frames()) == 3
    assert sorted(os.listdir(folder)) == ['000000.npz', '000001.npz', '000002.npz', 'mine.npz']
    assert (folder / '000002.npz').read_bytes() == taken
    removeFrames(str(folder))
    assert os.listdir(folder) == ['mine.npz']


def test_withoutTheFirstFramesThereAreNone(scene, tmp_path):
    O.run(15, True)
    film = Film(str(tmp_path), None, 0.0, 1e-3)
    shoot(film, 20)
    assert os.listdir(tmp_path) and len(film.frames()) == 0
