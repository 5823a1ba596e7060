"""Pictures, animations and cameras of any arguments: drawn, or refused by name before anything is drawn or written.

What draws is replaced by a white sheet here, since each real picture takes seconds; test_render.py looks at real ones.
"""
import math
import os

import numpy
import pytest
from fuzzing import INF, NAN, anything, fuzz, number, refused, vector
from hypothesis import strategies as st
from PIL import Image
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.pictures import render, view
from yade.superquadric.pictures.renderpieces import COLOURS

LOOKS = {'colour': 'plain', 'chains': False, 'cut': False, 'limits': None, 'chainLimit': None,
         'elevation': 14.0, 'azimuth': -90.0, 'title': '', 'width': 60}
look = st.sampled_from(tuple(LOOKS)).flatmap(lambda name: st.tuples(st.just(name), st.one_of(WELL[name], WELL[name], anything)))
WELL = {'colour': st.sampled_from((*COLOURS, None)), 'chains': st.booleans(), 'cut': st.booleans(), 'limits': st.tuples(number, number),
        'chainLimit': st.floats(1e-30, 1e30), 'elevation': st.floats(-90, 90), 'azimuth': number, 'width': st.integers(50, 200),
        'title': st.one_of(st.text(max_size=9), st.text('$x^_{}\\', max_size=9))}
drawn = []  # sizes of what was asked for


class Sheet:
    """What draws, without drawing: it looks through what it is given."""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def draw(self, pieces, camera, size):
        assert all(math.isfinite(x) for x in (*camera['centre'], *camera['direction'], *camera['up'], camera['height'])) and camera['height'] > 0
        for piece in pieces:
            assert numpy.isfinite(piece['points']).all() and piece.get('triangles', piece.get('lines')).max() < len(piece['points'])
        assert max(size) <= render.HIGHEST
        drawn.append(size)
        return numpy.full((size[1], size[0], 3), 255, 'u1')


@pytest.fixture(scope='module', autouse=True)
def sheet():
    before, render.Renderer = render.Renderer, Sheet
    yield
    render.Renderer = before


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    return str(tmp_path_factory.mktemp('pictures'))


def frame(places=((0, 0, 5e-3), (0, 0, 14.9e-3)), speed=(0, 0, 1)):
    """Of two cubes, one of them pressed onto the other, in a cylinder."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    O.materials.append(material)
    sq.cylinderContainer(0.02, 0.06, material)
    for place in places:
        O.bodies.append(sq.superquadric((0, 0, 0), (5e-3,) * 3, 8, 8, material))
        O.bodies[-1].state.pos = Vector3(*place)
    O.bodies.append(utils.sphere((0.01, 0, 5e-3), 4e-3, material=material))
    O.engines, O.dt = sq.superquadricEngines(), 1e-9
    O.step()
    O.bodies[3].state.vel = Vector3(*speed)
    return sq.SceneSnapshot.ofScene()


def settings(changes, limits):
    """The looks, some of them changed; a good scale of colours where there is one."""
    given = {**LOOKS, **dict(changes)}
    return {**given, 'limits': limits} if 'limits' not in dict(changes) and given['colour'] in ('speed', 'force', 'contacts') else given


def show(folder, name, draw, *names, also=()):
    """Draw into the file; whether it is refused, and then nothing is drawn or written."""
    path = os.path.join(folder, name)
    drawn.clear()
    error, no = refused(lambda: draw(path), *names, also=also)
    if no:
        assert not drawn and not os.listdir(folder), 'before anything is drawn'
        return True
    with Image.open(path) as image:
        assert min(image.size) > 0
    os.remove(path)
    return False


@fuzz(weight=3, changes=st.lists(look, max_size=2), limits=st.sampled_from((None, (0, 1))))
def test_looksOfPictures(folder, changes, limits):
    here = frame()
    show(folder, 'a.png', lambda path: sq.picture(path, here, **settings(changes, limits)), *LOOKS)


@fuzz(weight=0.5, changes=st.lists(look, max_size=1), rate=st.one_of(st.just(12), anything), start=st.one_of(st.none(), anything))
def test_looksOfAnimations(folder, changes, rate, start):
    frames = [frame(), frame()]
    show(folder, 'a.gif', lambda path: sq.animation(path, frames, rate=rate, start=start, **settings(changes, None)), *LOOKS, 'rate', 'start')


text = st.one_of(st.text(max_size=5), st.text('$x^_{}\\', max_size=9))
part = st.sampled_from(('frame', 'snapshot', 'empty', 'nothing'))


@fuzz(weight=2, views=st.one_of(part, st.lists(part, max_size=3), st.lists(st.tuples(text, part), max_size=3),
                                st.lists(st.one_of(part, st.tuples(text, part), anything), max_size=3), anything), gif=st.booleans())
def test_viewsOfAnything(folder, views, gif):
    here = frame()
    known = {'frame': here, 'snapshot': sq.Snapshot.ofBodies([2, 3]), 'empty': sq.SceneSnapshot(here.particles[:0]),
             'nothing': sq.Snapshot.ofBodies([])}

    def made(value):
        if isinstance(value, (list, tuple)):
            return type(value)(map(made, value))
        return known.get(value, value) if isinstance(value, str) else value
    draw = sq.animation if gif else sq.picture
    show(folder, 'a.gif' if gif else 'a.png', lambda path: draw(path, made(views), width=50), 'views', 'frames')


NEAR = st.one_of(st.floats(-0.1, 0.1), st.sampled_from((1e-300, 1e3, -1e9, 1e15)))
PLACES = st.one_of(NEAR, st.sampled_from((NAN, INF, -INF, 1e300, 1e160, -1e30, 1e16)))


@fuzz(weight=2, places=st.lists(st.one_of(st.tuples(NEAR, NEAR, NEAR), st.tuples(PLACES, PLACES, PLACES)), max_size=3),
      speed=st.tuples(PLACES, PLACES, PLACES), changes=st.lists(look, max_size=1))
def test_scenesThatFlewApart(folder, places, speed, changes):
    """Bodies at no place, or beyond all measure: YADE keeps them. They are drawn as far as can be, or refused."""
    here = frame()
    rows = here.particles.copy()
    for row, place in zip(rows, places):
        row['position'] = place
    rows['velocity'] = speed
    apart = sq.SceneSnapshot(rows, here.contacts, here.container)
    show(folder, 'a.png', lambda path: sq.picture(path, apart, **{**settings(changes, None), 'width': 60}), *LOOKS, 'views')


@fuzz(path=anything)
def test_pathsOfAnything(folder, path):
    here = frame()
    before = sorted(os.listdir())
    for draw in (sq.picture, sq.animation):
        assert refused(lambda: draw(path, here), 'path', 'frames')[1]
    assert refused(lambda: sq.picture(os.path.join(folder, 'nul\0l.png'), here, width=50), 'path')[1]
    assert sorted(os.listdir()) == before and not os.listdir(folder)


class Camera:
    """A 3D view without a display: it remembers what is asked of it."""

    def __setattr__(self, name, value):
        self.__dict__.setdefault('asked', []).append(name)
        self.__dict__[name] = value

    def fitSphere(self, *sphere):
        self.sphere = sphere


@fuzz(weight=3, center=vector, radius=anything, azimuth=st.one_of(st.just(-60), anything),
      elevation=st.one_of(st.just(25), st.floats(-90, 90), anything), orthographic=st.one_of(st.booleans(), anything))
def test_aims(center, radius, azimuth, elevation, orthographic):
    camera = Camera()
    _, no = refused(lambda: view.aim(camera, center, radius, azimuth, elevation, orthographic),
                    'center', 'radius', 'azimuth', 'elevation', 'orthographic')
    if no:
        assert not vars(camera), 'nothing has changed'
        return
    along, up = (Vector3(*getattr(camera, name)) for name in ('viewDir', 'upVector'))
    assert abs(along.norm() - 1) < 1e-12 and abs(up.norm() - 1) < 1e-12 and abs(along.dot(up)) < 1e-12
    assert type(camera.ortho) is bool and camera.sphere == (tuple(map(float, center)), float(radius))


@fuzz(size=anything, camera=anything)
def test_viewsWithoutADisplay(size, camera):
    """Refused before a window is asked for, which there is none for here."""
    if 'DISPLAY' not in os.environ:
        error, no = refused(lambda: view.openView(size), 'size', also=ImportError)
        assert no and (not isinstance(error, ImportError) or all(number >= 1 for number in size))
    assert refused(lambda: view.aim(camera, (0, 0, 0), 1), 'view')[1]
