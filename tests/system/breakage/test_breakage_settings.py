"""Breakage beyond the plain scene: under the law that yields, across the border of a periodic cell, on two threads."""
import json
import os
import subprocess

import numpy as np
import pytest
from breakagescene import RADIUS, Motion, material, singleThread
from project import LIMIT, SUPPORT
from yade import O
from yade.minieigenHP import Matrix3, Quaternion, Vector3
from yade.wrapper import BreakageEngine

import yade.superquadric as sq

SMALLEST = 1.6e-3       # no fragment is smaller [m]
STEP = 0.1              # time step over the critical one of that size
CELL = 12 * RADIUS      # of the periodic scene [m]
SPEED = 3.0             # of the neighbours towards the parent [m/s]: they yield
GAIN = 2e-3             # of a cluster's energy after breakage, at most: the time step's, see test_breakage_energy
CONTACT = 70            # steps after which the neighbours press hardest, about
YIELDING = dict(yieldStress=3e5, m0=2.6, exponent=2)
SHAPES = {'sphere': sq.particleShape('sphere', RADIUS), 'block': sq.ParticleShape((RADIUS, 1.2 * RADIUS, 0.9 * RADIUS), 6, 6, False)}


def cluster(kind, centre=Vector3.Zero, **attributes):
    """A parent in the middle of six spheres that come from all sides; ids, the parent's first, and the engine."""
    mat = material(characteristicStrength=1e30, frictionAngle=0, **attributes)
    shape = SHAPES[kind]
    ids = [O.bodies.append(shape.body(centre, Quaternion.Identity, mat))]
    for axis in range(3):
        for side in (-1, 1):
            way = side * Vector3(*(float(k == axis) for k in range(3)))
            ids.append(O.bodies.append(sq.particleShape('sphere', 0.8 * RADIUS).body(centre + (shape.extents[axis] + 0.8 * RADIUS) * way,
                                                                                    Quaternion.Identity, mat)))
            O.bodies[ids[-1]].state.vel = -SPEED * (1 + 0.1 * axis) * way
    engine = BreakageEngine(seed=3, smallestFragment=SMALLEST)
    O.engines = [engine, *sq.superquadricEngines(gravity=(0, 0, 0))]
    singleThread()
    O.dt = STEP * mat.criticalTimeStep(SMALLEST / 2)
    return ids, engine


def energy():
    """Kinetic and stored energy of the scene [J]."""
    return Motion([body.id for body in O.bodies]).kinetic + sum(contact.phys.storedEnergy() for contact in O.interactions if contact.isReal)


@pytest.mark.parametrize('kind', SHAPES)
def test_yieldingContactsBreakWithoutNewEnergy(kind):
    """The parent breaks at the height of the blow, its contacts have yielded; what follows has no more energy than there was, and all momentum."""
    O.reset()
    O.trackEnergy = True
    ids, engine = cluster(kind, **YIELDING)
    assert 'LoadingUnloading' in type(O.engines[3].lawDispatcher.functors[0]).__name__
    O.run(CONTACT, True)
    plastic = O.energy['yieldDissip']
    before = Motion([body.id for body in O.bodies])
    course = [energy()]
    assert plastic > 0.01 * course[0], 'the test must meet yielding'
    engine.forced = [ids[0]]
    for _ in range(40):
        O.run(50, True)
        course.append(energy())
    after = Motion([body.id for body in O.bodies])
    assert engine.events()[0]['value'] > 0 and len(engine.events()) == 1 and len(O.bodies) == 15 and O.energy['yieldDissip'] >= plastic
    assert max(course) <= course[0] * (1 + GAIN)
    assert after.mass == pytest.approx(before.mass, rel=1e-12)
    assert np.allclose(after.momentum, before.momentum, rtol=0, atol=1e-9 * before.mass * SPEED)


def periodicRun(kind, centre):
    """(value at which the parent broke [Pa], energy after the course [J], its momentum over mass and speed)."""
    O.reset()
    O.periodic = True
    O.cell.hSize = Matrix3.Identity * CELL
    ids, engine = cluster(kind, centre)
    O.run(CONTACT, True)
    engine.forced = [ids[0]]
    O.run(600, True)
    motion = Motion([body.id for body in O.bodies])
    return engine.events()[0]['value'], energy(), motion.momentum / motion.mass / SPEED


@pytest.mark.parametrize('kind', SHAPES)
def test_breakageAcrossTheBorderOfAPeriodicCell(kind):
    """Where in the cell the parent is makes no difference: in the middle, on a corner of the cell, or three cells away."""
    value, left, momentum = periodicRun(kind, CELL * Vector3(0.5, 0.5, 0.5))
    assert value > 0 and np.abs(momentum).max() < 1e-9
    for place in ((0, 0, 0), (3.02, -2.01, 0.5)):
        other = periodicRun(kind, CELL * Vector3(*place))
        assert other[0] == pytest.approx(value, rel=1e-6) and other[1] == pytest.approx(left, rel=1e-4)
        assert np.abs(other[2]).max() < 1e-9


def crush(output):
    """A bed under a lid, on as many threads as YADE was given; what came of it into the file `output`."""
    from test_breakage_continues import crushedBed, run
    crushedBed(seed=1)
    for engine in O.engines:
        if hasattr(engine, 'ompThreads'):
            engine.ompThreads = -1
    events = run(1500)[3]
    ids = [body.id for body in O.bodies if not body.state.blockedDOFs]
    with open(output, 'w', encoding='utf-8') as file:
        json.dump({'threads': O.numThreads, 'events': len(events), 'children': sum(len(event['children']) for event in events), 'bodies': len(ids),
                   'mass': Motion(ids).mass, 'first': [events[0]['parent'], events[0]['value']]}, file)


def test_twoThreadsBreakAsOneDoes(tmp_path):
    """The order of sums differs by thread, so later events may: the first one is the same, and nothing is lost."""
    found = []
    for threads in (1, 2):
        output = tmp_path / f'{threads}.json'
        script = tmp_path / f'{threads}.py'
        script.write_text(f'import sys\nsys.path[:0] = {[str(SUPPORT), os.path.dirname(os.path.abspath(__file__))]!r}\n'
                          f'import test_breakage_settings\ntest_breakage_settings.crush({str(output)!r})\n')
        # Threads that wait must not spin: on a busy machine they would keep each other from working.
        done = subprocess.run(['yade', f'-j{threads}', '-n', '-x', script], env={**os.environ, 'OMP_WAIT_POLICY': 'passive'}, capture_output=True,
                              text=True, timeout=LIMIT)
        assert output.exists(), done.stdout + done.stderr
        found.append(json.loads(output.read_text()))
    one, two = found
    assert (one['threads'], two['threads']) == (1, 2)
    assert one['events'] > 5 and two['events'] > 5
    assert two['first'][0] == one['first'][0] and two['first'][1] == pytest.approx(one['first'][1], rel=1e-3)
    for result in found:
        assert result['bodies'] == 30 + result['children'] - result['events']
        assert result['mass'] == pytest.approx(one['mass'], rel=1e-12)
