"""What every single event of breakage conserves: mass, centre of mass, momentum, angular momentum; and that rotation gets no energy.
10^4 events of all modes."""
import random

import numpy as np
import pytest
from breakagescene import RADIUS, Motion, breakAll, material, randomShape, scatter
from yade import O

import yade.superquadric as sq

EVENTS = 2000      # of each mode
CONSERVED = 1e-10  # relative: what the fragments and their parent may differ by; 1e-14 is seen
ROUNDING = 1e-12   # of an energy of rotation, relative

MODES = {'cube': dict(), 'cube, p = 3': dict(cutExponent=3), 'balls4': dict(mode='balls4'), 'balls18': dict(mode='balls18'),
         'superquadrics': dict()}


def parents(mode, rng):
    if mode == 'superquadrics':
        return [randomShape(rng) for _ in range(EVENTS)]
    return [sq.particleShape('sphere', RADIUS * rng.uniform(0.5, 2)) for _ in range(EVENTS)]


def relative(after, before, scale):
    return np.linalg.norm(np.asarray(after) - before) / scale


@pytest.mark.parametrize('mode', MODES)
def test_everyEventConserves(mode):
    O.reset()
    rng = random.Random(mode)
    ids = scatter(parents(mode, rng), material(), seed=1)
    before = {i: Motion([i]) for i in ids}
    engine = breakAll(ids, seed=2, **MODES[mode])
    events = engine.events()
    assert [event['parent'] for event in events] == ids and engine.spinGains == 0
    worst = dict.fromkeys(('mass', 'moment', 'momentum', 'angular'), 0.0)
    for event in events:
        old, new = before[event['parent']], Motion(event['children'])
        size, speed = event['size'], np.linalg.norm(old.momentum) / old.mass
        # The parent's own scales: sums of vectors may cancel.
        scales = {'mass': old.mass, 'moment': old.mass * size, 'momentum': old.mass * speed, 'angular': np.linalg.norm(old.angular)}
        for name, scale in scales.items():
            worst[name] = max(worst[name], relative(getattr(new, name), getattr(old, name), scale))
        assert event['spinLoss'] >= -ROUNDING * old.kinetic
        assert old.kinetic - new.kinetic == pytest.approx(event['spinLoss'], abs=ROUNDING * old.kinetic)
    assert max(worst.values()) < CONSERVED


def test_fragmentsKnowWhereTheyComeFrom():
    O.reset()
    ids = scatter([sq.particleShape('sphere', RADIUS)] * 3, material(), seed=1)
    first = breakAll(ids, seed=5).events()[1]
    grandchild = breakAll(first['children'][:1], seed=6).events()[0]['children'][0]
    state = O.bodies[grandchild].state
    assert (state.generation, state.parent, state.ancestor) == (2, first['children'][0], ids[1])
    assert O.bodies[ids[0]] is None and len(set(first['children'])) == 8 and min(first['children']) > max(ids)


def test_superquadricsBreakInPlace():
    """Same exponents and orientation, volumes of the blocks, and each inside the parent's box."""
    O.reset()
    rng = random.Random(3)
    ids = scatter([randomShape(rng) for _ in range(100)], material(), seed=2)
    old = {i: (O.bodies[i].shape, O.bodies[i].state) for i in ids}
    for event in breakAll(ids, seed=4).events():
        shape, state = old[event['parent']]
        children = [O.bodies[i] for i in event['children']]
        assert sum(child.shape.volume() for child in children) == pytest.approx(shape.volume(), rel=1e-12)
        for child, size in zip(children, event['childSizes']):
            assert (child.shape.n1, child.shape.n2, child.state.ori) == (shape.n1, shape.n2, state.ori)
            assert (6 * child.shape.volume() / np.pi) ** (1 / 3) == pytest.approx(size, rel=1e-12)
            place = state.ori.conjugate() * (child.state.pos - state.pos)
            assert shape.gauge(place) < 1
            for axis in range(3):
                assert abs(place[axis]) + child.shape.extents[axis] < shape.extents[axis] * 1.02
