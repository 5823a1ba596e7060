"""YADE's 3D view under an X server in memory: each body is drawn with its colour, size, shape and orientation, smooth and as wire, and the
container lets one see in. Skipped where there is no xvfb (`tools/env --with view`)."""
import shutil
import subprocess
from math import gamma
from pathlib import Path

import numpy
import pytest

COLOURS = {'red': (1, 0, 0), 'green': (0, 1, 0), 'blue': (0, 0, 1), 'yellow': (1, 1, 0), 'magenta': (1, 0, 1), 'cyan': (0, 1, 1)}
SATURATED = 40  # [of 255]; the difference between the channels of a coloured pixel, and none of a grey one

pytestmark = pytest.mark.skipif(not shutil.which('xvfb-run'), reason='no xvfb-run')


@pytest.fixture(scope='module')
def pictures(tmp_path_factory):
    path = tmp_path_factory.mktemp('view') / 'pictures.npz'
    command = ['xvfb-run', '-a', 'yade', '-x', str(Path(__file__).with_name('viewscene.py')), str(path)]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, text=True)
    assert run.returncode == 0 and path.exists(), run.stdout
    with numpy.load(path) as file:
        return dict(file)


def pixelsOf(picture, colour):
    """Where the picture shows a colour, however bright: (height, width) of bool."""
    channels = picture.astype(int)
    low, high = channels.min(axis=2), channels.max(axis=2)
    lit = channels > ((low + high) / 2)[:, :, None]
    return (high - low > SATURATED) & (lit == numpy.array(colour, bool)).all(axis=2)


def count(picture, name):
    return pixelsOf(picture, COLOURS[name]).sum()


def box(picture, name):
    """Width and height of what is shown in a colour, in pixels."""
    rows, columns = numpy.nonzero(pixelsOf(picture, COLOURS[name]))
    return columns.max() - columns.min() + 1, rows.max() - rows.min() + 1


def test_bodiesStandInTheirOrder(pictures):
    places = [numpy.nonzero(pixelsOf(pictures['smooth'], colour))[1].mean() for colour in COLOURS.values()]
    assert places == sorted(places)


@pytest.mark.parametrize('i, name', list(enumerate(COLOURS))[1:])
def test_sizeAndOrientation(pictures, i, name):
    diameter = box(pictures['smooth'], 'red')[0]
    assert diameter > 100
    assert box(pictures['smooth'], name) == pytest.approx(pictures['boxes'][i - 1] * diameter, abs=3)


@pytest.mark.parametrize('name, a, c, n', [('green', 1, 1, 8), ('blue', 0.6, 1.2, 20)])
def test_outline(pictures, name, a, c, n):
    # The area inside |x/a|^n + |z/c|^n = 1, against that of the circle.
    area = 4 * a * c * gamma(1 + 1 / n) ** 2 / gamma(1 + 2 / n) / numpy.pi
    assert count(pictures['smooth'], name) / count(pictures['smooth'], 'red') == pytest.approx(area, rel=0.02)


@pytest.mark.parametrize('name', list(COLOURS)[1:])
def test_wireIsSeenThrough(pictures, name):
    assert 0.02 < count(pictures['wire'], name) / count(pictures['smooth'], name) < 0.6
    assert box(pictures['wire'], name) == pytest.approx(box(pictures['smooth'], name), abs=4)


def test_lowQualityIsCoarser(pictures):
    assert count(pictures['coarse'], 'yellow') < 0.97 * count(pictures['smooth'], 'yellow')


def test_stripesAreOfTwoShades(pictures):
    shown = pixelsOf(pictures['smooth'], COLOURS['green'])
    change = pictures['stripes'].astype(int)[shown].sum(axis=1) - pictures['smooth'].astype(int)[shown].sum(axis=1)
    assert (change > 10).mean() > 0.2 and (change < -5).mean() > 0.2


@pytest.mark.parametrize('kind', ['container', 'endless'])
def test_theContainerStandsBehindTheBodies(pictures, kind):
    for name in COLOURS:
        assert count(pictures[kind], name) == count(pictures['smooth'], name)
    others = ~numpy.any([pixelsOf(pictures['smooth'], colour) for colour in COLOURS.values()], axis=0)
    assert (pictures[kind][others].astype(int).sum(axis=1) > pictures['smooth'][others].astype(int).sum(axis=1)).mean() > 0.5


def test_theContainerAsWireHidesLittle(pictures):
    for name in COLOURS:
        assert 0.7 < count(pictures['wireContainer'], name) / count(pictures['smooth'], name) < 1
