"""What the fuzz tests share: how examples are drawn, counted and kept, which answers are right, and the values to try.

Each test draws examples with hypothesis: always the same few in `make test`, many others in `make fuzz` (FUZZ_EXAMPLES of them for a test of
weight 1). An example that ends the whole process cannot be reported by it: so each is written to the file named by LAST_EXAMPLE before it is tried,
and tests/run shows that file when YADE has died.
"""
import functools
import math
import os
from decimal import Decimal
from fractions import Fraction

import numpy
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from yade.minieigenHP import Quaternion, Vector2, Vector3

EXAMPLES = 40  # of a test of weight 1 in `make test`
NAN, INF = math.nan, math.inf
asked = os.environ.get('FUZZ_EXAMPLES')
tried = 0      # examples in this process


def fuzz(weight=1, **strategies):
    """Decorator: run the test with examples of the `strategies`, by the names of its parameters; `weight`: their number over the usual one."""
    def decorate(test):
        @functools.wraps(test)
        def recorded(**example):
            global tried
            tried += 1
            _keep(test.__name__, example)
            test(**example)
        number = max(1, round(weight * int(asked or EXAMPLES)))
        return settings(max_examples=number, derandomize=not asked, deadline=None, database=None, print_blob=True,
                        suppress_health_check=list(HealthCheck))(given(**strategies)(recorded))
    return decorate


def _keep(name, example):
    path = os.environ.get('LAST_EXAMPLE')
    if path:
        with open(path, 'w', encoding='utf-8', errors='replace') as file:
            file.write(f'{name}({", ".join(f"{key}={value!r}" for key, value in example.items())})\n')


def refused(call, *names, also=()):
    """Call and return (answer, False), or (error, True) if it refuses its arguments as it should.

    That is a TypeError, or a ValueError that names one of `names`; `also`: other errors that are right here. Whatever else is raised fails the test.
    """
    try:
        return call(), False
    except TypeError as error:
        return error, True
    except ValueError as error:
        assert not names or any(name in str(error) for name in names), f'{error!r} does not name {" or ".join(names)}'
        return error, True
    except also as error:
        return error, True


# --- values

# A number at all, from tiny to huge; the edges of what is accepted somewhere among them.
EDGES = (0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 20.0, 1.9999999999999998, 20.000000000000004, 5e-324, 2.3e-308, 1e-160, 1e-50, 1e-9,
         1e9, 1e50, 1e160, 1.8e308)
finite = st.one_of(st.sampled_from(EDGES), st.floats(allow_nan=False, allow_infinity=False), st.floats(-25, 25), st.integers(-3, 30))
number = st.one_of(finite, st.sampled_from((NAN, INF, -INF)))
size = st.floats(-9, 3).map(lambda power: 10.0 ** power)  # that something may have [m]
ratio = st.floats(-1, 1).map(lambda power: 10.0 ** power)
exponent = st.one_of(st.sampled_from((2.0, 20.0, 8.0)), st.floats(2, 20))
coordinate = st.floats(-1, 1)
direction = st.tuples(coordinate, coordinate, coordinate).filter(lambda v: math.hypot(*v) > 1e-3)
quaternion = st.tuples(*[coordinate] * 4).filter(lambda q: math.hypot(*q) > 1e-3).map(lambda q: Quaternion(*q).normalized())
unlike = st.one_of(
    st.none(), st.booleans(), st.text(max_size=6), st.binary(max_size=6), st.sampled_from(('1', 'nan', '1e3', 'x' * 5000, 'sphere', 'cube', b'7')),
    st.sampled_from((10 ** 400, -10 ** 400, 2 ** 31, 2 ** 63, Decimal('1.5'), Fraction(1, 3), 1j, object, math.sin, range(3))),
    st.sampled_from((numpy.float64(0.5), numpy.float32(3), numpy.int64(4), numpy.bool_(True), numpy.array(2.5), numpy.array([1.0, 2, 3]),
                     numpy.array([[1.0]]),
                     numpy.array(['a']), numpy.float64('nan'), numpy.str_('cube'))),
    st.sampled_from((Vector3(1, 2, 3), Vector3(NAN, 0, 0), Vector2(1, 2), Quaternion(0, 0, 0, 0), Quaternion(NAN, 0, 0, 1), Quaternion(1, 2, 3, 4))),
    st.recursive(number, lambda inner: st.lists(inner, max_size=4), max_leaves=6), st.dictionaries(st.text(max_size=3), number, max_size=3),
    st.lists(number, max_size=5).map(tuple), st.sets(st.integers(0, 9), max_size=4))
anything = st.one_of(number, unlike)
vector = st.one_of(st.tuples(number, number, number), st.tuples(number, number, number).map(lambda v: Vector3(*v)), direction, anything)


def survives(value):
    """Whether YADE's own conversion of lists survives the value: PartialEngine().ids = numpy.array(2.5) ends the process."""
    return not (isinstance(value, numpy.ndarray) and value.ndim == 0)


assignable = st.one_of(anything, vector).filter(survives)  # to an attribute


def same(first, second):
    """Whether two values are equal, NaN with NaN as well, in sequences and dicts too."""
    return repr(first) == repr(second) or bool(numpy.all(first == second))
