"""Particles that break and boxes that vibrate, with any parameters that their engines accept: conserved, finite, or an error that says why."""
import math

import numpy
from breakagescene import GLASS, NOTHING_MOVES, Motion
from fuzzing import assignable, direction, exponent, finite, fuzz, quaternion, ratio, refused, size
from hypothesis import strategies as st
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import BreakableMat, BreakageEngine, ForceResetter, NewtonIntegrator, VibratingBoxEngine, VibrationRecorder

import yade.superquadric as sq

solid = st.one_of(st.none(), st.tuples(ratio, ratio, ratio, exponent, exponent))  # None: a sphere
motion = st.tuples(quaternion, direction, direction)
cutting = st.fixed_dictionaries({
    'mode': st.sampled_from(('cube', 'cube', 'cube', 'balls4', 'balls18')), 'criterion': st.sampled_from(('octahedral', 'force')),
    'cutExponent': st.one_of(st.just(2.0), ratio, size, finite.map(abs)),
    'smallestFragment': st.one_of(st.just(0.0), st.just(0.0), size, finite.map(abs)),
    'maxEvents': st.integers(1, 3), 'seed': st.integers(0, 2 ** 31 - 1)})
# What a step may be refused for.
BREAKAGE = 'forced', 'mode', 'O.dt', 'strength', 'cutExponent', 'smallestFragment', 'inertialSize', 'inertiaFactor'


def particles(solids, motions, radius, apart, **material):
    """Side by side, `apart` times as far as they reach, spinning; their ids."""
    O.reset()
    mat = BreakableMat(**{**GLASS, 'referenceSize': 2 * radius, **material})
    ids, x = [], 0.0
    for numbers, (turn, velocity, spin) in zip(solids, motions):
        shape = sq.ParticleShape([radius * n for n in (numbers or (1, 1, 1))[:3]], *(numbers or (2, 2, 2, 2, 2))[3:], numbers is None)
        body = shape.body((0, 0, 0), turn, mat)
        reach = radius if numbers is None else body.shape.boxHalfExtents(turn)[0]
        x += apart * reach
        body.state.pos, body.state.vel, body.state.angVel = Vector3(x, 0, 0), Vector3(*velocity), Vector3(*spin) / radius
        x += apart * reach
        ids.append(O.bodies.append(body))
    return ids


def living():
    return [body.id for body in O.bodies if body is not None]


def step(*names):
    """Whether the step is refused."""
    return refused(O.step, *names, also=RuntimeError)[1]


@fuzz(weight=5, solids=st.lists(solid, min_size=1, max_size=3), motions=st.tuples(motion, motion, motion), radius=size, engine=cutting,
      forced=st.lists(st.one_of(st.integers(0, 2), st.integers(-2, 4)), max_size=4))
def test_whatBreaksConserves(solids, motions, radius, engine, forced):
    """Mass, centre, momentum, angular momentum; no energy of motion comes in. A step that is refused breaks nothing."""
    ids = particles(solids, motions, radius, 1.1)
    before = Motion(ids)
    breaker, no = refused(lambda: BreakageEngine(forced=forced, **engine), *engine)
    if no:
        return
    O.engines, O.dt = [breaker], NOTHING_MOVES * radius
    if step(*BREAKAGE):
        assert living() == ids and not breaker.events()
        return
    after, reach = Motion(living()), 10 * len(ids) * radius
    assert {event['parent'] for event in breaker.events()} == set(forced) <= set(ids) and len(living()) > len(ids) - (not forced)
    assert math.isclose(after.mass, before.mass, rel_tol=1e-12)
    for now, then, scale in ((after.moment, before.moment, before.mass * reach), (after.momentum, before.momentum, 2 * before.mass),
                             (after.angular, before.angular, 2 * before.mass * reach)):
        assert numpy.linalg.norm(now - then) <= 1e-9 * scale
    assert after.kinetic <= before.kinetic * (1 + 1e-9)
    assert all(event['size'] > 0 and event['strength'] > 0 and event['value'] >= 0 for event in breaker.events())


@fuzz(weight=3, solids=st.lists(solid, min_size=2, max_size=3), motions=st.tuples(motion, motion, motion), apart=st.floats(0.8, 1.01), engine=cutting,
      strength=st.one_of(st.just(1.0), finite.map(abs)), modulus=st.one_of(st.just(3.0), finite.map(abs)),
      least=st.one_of(st.just(0.0), finite.map(abs)), inertial=st.one_of(st.just(0.0), st.just(1e-3), finite.map(abs)),
      dt=st.floats(-12, -4))
def test_pressedParticlesBreakOrSayWhyNot(solids, motions, apart, engine, strength, modulus, least, inertial, dt):
    """Steps with contacts: all stays finite, the true mass stays; or an error."""
    ids, no = refused(lambda: particles(solids, motions, 5e-3, apart, characteristicStrength=strength, weibullModulus=modulus, smallestSize=least),
                      'characteristicStrength', 'weibullModulus', 'smallestSize')
    breaker, alsoNo = refused(lambda: BreakageEngine(inertialSize=inertial, **engine), *engine, 'inertialSize')
    if no or alsoNo:
        return
    O.engines, O.dt = [breaker, *sq.superquadricEngines(gravity=(0, 0, 0))], 10 ** dt
    before = sum(O.bodies[i].state.mass for i in ids)
    for _ in range(3):
        if step(*BREAKAGE):
            return
    states = [O.bodies[i].state for i in living()]
    if O.dt <= 0.1 * sq.criticalTimeStep():
        assert all(math.isfinite(x) for state in states for x in (*state.pos, *state.vel, *state.angVel, state.mass, *state.inertia))
    assert math.isclose(sum(state.mass / state.inertiaFactor for state in states), before, rel_tol=1e-9)


wide = st.one_of(st.floats(-3, 3).map(lambda power: 10.0 ** power), finite)
least = wide.map(abs)
BOX = {'mass': least, 'frequency': least, 'phase': finite, 'stiffness': st.tuples(least, least, least), 'damping': st.tuples(least, least, least),
       **{name: st.tuples(wide, wide, wide) for name in ('forceAmplitude', 'displacement', 'velocity')}}


def boxScene(dt, **attributes):
    """A wall in a vibrating box."""
    O.reset()
    O.bodies.append(utils.wall(0, axis=2))
    box, no = refused(lambda: VibratingBoxEngine(ids=[0], freeAxes='xyz', **attributes), *attributes)
    if no:
        return None
    O.engines = [ForceResetter(), box, NewtonIntegrator(), VibrationRecorder(box=box, iterPeriod=1)]
    O.dt, O.trackEnergy = dt, True
    return box


@fuzz(weight=6, given=st.fixed_dictionaries(BOX),
      dt=st.one_of(st.floats(-8, 0).map(lambda power: 10.0 ** power), st.sampled_from((1e30, 1e200, 1e-300))),
      push=st.one_of(st.just((0, 0, 0)), st.tuples(finite, finite, finite), st.just((math.nan, 0, 0))))
def test_boxesMoveOrSayWhyNot(given, dt, push):
    """However it is driven, the box is where a number says, or the step is refused and it is where it was."""
    box = boxScene(dt, **given)
    if box is None:
        return
    O.forces.setPermF(0, Vector3(*push))
    for _ in range(4):
        before = tuple(box.displacement), tuple(box.velocity), tuple(O.bodies[0].state.pos)
        if refused(O.step, 'VibratingBoxEngine', 'box')[1]:
            assert before == (tuple(box.displacement), tuple(box.velocity), tuple(O.bodies[0].state.pos))
            break
        assert all(map(math.isfinite, (*box.displacement, *box.velocity, *O.bodies[0].state.pos, *box.contactImpulse)))
    box.phase = 0.5  # a box that is broken off is still one


MODERATE = {'mass': ratio, 'frequency': st.floats(0, 50), 'phase': st.floats(-1, 1), **{
    name: st.tuples(*[st.floats(low, high)] * 3) for name, low, high in (
        ('stiffness', 0, 1e4), ('damping', 0, 100), ('forceAmplitude', -9, 9), ('displacement', -1, 1),
        ('velocity', -9, 9))}}


@fuzz(weight=1, given=st.fixed_dictionaries(MODERATE), dt=st.floats(-6, -3.5))
def test_energyOfABox(given, dt):
    """Kinetic energy, springs, dashpots and drive add up to the same at every step, to rounding."""
    boxScene(10 ** dt, **given)
    sums, largest = [], 0.0
    for _ in range(30):
        O.step()
        parts = [value for name, value in O.energy.items() if name.startswith('box')]
        sums.append(sum(parts))
        largest = max(largest, *map(abs, parts))
    assert numpy.ptp(sums) <= 1e-11 * largest


def attributes(which):
    """Of an engine of that class, and values for them; [0, 1] are ids in the scene."""
    names = sorted(set(which().dict()) - {'label'})
    return st.tuples(st.just(which), st.dictionaries(st.sampled_from(names), st.one_of(assignable, st.just([0, 1])), max_size=3))


@fuzz(weight=2, made=st.sampled_from((BreakageEngine, VibratingBoxEngine, VibrationRecorder)).flatmap(attributes), steps=st.integers(1, 3))
def test_enginesOfAnythingStep(made, steps):
    """With what it has accepted, one attribute or several, in a scene that may not suit it: it does its step or says what is wrong."""
    (which, values), _ = made, particles([None, (1, 1, 1, 4, 4)], [(Quaternion.Identity, (1, 0, 0), (0, 0, 1))] * 2, 5e-3, 1)
    engine = which()
    for name, value in values.items():
        refused(lambda name=name, value=value: setattr(engine, name, value), name, also=(AttributeError, OverflowError, SystemError))
    engines = sq.superquadricEngines(gravity=(0, 0, 0), afterForces=[] if which is BreakageEngine else [engine])
    O.engines, O.dt = ([engine] if which is BreakageEngine else []) + engines, 1e-9
    for _ in range(steps):
        refused(O.step, also=RuntimeError)
