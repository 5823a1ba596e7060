"""The shapes' Python interface under any input: right answers, or refusals that leave the shape as it was."""
import math

from fuzzing import anything, direction, exponent, finite, fuzz, number, quaternion, ratio, refused, size, vector
from hypothesis import strategies as st
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import HollowCylinder, Superquadric

import yade.superquadric as sq
from yade.superquadric.scene.shapes import SHAPES

extents = st.tuples(size, ratio, ratio).map(lambda s: (s[0], s[0] * s[1], s[0] * s[2]))
shape = st.builds(lambda extents, n1, n2: Superquadric(extents=extents, n1=n1, n2=n2), extents, exponent, exponent)
METHODS = ('inertia', 'function', 'gauge', 'support', 'supportPoint', 'boxHalfExtents', 'meanCurvature')


def unitVolume(n1, n2):
    """By sections: the area of |x|^n2 + |y|^n2 <= 1 times the integral of (1 - z^n1)^(2/n1), a Beta function."""
    area = 4 * math.gamma(1 + 1 / n2) ** 2 / math.gamma(1 + 2 / n2)
    return area * 2 / n1 * math.gamma(1 / n1) * math.gamma(2 / n1 + 1) / math.gamma(3 / n1 + 1)


def close(value, expected, relative=1e-12):
    return abs(value - expected) <= relative * abs(expected)


@fuzz(weight=2, body=shape, towards=direction, point=direction)
def test_supportAndGaugeAreDual(body, towards, point):
    """h(d) is the largest d.x of all x with g(x) <= 1, taken at the support point."""
    n, scale = Vector3(*towards), max(body.extents)
    farthest = body.supportPoint(n)
    assert close(body.gauge(farthest), 1)
    assert close(n.dot(farthest), body.support(n), 1e-11)
    inside = Vector3(*(x * e for x, e in zip(point, body.extents)))
    surface = inside / body.gauge(inside)
    assert n.dot(surface) <= body.support(n) * (1 + 1e-12)
    assert surface.norm() <= body.boundingRadius() * (1 + 1e-12)
    assert (body.function(inside) < 1) == (body.gauge(inside) < 1) or close(body.gauge(inside), 1)
    assert math.isfinite(body.meanCurvature(surface)) and body.meanCurvature(surface) >= 0
    assert close(body.support(3 * n), 3 * body.support(n)) and scale <= body.boundingRadius() <= scale * math.sqrt(3)


@fuzz(body=shape, turn=quaternion, density=size)
def test_volumeInertiaAndBox(body, turn, density):
    a, b, c = body.extents
    assert close(body.volume(), a * b * c * unitVolume(body.n1, body.n2))
    x, y, z = body.inertia(density)
    mass = density * body.volume()
    assert min(x, y, z) > 0 and x + y > z and y + z > x and z + x > y
    assert x < mass * (b * b + c * c) and y < mass * (a * a + c * c) and z < mass * (a * a + b * b)
    box = body.boxHalfExtents(turn)
    for axis in range(3):
        assert close(box[axis], body.support(turn.conjugate() * Vector3.Unit(axis)), 1e-11)


@fuzz(weight=3, a=finite, b=finite, c=finite, n1=number, n2=number, towards=direction)
def test_anySizesAreRightOrRefused(a, b, c, n1, n2, towards):
    """Whatever is accepted gives numbers."""
    body, no = refused(lambda: Superquadric(extents=(a, b, c), n1=n1, n2=n2), 'half size', 'extents', 'n1', 'n2')
    if no:
        return
    n = Vector3(*towards)
    values = [body.volume(), *body.inertia(1.0), body.support(n), *body.supportPoint(n), body.gauge(body.supportPoint(n)), body.boundingRadius(),
              body.meanCurvature(body.supportPoint(n)), *body.boxHalfExtents(Quaternion(n, 1.0))]
    assert all(map(math.isfinite, values)) and min(body.volume(), *body.inertia(1.0), body.support(n)) > 0


@fuzz(weight=4, body=shape, method=st.sampled_from(METHODS), argument=st.one_of(anything, vector))
def test_methodsTakeAnything(body, method, argument):
    answer, no = refused(lambda: getattr(body, method)(argument), 'density', 'point', 'direction', 'orientation', also=OverflowError)
    if not no:
        assert not any(map(math.isnan, [answer] if isinstance(answer, float) else answer))


@fuzz(weight=3, center=vector, extents=vector, n1=anything, n2=anything, orientation=st.one_of(quaternion, anything), good=st.integers(0, 31))
def test_bodiesOfAnything(center, extents, n1, n2, orientation, good):
    """With some of the arguments replaced by good ones, so that each is the first bad one at times."""
    given = {'center': center, 'extents': extents, 'n1': n1, 'n2': n2, 'orientation': orientation}
    fine = {'center': (0, 0, 0), 'extents': (1, 2, 3), 'n1': 3, 'n2': 8.5, 'orientation': Quaternion.Identity}
    given.update({name: fine[name] for bit, name in enumerate(fine) if good >> bit & 1})
    body, no = refused(lambda: sq.superquadric(**given), *given)
    if not no:
        assert body.state.mass > 0 and min(body.state.inertia) > 0
        assert all(map(math.isfinite, (body.state.mass, *body.state.inertia, *body.state.pos))) and close(body.state.ori.norm(), 1)


@fuzz(weight=3, name=st.one_of(st.sampled_from(SHAPES), anything), radius=anything, aspect=st.one_of(st.just(1), anything),
      n1=st.one_of(st.none(), anything), n2=st.one_of(st.none(), anything))
def test_particleShapesOfAnything(name, radius, aspect, n1, n2):
    shape, no = refused(lambda: sq.particleShape(name, radius, aspect, n1, n2), 'shape', 'radius', 'aspect', 'n1', 'n2', 'extents')
    if not no:
        assert close(shape.volume, 4 / 3 * math.pi * float(radius) ** 3, 1e-11)
        assert math.isfinite(shape.boundingRadius) and shape.boundingRadius >= max(shape.extents)


@fuzz(body=shape, value=vector, n=number)
def test_refusedSizesLeaveTheShapeAsItWas(body, value, n):
    for name, new in (('extents', value), ('n1', n), ('n2', n)):
        before = body.dict(), body.volume(), body.boundingRadius()
        _, no = refused(lambda: setattr(body, name, new), 'half size', 'extents', 'n1', 'n2', also=OverflowError)
        if no:
            assert before == (body.dict(), body.volume(), body.boundingRadius())
    assert close(body.volume(), math.prod(body.extents) * unitVolume(body.n1, body.n2))


@fuzz(radius=number, height=number)
def test_hollowCylinders(radius, height):
    cylinder = HollowCylinder(radius=1, height=2)
    for name, new in (('radius', radius), ('height', height)):
        before = cylinder.dict()
        _, no = refused(lambda: setattr(cylinder, name, new), name)
        assert no == (not (new > 0 and (name == 'height' or math.isfinite(new))))
        assert cylinder.dict() == before if no else getattr(cylinder, name) == new
