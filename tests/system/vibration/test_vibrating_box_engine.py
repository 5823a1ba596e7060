"""VibratingBoxEngine and VibrationRecorder as YADE's engines: bad input, saving and loading."""
import math

import pytest
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, InsertionSortCollider, InteractionLoop, NewtonIntegrator, VibratingBoxEngine, VibrationRecorder

import yade.superquadric as sq
from yade.superquadric.scene.engines import engine

STATE = dict(freeAxes='xz', mass=0.3, stiffness=Vector3(1, 2, 3), damping=Vector3(4, 5, 6), forceAmplitude=Vector3(7, 8, 9), frequency=10,
             phase=1, displacement=Vector3(0.1, 0, 0.2), velocity=Vector3(0.3, 0, 0.4))
BAD = [('mass', 0), ('mass', -1), ('mass', math.nan), ('mass', math.inf), ('frequency', -1), ('frequency', math.inf), ('phase', math.nan),
       ('freeAxes', 'w'), ('freeAxes', 'zz'), ('freeAxes', 'Z'), ('freeAxes', 'xyzx'),
       ('stiffness', Vector3(0, 0, -1)), ('stiffness', Vector3(math.inf, 0, 0)), ('damping', Vector3(0, -1e-9, 0)),
       ('damping', Vector3(math.nan, 0, 0)),
       ('forceAmplitude', Vector3(0, math.nan, 0)), ('displacement', Vector3(0, 0, math.inf)), ('velocity', Vector3(math.nan, 0, 0))]


@pytest.mark.parametrize('name, value', BAD)
def test_refusedValueIsNamedAndTheBoxStaysAsItWas(name, value):
    box = VibratingBoxEngine(**STATE)
    with pytest.raises(ValueError, match=f'{name} must be .*, got '):
        setattr(box, name, value)
    with pytest.raises(ValueError, match=name):
        VibratingBoxEngine(**{name: value})
    assert {key: getattr(box, key) for key in STATE} == STATE


def test_vectorsAreReadByValue():
    box = VibratingBoxEngine(**STATE)
    for name in ('stiffness', 'damping', 'forceAmplitude', 'displacement', 'velocity'):
        getattr(box, name)[2] = -1
        assert getattr(box, name) == STATE[name]


def aloneWith(body, **attributes):
    """A scene of one body that the box is to move, and the box."""
    O.reset()
    O.bodies.append(body)
    box = VibratingBoxEngine(ids=[0], **attributes)
    O.engines = [box, NewtonIntegrator()]
    O.engines[-1].warnNoForceReset = False
    O.dt = 1e-4
    return box


def test_memberThatCanMoveIsRefusedBeforeAnythingMoves():
    box = aloneWith(utils.sphere((0, 0, 0), 1), velocity=(0, 0, 1))
    with pytest.raises(ValueError, match='ids must be of bodies with all degrees of freedom blocked, got 0'):
        O.step()
    assert O.bodies[0].state.pos == Vector3.Zero and box.displacement == Vector3.Zero


@pytest.mark.parametrize('missing', (-1, 1, 1000))
def test_memberThatIsNotThereIsRefused(missing):
    box = aloneWith(utils.wall(0, axis=2))
    box.ids = [0, missing]
    with pytest.raises(ValueError, match=f'ids must be of bodies in the scene, got {missing}'):
        O.step()


def test_memberThatIsErasedLaterIsRefused():
    aloneWith(utils.wall(0, axis=2))
    O.step()
    O.bodies.erase(0)
    with pytest.raises(ValueError, match='ids must be of bodies in the scene, got 0'):
        O.step()


def test_clumpsAndTheirMembersAreRefused():
    box = aloneWith(utils.wall(0, axis=2))
    clump, members = O.bodies.appendClumped([utils.sphere((0, 0, i), 1) for i in (1, 2)])
    O.bodies[clump].state.blockedDOFs = 'xyzXYZ'
    for identity in (clump, members[0]):
        box.ids = [0, identity]
        with pytest.raises(ValueError, match=f'ids must be of bodies that belong to no clump, got {identity}'):
            O.step()


def test_boxBehindTheIntegratorIsRefused():
    box = aloneWith(utils.wall(0, axis=2))
    O.engines = O.engines[::-1]
    with pytest.raises(ValueError, match='no NewtonIntegrator after it'):
        O.step()
    assert box.displacement == Vector3.Zero


def test_recorderWithoutBoxOrParticleIsRefused():
    box = aloneWith(utils.wall(0, axis=2))
    for recorder, message in ((VibrationRecorder(), 'box = None'),
                              (VibrationRecorder(box=box, particles=[7]), 'particles must be bodies in the scene, got 7')):
        recorder.initRun, recorder.iterPeriod = True, 1
        O.engines = [box, NewtonIntegrator(), recorder]
        with pytest.raises(ValueError, match=message):
            O.step()


def test_heldAxesStandStillAndFreeOnesMove():
    box = aloneWith(utils.wall(0, axis=2), freeAxes='xz', velocity=(1, 1, 1), forceAmplitude=(0, 5, 0), frequency=10)
    O.run(100, True)
    assert list(box.displacement) == pytest.approx([1e-2, 0, 1e-2], rel=1e-12)
    box.freeAxes = ''
    O.run(100, True)
    assert list(O.bodies[0].state.pos) == pytest.approx([1e-2, 0, 1e-2], rel=1e-12) and O.bodies[0].state.vel == Vector3.Zero


def test_displacementThatIsSetMovesTheMembers():
    box = aloneWith(utils.wall((0, 0, 0.5), axis=2))
    O.step()
    box.displacement = (0, 0, 0.01)
    O.step()
    assert O.bodies[0].state.pos[2] == 0.51


def shakenBox():
    """Spheres and superquadrics in a driven box of six walls."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.3, density=2700, frictionAngle=0.4, normalDamping=0.2, tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(material)
    container = sq.boxContainer(0.05, 0.05, 0.04, material)
    shapes = [sq.particleShape('sphere', 4e-3), sq.particleShape('cylinder', 4e-3)] * 20
    particles, _ = sq.rainFilling(shapes, container._replace(height=1.0), material, seed=3)
    lid = O.bodies.append(utils.wall((0, 0, 0.1), axis=2, sense=-1, material=material))
    box = VibratingBoxEngine(ids=[container.baseId, *container.sideIds, lid], mass=0.1, stiffness=(0, 0, 3000), damping=(0, 0, 1),
                             forceAmplitude=(0, 0, 5), frequency=25)
    recorder = VibrationRecorder(box=box, particles=particles, iterPeriod=10)  # the first after the 10 first steps
    O.engines = [*sq.superquadricEngines(afterForces=[box]), recorder]
    for one in O.engines:
        if isinstance(one, (InteractionLoop, InsertionSortCollider)):
            one.ompThreads = 1
    O.trackEnergy = True
    O.dt = 0.1 * sq.criticalTimeStep()


def condition():
    box, recorder = (engine(kind) for kind in (VibratingBoxEngine, VibrationRecorder))
    # Tuples: YADE hands out references to its vectors, which would go on with the run.
    bodies = [(tuple(body.state.pos), tuple(body.state.vel)) for body in O.bodies]
    lists = 'times', 'boxDisplacement', 'boxVelocity', 'centroidPosition', 'centroidVelocity', 'contactForce'
    series = [list(getattr(recorder, name)) for name in lists]
    return tuple(box.displacement), tuple(box.velocity), tuple(box.contactImpulse), bodies, series, dict(O.energy.items())


@pytest.mark.parametrize('kind', ['yade.bz2', 'xml'])
def test_loadedSceneContinuesBitForBit(tmp_path, kind):
    shakenBox()
    O.run(3000, True)
    O.save(str(tmp_path / f'box.{kind}'))
    atSaving = condition()
    O.run(2000, True)
    atEnd = condition()
    O.load(str(tmp_path / f'box.{kind}'))
    assert engine(VibrationRecorder).box == engine(VibratingBoxEngine)  # the same engine, not a copy
    assert condition()[:5] == atSaving[:5]
    O.run(2000, True)
    assert condition()[:5] == atEnd[:5]
    assert condition()[5] == pytest.approx(atEnd[5], rel=1e-12)
    assert len(atEnd[4][0]) == 499 and atEnd[0] != atSaving[0]
