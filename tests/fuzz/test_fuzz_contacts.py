"""Scenes of any bodies at any places: verdicts that hold, forces that are opposite and finite; or an error, and the console lives on."""
import math
import tempfile

import numpy
from fuzzing import INF, NAN, coordinate, direction, exponent, fuzz, quaternion, ratio, refused, size
from hypothesis import strategies as st
from scipy.optimize import minimize
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, Superquadric

import yade.superquadric as sq

solid = st.tuples(ratio, ratio, ratio, exponent, exponent)  # half sizes over the scene's size, exponents
PLACES = (NAN, INF, -INF, 1e300, -1e200, 1e20, 5e-324)


def emptyScene():
    O.reset()
    O.materials.append(CurvatureMat(young=1e9, poisson=0.2, density=2500, frictionAngle=0.4))


def shapeOf(numbers, scale):
    *extents, n1, n2 = numbers
    return [scale * e for e in extents], n1, n2


def pair(scale, bodies, turns, place, order):
    """Put two bodies into the scene, one at the origin, the second (or the first, by `order`) at `place`; do a step; return the interaction."""
    emptyScene()
    made = [sq.superquadric(position, *shapeOf(numbers, scale), orientation=turn)
            for numbers, turn, position in zip(bodies, turns, ((0, 0, 0), place))]
    for body in made[::order]:
        O.bodies.append(body)
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 1e-12 * sq.criticalTimeStep()
    O.step()
    return next(iter(O.interactions.all(onlyReal=True)), None)


def atDistance(distance, n, scale, bodies, turns):
    """Place of the second body along `n`, over the distance at which its supporting plane would touch that of the first."""
    shapes = [Superquadric(extents=extents, n1=n1, n2=n2) for extents, n1, n2 in (shapeOf(numbers, scale) for numbers in bodies)]
    return tuple(distance * n * sum(shape.support(turn.conjugate() * (side * n)) for shape, turn, side in zip(shapes, turns, (1, -1))))


def support(body, towards):
    return body.state.pos.dot(towards) + body.shape.support(body.state.ori.conjugate() * towards)


def gauge(body, point):
    return body.shape.gauge(body.state.ori.conjugate() * (point - body.state.pos))


def gap(first, second, towards):
    """Between the supporting planes of two bodies along a direction from the first to the second."""
    return -(support(first, towards) + support(second, -towards))


def deepest(first, second):
    """The larger one of both gauges at the point where that is smallest, as far as a search finds it: below 1 there is a point inside both."""
    start = numpy.array([first.state.pos, second.state.pos]).mean(axis=0)
    reach = (second.state.pos - first.state.pos).norm()
    return minimize(lambda x: max(gauge(first, Vector3(*(start + reach * x))), gauge(second, Vector3(*(start + reach * x)))), numpy.zeros(3),
                    method='Nelder-Mead', options={'maxiter': 150}).fun


@fuzz(weight=3, scale=size, bodies=st.tuples(solid, solid), turns=st.tuples(quaternion, quaternion), towards=direction,
      distance=st.one_of(st.floats(0, 3), st.floats(0.9, 1.1)))
def test_verdictsHold(scale, bodies, turns, towards, distance):
    """A contact has a point inside both, and no planes across its normal are farther apart than its overlap; without one no point is found inside
    both."""
    n = Vector3(*towards).normalized()
    contact = pair(scale, bodies, turns, atDistance(distance, n, scale, bodies, turns), 1)
    first, second = O.bodies[0], O.bodies[1]
    tolerance = 1e-9 * max(max(body.shape.extents) for body in (first, second))
    if contact is None:
        assert deepest(first, second) > 1 - 1e-6
        return
    geom = contact.geom
    assert geom.penetrationDepth > 0 and abs(geom.normal.norm() - 1) < 1e-12
    if geom.penetrationDepth < 0.5 * min(min(body.shape.extents) for body in (first, second)):  # else one has swallowed the other's middle
        assert max(gauge(first, geom.contactPoint), gauge(second, geom.contactPoint)) < 1 + 1e-9
    assert gap(first, second, geom.normal) <= -geom.penetrationDepth * (1 - 1e-6) + tolerance
    assert (O.forces.f(0) + O.forces.f(1)).norm() <= 1e-12 * O.forces.f(0).norm()
    assert all(map(math.isfinite, (*O.forces.f(0), *O.forces.t(0), *O.forces.t(1))))


@fuzz(scale=size, bodies=st.tuples(solid, solid), turns=st.tuples(quaternion, quaternion), towards=direction, distance=st.floats(0.95, 1.02))
def test_orderDoesNotMatter(scale, bodies, turns, towards, distance):
    """Of bodies that overlap a little: in a deep overlap there may be several normals."""
    n = Vector3(*towards).normalized()
    place = atDistance(distance, n, scale, bodies, turns)
    found = []
    for order in (1, -1):
        contact = pair(scale, bodies, turns, place, order)
        found.append(contact and (contact.geom.penetrationDepth, order * contact.geom.normal))
    if found[0] is None or found[1] is None:
        assert all(f is None or f[0] < 1e-9 * scale for f in found)
    elif 1e-6 * scale < found[0][0] < 0.02 * scale:
        (depth1, normal1), (depth2, normal2) = found
        assert abs(depth1 - depth2) < 1e-5 * depth1 and (normal1 - normal2).norm() < 1e-4


KINDS = ('superquadric', 'sphere', 'wall', 'facet', 'cylinder')
body = st.tuples(st.sampled_from(KINDS), solid, quaternion, st.tuples(*[st.one_of(coordinate, coordinate, st.sampled_from(PLACES))] * 3),
                 st.tuples(*[st.one_of(coordinate, st.sampled_from(PLACES))] * 3), st.integers(0, 2))


def add(kind, numbers, turn, place, velocity, axis):
    """Whatever it is, past all checks: positions and velocities are YADE's own attributes, which nobody looks at."""
    extents, n1, n2 = shapeOf(numbers, 0.3)
    if kind == 'superquadric':
        made = sq.superquadric((0, 0, 0), extents, n1, n2, orientation=turn)
    elif kind == 'sphere':
        made = utils.sphere((0, 0, 0), extents[0])
    elif kind == 'wall':
        made = utils.wall(0.0, axis)
    elif kind == 'facet':
        made = utils.facet([Vector3(extents[0], 0, 0), Vector3(0, extents[1], 0), Vector3(-extents[0], 0, extents[2])])
    else:
        sq.cylinderContainer(extents[0] + 0.5, extents[2] + 0.5, O.materials[0])
        return
    made.state.pos, made.state.vel = Vector3(*place), Vector3(*velocity)
    O.bodies.append(made)


@fuzz(weight=3, bodies=st.lists(body, min_size=1, max_size=6), erased=st.integers(0, 20), steps=st.integers(1, 4),
      dt=st.sampled_from((1e-12, 1e-6, 1.0, 1e200, 0.0)))
def test_anySceneStepsOrRefuses(bodies, erased, steps, dt):
    emptyScene()
    for one in bodies:
        add(*one)
    O.engines = sq.superquadricEngines(gravity=(0, 0, -9.81))
    O.dt = dt
    for step in range(steps):
        refused(O.step, also=RuntimeError)
        if erased < len(O.bodies) and step == 0:
            O.bodies.erase(erased)
    O.trackEnergy = True
    refused(O.step, also=RuntimeError)


def pairs():
    """With a geometry: the others are found again by the collider."""
    return sorted((i.id1, i.id2, i.isReal) for i in O.interactions.all() if i.geom is not None)


@fuzz(bodies=st.lists(body, min_size=1, max_size=4), kind=st.sampled_from(('yade', 'xml', 'yade.gz')))
def test_savedScenesAreLoadedAlike(bodies, kind):
    emptyScene()
    for one in bodies:
        add(*one[:3], [x if abs(x) < 2 else 0.5 for x in one[3]], (0, 0, 0), one[5])
    O.engines = sq.superquadricEngines()
    O.dt = 1e-9
    O.step()
    before = [(repr(b.shape.dict()), repr(b.mat.dict()), repr(b.state.pos), repr(b.state.ori)) for b in O.bodies]
    contacts = pairs()
    with tempfile.TemporaryDirectory() as folder:
        O.save(f'{folder}/scene.{kind}')
        O.reset()
        O.load(f'{folder}/scene.{kind}')
    assert before == [(repr(b.shape.dict()), repr(b.mat.dict()), repr(b.state.pos), repr(b.state.ori)) for b in O.bodies]
    assert contacts == pairs()
