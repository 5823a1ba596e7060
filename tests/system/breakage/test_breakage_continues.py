"""A bed that is crushed repeats from its seed, and goes on from a saved scene, bit for bit on one thread."""
import math

import pytest
from breakagescene import material, singleThread
from yade import O, utils
from yade.wrapper import BreakageEngine, Wall

import yade.superquadric as sq

RADIUS, SMALLEST = 4e-3, 1.6e-3
STEPS = 3000  # from the start to where it is saved, and from there to the end


def crushedBed(seed):
    """Spheres, or blocks, in a box whose lid comes down."""
    O.reset()
    mat = material(characteristicStrength=3e4, normalDamping=0.2, tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(mat)
    container = sq.boxContainer(0.03, 0.03, 0.03, mat)
    shapes = [sq.particleShape('sphere', RADIUS), sq.particleShape('cube', RADIUS)] * 15
    sq.rainFilling(shapes, container._replace(height=1.0), mat, seed=3)
    highest = max(body.state.pos[2] for body in O.bodies if not isinstance(body.shape, Wall)) + 2 * RADIUS
    lid = O.bodies.append(utils.wall((0, 0, highest), axis=2, sense=-1, material=mat))
    O.bodies[lid].state.vel = (0, 0, -4.0)
    O.engines = [BreakageEngine(seed=seed, smallestFragment=SMALLEST, maxEvents=2), *sq.superquadricEngines()]
    singleThread()
    O.trackEnergy = True
    O.dt = 0.15 * mat.criticalTimeStep(SMALLEST / 2)


def condition():
    """Tuples: YADE hands out references to its vectors, which would go on with the run."""
    bodies = [(body.id, tuple(body.state.pos), tuple(body.state.vel), tuple(body.state.angVel), body.state.mass) for body in O.bodies]
    strengths = [repr(getattr(body.state, 'strength', None)) for body in O.bodies]  # nan equals itself
    rests = sorted((i.id1, i.id2, i.phys.restOverlap) for i in O.interactions if i.isReal)
    return bodies, strengths, rests, O.engines[0].events()


def run(steps):
    O.run(steps, True)
    return condition()


def test_loadedSceneContinuesBitForBit(tmp_path):
    crushedBed(seed=1)
    atSaving = run(STEPS)
    files = [str(tmp_path / f'bed.{kind}') for kind in ('yade.bz2', 'xml')]
    for file in files:
        O.save(file)
    atEnd = run(STEPS)
    energies = dict(O.energy.items())
    for file in files:
        O.load(file)
        assert condition() == atSaving
        assert run(STEPS) == atEnd
        assert dict(O.energy.items()) == pytest.approx(energies, rel=1e-10)
    events = len(atSaving[3]), len(atEnd[3])
    assert 5 < events[0] < events[1] - 5, 'the test must meet breakage before and after'
    assert any(rest > 0 for _, _, rest in atSaving[2]) and any(event['generation'] for event in atEnd[3])


def test_runRepeatsFromItsSeedAndOtherSeedsDiffer():
    ends = []
    for seed in (1, 1, 2):
        crushedBed(seed)
        ends.append(run(STEPS))
    assert ends[0] == ends[1]
    assert ends[0][3] != ends[2][3]
    assert not any(math.isnan(value) for body in ends[0][0] for value in body[1])


def test_theWorstBreakFirstAndTheOthersWait():
    """A loaded bed that becomes weak at once: many are over their strength at one call."""
    crushedBed(seed=1)
    engine = O.engines[0]
    engine.dead = True
    O.run(STEPS, True)
    loaded = [body for body in O.bodies if body.state.mass > 0 and any(i.phys.normalForce.norm() > 0.1 for i in body.intrs())]
    for body in loaded:
        body.state.strength = 1.0
    engine.dead = False
    O.run(1, True)
    assert len(loaded) > 4 and engine.waiting >= len(loaded) - engine.maxEvents
    O.run(1, True)
    events = engine.events()
    assert [event['step'] for event in events] == 2 * [STEPS] + 2 * [STEPS + 1]
    values = [event['value'] for event in events]
    assert values[0] >= values[1] and values[2] >= values[3]
