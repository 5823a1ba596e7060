"""Pictures: what is on them, where and in which colour; animations; bad input. Colours are told apart, not measured: the light is on them."""
import os
import weakref
from collections.abc import Sequence

import numpy as np
import pytest
from PIL import Image
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.pictures import render, renderer, renderpieces
from yade.superquadric.vtk import recorder

R = 5e-3
VIRIDIS_ENDS = (68, 1, 84), (253, 231, 37)  # matplotlib's colours of the smallest and the largest value


@pytest.fixture(scope='module')
def drawing():
    """One drawing process for many pictures: it takes two seconds to start."""
    with renderer.Renderer() as process:
        yield process


@pytest.fixture(autouse=True)
def empty():
    O.reset()


def ball(x, y=0.0, z=R, radius=R, speed=0.0):
    body = O.bodies.append(utils.sphere((x, y, z), radius, material=CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)))
    O.bodies[body].state.vel = Vector3(0, 0, speed)
    return body


def cube(x, y=0.0, z=R, half=R):
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    return O.bodies.append(sq.superquadric((x, y, z), (half,) * 3, 8, 8, material=material, orientation=Quaternion((0, 0, 1), 0.3)))


@pytest.fixture
def seen(drawing, tmp_path, monkeypatch):
    """Function that draws with `sq.picture` and gives the picture (height, width, 3) without frame and bars, and a function from a point [m] to
    its pixel.
    """
    class Watched:
        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def draw(self, *job):
            self.job, self.image = job, drawing.draw(*job)
            return self.image

    def draw(frame=None, **options):
        watched = Watched()
        monkeypatch.setattr(render, 'Renderer', lambda: watched)
        sq.picture(str(tmp_path / 'picture.png'), frame or sq.SceneSnapshot.ofScene(), width=300, **options)
        _, camera, (width, height) = watched.job
        right = np.cross(camera['direction'], camera['up'])

        def pixel(*point):
            away, scale = np.array(point) - camera['centre'], camera['height'] / height
            return watched.image[round(height / 2 - away @ camera['up'] / scale), round(width / 2 + away @ right / scale)].astype(float)
        return watched.image, pixel
    return draw


def hue(colour):
    """A colour without its brightness, a unit vector."""
    return np.asarray(colour, dtype=float) / np.linalg.norm(colour)


def nearest(colour, *candidates):
    """Which of the candidates has the hue of the colour."""
    return int(np.argmax([hue(colour) @ hue(candidate) for candidate in candidates]))


def test_particlesAreWhereTheyAre(seen):
    ball(-0.02), cube(0.02)
    image, pixel = seen()
    for x in (-0.02, 0.02):
        assert nearest(pixel(x, 0, R), renderpieces.SAND, (1, 1, 1)) == 0
    for x in (-0.02 - 1.15 * R, 0.0, 0.02 + 1.4 * R):
        assert pixel(x, 0, R) == pytest.approx(255)
    assert len(np.unique(image.reshape(-1, 3), axis=0)) > 200, 'smooth shading has many tones'


def test_theHalfTowardsTheViewerIsTakenAway(seen):
    ball(0, y=0.03), ball(0.02, y=-0.03)
    _, pixel = seen(cut=True, elevation=0)
    assert pixel(0.02, -0.03, R) == pytest.approx(255) and pixel(0, 0.03, R).min() < 250


def test_coloursOfSpeed(seen, tmp_path):
    ball(-0.02), ball(0, speed=1.0), ball(0.02, speed=-2.0)
    image, pixel = seen(colour='speed', limits=(0, 2))
    assert nearest(pixel(-0.02, 0, R), *VIRIDIS_ENDS) == 0 and nearest(pixel(0.02, 0, R), *VIRIDIS_ENDS) == 1
    whole = np.asarray(Image.open(tmp_path / 'picture.png'))
    assert whole.shape[1] > image.shape[1] + 80, 'room for the bar of colours'


def test_coloursOfKinds(seen):
    ball(-0.02), cube(0.0), ball(0.02, radius=0.7 * R)
    _, pixel = seen(colour='kind')
    left, middle, right = (nearest(pixel(x, 0, R), *renderpieces.KINDS[:2]) for x in (-0.02, 0, 0.02))
    assert left == right != middle, 'spheres of all sizes are one kind'


def squeezed():
    """Two balls pressed together hard, two lightly."""
    ball(-0.02), ball(-0.02 + 1.98 * R), ball(0.012), ball(0.012 + 1.9998 * R)
    O.engines, O.dt = sq.superquadricEngines(gravity=(0, 0, 0)), 1e-9
    O.run(2, True)


def test_forceChainsJoinTheCentres(seen):
    squeezed()
    _, pixel = seen(colour=None, chains=True)
    assert pixel(-0.02 + 0.99 * R, 0, R).max() < 120, 'the strongest force is dark'
    assert pixel(0.004, 0, R) == pytest.approx(255)
    forces = sq.SceneSnapshot.ofScene().normalForces()
    assert forces.max() > 500 * forces.min() and pixel(0.012 + R, 0, R) == pytest.approx(255), 'the weak one is left out'


def test_coloursOfForces(seen):
    squeezed()
    _, pixel = seen(colour='force')
    assert nearest(pixel(-0.02, 0, R), *VIRIDIS_ENDS) == 1 and nearest(pixel(0.012, 0, R), *VIRIDIS_ENDS) == 0


def test_containerIsSeenThrough(seen):
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    sq.cylinderContainer(0.03, 0.2, material)
    ball(0)
    image, pixel = seen()
    assert nearest(pixel(0, 0, R), renderpieces.SAND, renderpieces.CONTAINER) == 0
    assert 100 < pixel(0.025, 0, R).min() < 250
    assert image.shape[0] < image.shape[1], 'what is empty of the container is left out'


def test_snapshotLooksLikeTheScene(seen, tmp_path):
    cube(-0.02), cube(0.02, half=0.6 * R)
    scene, _ = seen()
    snapshot, _ = seen(sq.SceneSnapshot.ofSnapshot(sq.Snapshot.ofBodies([0, 1])))
    assert np.abs(scene.astype(int) - snapshot).mean() < 1
    sq.picture(str(tmp_path / 'two.png'), [('one', sq.Snapshot.ofBodies([0, 1])), ('two', sq.SceneSnapshot.ofScene())], title='twice', width=200)
    assert Image.open(tmp_path / 'two.png').width > 390


def test_animationOfARecordedSeries(tmp_path):
    ball(0, z=0.01, speed=1.0), ball(0.02)
    O.engines, O.dt = sq.superquadricEngines(gravity=(0, 0, 0)), 1e-4
    for _ in range(4):
        recorder.record(str(tmp_path / 'vtk'))
        O.run(50, True)
    path = tmp_path / 'film.gif'
    sq.animation(str(path), sq.RecordedSeries(str(tmp_path / 'vtk')), width=160, rate=5)
    with Image.open(path) as film:
        assert (film.n_frames, film.info['duration']) == (4, 200)
        frames = []
        for k in range(4):
            film.seek(k)
            frames.append(np.asarray(film.convert('RGB')).astype(int))
    assert all(np.abs(later - earlier).max() > 100 for earlier, later in zip(frames, frames[1:])), 'it moves'
    assert os.path.getsize(path) < 100000


@pytest.mark.parametrize('arguments, words', [
    (dict(colour='mood'), "colour = 'mood'"), (dict(colour='speed', limits=(2, 1)), r'limits = \(2, 1\)'), (dict(chains='yes'), "chains = 'yes'"),
    (dict(colour='speed', limits=5), 'limits = 5: must be two'), (dict(limits=(0, 1)), "limits = .*: colour = 'plain' stands for no"),
    (dict(colour=None, limits=(0, 1)), 'colour = None stands for no'), (dict(views=[7]), 'views: must be'),
    (dict(views=[('a', 7)]), '7: is no SceneSnapshot'),
    (dict(views=7), 'views: must be'), (dict(path='nowhere/bed.png'), 'there is no folder .*nowhere'),
    (dict(width=3), 'width = 3'), (dict(elevation=100), 'elevation = 100'), (dict(chainLimit=-1), 'chainLimit = -1'),
    (dict(path='bed.jpg'), 'bed.jpg')])
def test_badInput(tmp_path, arguments, words):
    ball(0)
    with pytest.raises(ValueError, match=words):
        sq.picture(**{'path': str(tmp_path / 'bed.png'), 'views': sq.SceneSnapshot.ofScene(), **arguments})
    assert not os.listdir(tmp_path)


def test_nothingToShow(tmp_path):
    for draw in (lambda: sq.picture(str(tmp_path / 'bed.png'), []), lambda: sq.animation(str(tmp_path / 'bed.gif'), [])):
        with pytest.raises(ValueError, match='nothing to show'):
            draw()


def test_animationsOfOtherThingsThanSnapshots(tmp_path):
    ball(0)
    path = str(tmp_path / 'bed.gif')
    for frames in (sq.SceneSnapshot.ofScene(), 5, [5]):
        with pytest.raises(ValueError, match='SceneSnapshot'):
            sq.animation(path, frames)
    for rate in (0, 51, float('nan')):
        with pytest.raises(ValueError, match='rate = '):
            sq.animation(path, [sq.SceneSnapshot.ofScene()], rate=rate)
    assert not os.listdir(tmp_path)


def test_listsOfSnapshots(tmp_path, drawing, monkeypatch):
    ball(0)
    frame, snapshot = sq.SceneSnapshot.ofScene(), sq.Snapshot.ofBodies([0])
    sq.picture(str(tmp_path / 'bed.png'), [frame, snapshot], width=100)
    sq.animation(str(tmp_path / 'bed.gif'), (view for view in (frame, snapshot)), width=100)
    assert sorted(os.listdir(tmp_path)) == ['bed.gif', 'bed.png'], 'and nothing half written'


class Watched(Sequence):
    """A sequence that counts how many of its frames are in memory at once."""

    def __init__(self, number):
        self.number, self.alive, self.most = number, weakref.WeakSet(), 0

    def __len__(self):
        return self.number

    def __getitem__(self, place):
        if not -self.number <= place < self.number:
            raise IndexError(place)
        frame = sq.SceneSnapshot.ofScene()
        self.alive.add(frame)
        self.most = max(self.most, len(self.alive))
        return frame


def test_anAnimationHoldsFewFrames(tmp_path):
    ball(0)
    frames = Watched(12)
    sq.animation(str(tmp_path / 'bed.gif'), frames, width=60)
    assert frames.most <= 4, 'the first, the last, the one that is drawn and the next'


def test_aFlatSceneKeepsItsSides(seen):
    """Its height is raised to the least number of pixels; what is at its ends is still in the picture."""
    for k in range(41):
        ball(0.1 * (k - 20) * 0.5)
    image, pixel = seen(elevation=0)
    assert image.shape[:2] == (50, 300)
    columns = np.flatnonzero(image.min(axis=(0, 2)) < 250)
    assert columns[0] < 10 and columns[-1] > 289, 'all of its width is shown'
    assert image.shape[1] - 1 - columns[-1] > 0 and columns[0] > 0, 'nothing is cut off'


def test_azimuthCountsFromXCounterclockwise(seen):
    """Seen from +x (0 degrees) what is at +y is on the right; from -y (-90), what is at +x is."""
    for azimuth, place in ((0, (0, 0.02)), (-90, (0.02, 0)), (90, (-0.02, 0))):
        O.reset()
        ball(*place), cube(-place[0], -place[1])
        image, _ = seen(colour='kind', azimuth=azimuth, elevation=10)
        half = image.shape[1] // 2
        sides = [part[(part.min(axis=2) < 200)].mean(axis=0) for part in (image[:, :half], image[:, half:])]
        kinds = [nearest(side, *renderpieces.KINDS[:2]) for side in sides]
        assert kinds == [1, 0], f'the sphere, the first kind, is on the right from {azimuth}'


def test_anEmptySceneIsWhite(seen):
    assert seen()[0].min() == 255


def test_missingPackagesAreNamed(tmp_path, monkeypatch):
    ball(0)
    monkeypatch.setattr(renderer.shutil, 'which', lambda name: None)
    assert 'Xvfb' in renderer.missing()
    with pytest.raises(ImportError, match='need Xvfb, setpriv: install'):
        sq.picture(str(tmp_path / 'bed.png'), sq.SceneSnapshot.ofScene())


def test_aFailedStartLeavesNothingBehind(monkeypatch):
    monkeypatch.setattr(renderer.sys, 'executable', '/nowhere/python')
    process = renderer.Renderer()
    with pytest.raises(OSError):
        process.__enter__()
    assert process._screen.returncode is not None and process._errors.closed


def test_aCrashedDrawingProcessIsAnError(tmp_path, monkeypatch):
    """Not the end of the computation."""
    (tmp_path / 'crash.py').write_text('import os, sys\nsys.stderr.write("no such driver")\nsys.stderr.flush()\nos.abort()\n')
    monkeypatch.setattr(renderer, 'PROGRAM', str(tmp_path / 'crash.py'))
    ball(0)
    with pytest.raises(RuntimeError, match='(?s)status -6.*no such driver'):
        sq.picture(str(tmp_path / 'bed.png'), sq.SceneSnapshot.ofScene())
    assert not (tmp_path / 'bed.png').exists()
