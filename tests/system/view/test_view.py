"""YADE's 3D view under an X server in memory: each body is drawn with its colour, size, shape and orientation, smooth and as wire, and the
container lets one see in. Skipped where there is no xvfb (`tools/env --with view`)."""
import os
import shutil
import signal
import subprocess
from math import gamma

import numpy
import pytest
from project import LIMIT, SUPPORT

COLOURS = {'red': (1, 0, 0), 'green': (0, 1, 0), 'blue': (0, 0, 1), 'yellow': (1, 1, 0), 'magenta': (1, 0, 1), 'cyan': (0, 1, 1)}
BITS = numpy.array([1, 2, 4])
SATURATED = 40  # [of 255]; the difference between the channels of a coloured pixel, and none of a grey one

pytestmark = pytest.mark.skipif(not shutil.which('xvfb-run'), reason='no xvfb-run')


@pytest.fixture(scope='module')
def pictures(tmp_path_factory):
    path = tmp_path_factory.mktemp('view') / 'pictures.npz'
    command = ['xvfb-run', '-a', 'yade', '-x', str(SUPPORT / 'viewscene.py'), str(path)]
    run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
    try:
        said, _ = run.communicate(timeout=LIMIT)
    finally:
        if run.poll() is None:  # the X server and YADE too
            os.killpg(run.pid, signal.SIGKILL)
            run.communicate()
    assert run.returncode == 0 and path.exists(), said
    with numpy.load(path) as file:
        return {name: content if name == 'boxes' else Picture(content) for name, content in file.items()}


class Picture:
    """What a picture shows: `brightness` and `colours` of the pixels, (height, width); a colour is a number whose three bits tell which
    channels are lit, 0 for grey."""

    def __init__(self, pixels):
        channels = pixels.astype(int)
        low, high = channels.min(axis=2), channels.max(axis=2)
        lit = channels > ((low + high) / 2)[:, :, None]
        self.brightness = channels.sum(axis=2)
        self.colours = numpy.where(high - low > SATURATED, lit @ BITS, 0)

    def shows(self, name):
        return self.colours == COLOURS[name] @ BITS

    def count(self, name):
        return self.shows(name).sum()

    def box(self, name):
        """Width and height of what is shown in a colour, in pixels."""
        rows, columns = numpy.nonzero(self.shows(name))
        return columns.max() - columns.min() + 1, rows.max() - rows.min() + 1


def test_bodiesStandInTheirOrder(pictures):
    places = [numpy.nonzero(pictures['smooth'].shows(name))[1].mean() for name in COLOURS]
    assert places == sorted(places)


@pytest.mark.parametrize('i, name', list(enumerate(COLOURS))[1:])
def test_sizeAndOrientation(pictures, i, name):
    diameter = pictures['smooth'].box('red')[0]
    assert diameter > 100
    assert pictures['smooth'].box(name) == pytest.approx(pictures['boxes'][i - 1] * diameter, abs=3)


@pytest.mark.parametrize('name, a, c, n', [('green', 1, 1, 8), ('blue', 0.6, 1.2, 20)])
def test_outline(pictures, name, a, c, n):
    # The area inside |x/a|^n + |z/c|^n = 1, against that of the circle.
    area = 4 * a * c * gamma(1 + 1 / n) ** 2 / gamma(1 + 2 / n) / numpy.pi
    assert pictures['smooth'].count(name) / pictures['smooth'].count('red') == pytest.approx(area, rel=0.02)


@pytest.mark.parametrize('name', list(COLOURS)[1:])
def test_wireIsSeenThrough(pictures, name):
    assert 0.02 < pictures['wire'].count(name) / pictures['smooth'].count(name) < 0.6
    assert pictures['wire'].box(name) == pytest.approx(pictures['smooth'].box(name), abs=4)


def test_lowQualityIsCoarser(pictures):
    assert pictures['coarse'].count('yellow') < 0.97 * pictures['smooth'].count('yellow')


def test_stripesAreOfTwoShades(pictures):
    change = (pictures['stripes'].brightness - pictures['smooth'].brightness)[pictures['smooth'].shows('green')]
    assert (change > 10).mean() > 0.2 and (change < -5).mean() > 0.2


@pytest.mark.parametrize('kind', ['container', 'endless'])
def test_theContainerStandsBehindTheBodies(pictures, kind):
    for name in COLOURS:
        assert pictures[kind].count(name) == pictures['smooth'].count(name)
    background = pictures['smooth'].colours == 0
    assert (pictures[kind].brightness > pictures['smooth'].brightness)[background].mean() > 0.5


@pytest.mark.parametrize('kind', ['wireContainer', 'threeSided'])
def test_otherContainersHideLittle(pictures, kind):
    for name in COLOURS:
        assert 0.7 < pictures[kind].count(name) / pictures['smooth'].count(name) <= 1
    assert (pictures[kind].brightness > pictures['smooth'].brightness).any()
