"""STL files of any content, damaged or never good: triangles, or a ValueError that names the file; quickly, however many triangles
they claim."""
import os
import struct
import time

import numpy
import pytest
from damage import damage, damaged
from fuzzing import fuzz, refused
from hypothesis import strategies as st

import yade.superquadric as sq

SLOW = 20  # s that no small file takes, on a busy machine either
CUBE = sq.TriangleMesh([[i >> axis & 1 for axis in range(3)] for i in range(8)], sq.regions.BOX_TRIANGLES, 'cube')


def asText(surface, eol='\n'):
    """As ASCII STL."""
    lines = ['solid part']
    for triangle in surface.points[surface.triangles].tolist():
        lines += ['facet normal 0 0 0', ' outer loop', *('  vertex {!r} {!r} {!r}'.format(*corner) for corner in triangle), ' endloop', 'endfacet']
    return eol.join([*lines, 'endsolid part', '']).encode()


@pytest.fixture(scope='module')
def file(tmp_path_factory):
    return str(tmp_path_factory.mktemp('stl') / 'some.stl')


def read(file, content):
    """(TriangleMesh, False), or (ValueError, True) that names the file."""
    with open(file, 'wb') as stream:
        stream.write(content)
    begin = time.monotonic()
    answer, no = refused(lambda: sq.readStl(file), file)
    assert time.monotonic() - begin < SLOW
    if no:
        assert isinstance(answer, ValueError)
    else:
        assert len(answer.triangles) > 0 and 0 <= answer.triangles.min() and answer.triangles.max() < len(answer.points)
        refused(answer.check, file)
    return answer, no


def binary(surface, file):
    sq.writeStl(file, surface)
    with open(file, 'rb') as stream:
        return stream.read()


@fuzz(weight=8, text=st.booleans(), how=damage.filter(lambda how: how[0] != 'other'))
def test_damagedFiles(file, text, how):
    """What was cut short is never taken for a smaller surface."""
    whole = asText(CUBE) if text else binary(CUBE, file)
    content = damaged(whole, *how)
    surface, no = read(file, content)
    if how[0] == 'cut' and len(content.rstrip()) < len(whole.rstrip()) - len(b'endsolid part'):
        assert no
    if content == whole:
        assert not no and numpy.array_equal(surface.points[surface.triangles], CUBE.points[CUBE.triangles])


WORDS = st.sampled_from(('solid', 'facet', 'normal', 'outer', 'loop', 'vertex', 'endloop', 'endfacet', 'endsolid', '0', '1', '-1e3', '1e400',
                         'nan', 'inf', '1,5', '0x1p3', '\n', '\r\n', '\t', '\0', 'part', 'facet normal 0 0 1 outer loop', 'endloop endfacet',
                         'vertex 0 0 0 vertex 1 0 0 vertex 0 1 0'))


@fuzz(weight=5, words=st.lists(WORDS, max_size=40), solid=st.booleans())
def test_textsOfAnyWords(file, words, solid):
    read(file, (('solid ' if solid else '') + ' '.join(words)).encode())


@fuzz(weight=4, header=st.one_of(st.just(b'solid x'), st.binary(max_size=80)),
      claimed=st.one_of(st.integers(0, 5), st.sampled_from((2 ** 31, 2 ** 32 - 1))),
      body=st.lists(st.one_of(st.floats(width=32), st.integers(-1, 1).map(float)), max_size=48), rest=st.integers(0, 49))
def test_binaryFilesOfAnyNumbers(file, header, claimed, body, rest):
    """A number of triangles that the file does not hold is refused, however large; the corners are those in the file, where all their coordinates
    are numbers."""
    rows = [body[i:i + 12] for i in range(0, len(body) - 11, 12)]
    content = header.ljust(80, b'\0') + struct.pack('<I', claimed) + b''.join(struct.pack('<12fH', *row, 0) for row in rows) + bytes(rest)
    surface, no = read(file, content)
    if claimed > len(rows) or claimed == 0:
        assert no
    elif not header.startswith(b'solid'):
        expected = numpy.array([row[3:] for row in rows[:claimed]]).reshape(-1, 3, 3)
        whole = numpy.isfinite(expected).all(axis=2)
        assert not no and numpy.array_equal(surface.points[surface.triangles][whole], expected[whole])


@fuzz(points=st.lists(st.tuples(*[st.floats(allow_nan=False, allow_infinity=False)] * 3), min_size=3, max_size=6),
      eol=st.sampled_from(('\n', '\r\n', ' ')))
def test_textsKeepAllDigits(file, points, eol):
    surface = sq.TriangleMesh(points, [[i, i + 1, i + 2] for i in range(len(points) - 2)])
    found, no = read(file, asText(surface, eol))
    assert not no and numpy.array_equal(found.points[found.triangles], surface.points[surface.triangles])


@fuzz(path=st.sampled_from(('', '.', '..', '/', '/dev/null', 'no such', 'nul\0l', 'x' * 5000, '\udc80')))
def test_whatIsNoFile(path):
    for name in (path, os.path.join(path, 'x.stl')):
        error, no = refused(lambda name=name: sq.readStl(name), name, repr(name))
        assert no and isinstance(error, ValueError)
