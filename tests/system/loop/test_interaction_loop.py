"""SuperquadricInteractionLoop against YADE's own loop: the same contacts, whatever happens to the bodies between two steps."""
import pytest
from yade import O, utils
from yade import superquadric as sq
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat, InteractionLoop, Law2_ScGeom_FrictPhys_CundallStrack, PyRunner, Sphere, SuperquadricInteractionLoop

from yade.superquadric.scene.engines import engine

HALF_SIZE = 0.01
LOOPS = [InteractionLoop, SuperquadricInteractionLoop]
ERASE_TWO = 'for body in list(O.bodies)[:2]: O.bodies.erase(body.id)'


def pair(distance, loop=SuperquadricInteractionLoop):
    """Two blocks side by side, weightless; the second one is returned."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500)
    for x in (0, distance):
        O.bodies.append(sq.superquadric((x, 0, 0), extents=Vector3(1, 1, 1) * HALF_SIZE, n1=4, n2=4, material=material))
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0), verletDist=0.5 * HALF_SIZE)
    current = engine(InteractionLoop)
    if loop is InteractionLoop:
        functors = [dispatcher.functors for dispatcher in (current.geomDispatcher, current.physDispatcher, current.lawDispatcher)]
        O.engines = [InteractionLoop(*functors) if each == current else each for each in O.engines]
    O.dt = 1e-6
    return O.bodies[1]


@pytest.mark.parametrize('loop', LOOPS)
def testABodyThatGrowsIsMet(loop):
    second = pair(2.15 * HALF_SIZE, loop)
    O.run(3, True)
    assert O.interactions.countReal() == 0
    second.shape.extents = (1.2 * HALF_SIZE, HALF_SIZE, HALF_SIZE)
    O.run(2, True)
    assert O.interactions.countReal() == 1


@pytest.mark.parametrize('loop', LOOPS)
@pytest.mark.parametrize('change', ['place', 'turn'])
def testABodyThatIsPutElsewhereIsMet(loop, change):
    # Along its diagonal the block reaches 1.19 half sizes: either motion closes the gap.
    second = pair(2.15 * HALF_SIZE, loop)
    O.run(3, True)
    assert O.interactions.countReal() == 0
    if change == 'place':
        second.state.pos = Vector3(1.95 * HALF_SIZE, 0, 0)
    else:
        second.state.ori = Quaternion((0, 0, 1), 0.785)
    O.run(2, True)
    assert O.interactions.countReal() == 1


def testAGapLastsUntilItIsUsedUp():
    second = pair(2.1 * HALF_SIZE)
    second.state.vel = Vector3(-0.1 * HALF_SIZE / 1000 / O.dt, 0, 0)  # closes the gap in 1,000 steps
    O.run(990, True)
    assert O.interactions.countReal() == 0
    assert sq.solverCounters()['stillApart'] > 900
    O.run(20, True)
    assert O.interactions.countReal() == 1


def testTheContactKeepsItsLawWhenTheListIsReplaced():
    pair(1.99 * HALF_SIZE)
    O.run(3, True)
    loop = engine(InteractionLoop)
    force = O.forces.f(0)[0]
    loop.lawDispatcher.functors = [Law2_ScGeom_FrictPhys_CundallStrack()]
    O.run(1, True)
    assert O.forces.f(0)[0] == pytest.approx(force, rel=0.01)


def testBothLoopsPushAlike():
    forces = []
    for loop in LOOPS:
        second = pair(1.99 * HALF_SIZE, loop)
        second.state.ori = Quaternion((0, 0, 1), 0.3)
        second.state.vel, second.state.angVel = Vector3(0, 0.1, 0), Vector3(5, 0, 0)
        O.run(200, True)
        forces.append(Vector3(O.forces.f(1)))
    assert (forces[0] - forces[1]).norm() < 1e-9 * forces[0].norm()
    assert forces[0].norm() > 0


def testErasedInteractionsComeBack():
    pair(1.99 * HALF_SIZE)
    O.run(3, True)
    O.interactions.erase(0, 1)
    O.run(2, True)
    assert O.interactions[0, 1].isReal


def sphericalPair(distance, loop=SuperquadricInteractionLoop):
    """The same of two of YADE's spheres."""
    second = pair(distance, loop)
    for body in O.bodies:
        body.shape = Sphere(radius=HALF_SIZE)
    return second


@pytest.mark.parametrize('loop', LOOPS)
def testSpheresThatGrowOrArePutElsewhereAreMet(loop):
    second = sphericalPair(2.15 * HALF_SIZE, loop)
    O.run(3, True)
    assert O.interactions.countReal() == 0
    second.shape.radius = 1.2 * HALF_SIZE
    O.run(2, True)
    assert O.interactions.countReal() == 1
    second.shape.radius = HALF_SIZE
    O.run(2, True)
    assert O.interactions.countReal() == 0
    second.state.pos = (1.95 * HALF_SIZE, 0, 0)
    O.run(2, True)
    assert O.interactions.countReal() == 1


def testSpheresMeetAtTheSameStepInBothLoops():
    begun = []
    for loop in LOOPS:
        second = sphericalPair(2.1 * HALF_SIZE, loop)
        second.state.vel = Vector3(-0.1 * HALF_SIZE / 1000 / O.dt, 0, 0)  # closes the gap in 1,000 steps
        O.run(990, True)
        while O.interactions.countReal() == 0:
            O.step()
        begun.append(O.iter)
    assert begun[0] == begun[1] and 999 <= begun[0] <= 1003


@pytest.mark.parametrize('isSuperquadric', [True, False], ids=['superquadrics', 'spheres'])
def testBodiesMadeInPythonMayBeErasedWhileTheSceneRuns(isSuperquadric):
    # Where the loop let go of such a shape last, in a thread without Python's lock, the whole process would end.
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500)
    for i in range(64):
        place = 1.99 * HALF_SIZE * Vector3(i % 4, i // 4 % 4, i // 16)
        if isSuperquadric:
            body = sq.superquadric(place, (HALF_SIZE,) * 3, 4, 4, material=material)
        else:
            body = utils.sphere(place, HALF_SIZE, material=material)
        O.bodies.append(body)
    O.engines = [*sq.superquadricEngines(gravity=(0, 0, 0), verletDist=0.2 * HALF_SIZE), PyRunner(command=ERASE_TWO, iterPeriod=1)]
    O.dt = 1e-7
    O.run(25, True)
    assert len(list(O.bodies)) == 64 - 2 * 24  # the runner passes the first step
    assert O.interactions.countReal() > 0
