"""A bed that is saved, loaded and continued moves bit for bit like one that was never interrupted, on one thread.

Two things are asked of the scene: the contacts are gone through in the order of their ids
(superquadricEngines()), because the collider starts anew after loading and finds them in another order,
and sums of forces depend on the order by rounding; and one thread, for the same reason.
"""
import math
import random

import pytest
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, InsertionSortCollider, InteractionLoop

import yade.superquadric as sq

RADIUS = 0.03  # of the container [m]
NUMBER = 100
SIZE = 4.5e-3  # radius of the sphere of a particle's volume [m]
BEFORE, AFTER = 6000, 2500  # steps before and after saving


def bed(seed):
    """Superquadrics of random shapes and spheres, above the base of a cylinder and falling."""
    O.reset()
    generator = random.Random(seed)
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                            tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(material)
    sq.cylinderContainer(RADIUS, 1.0, material)
    spacing = 3.4 * SIZE
    for i in range(NUMBER):
        center = Vector3((i % 2 - 0.5) * spacing, (i // 2 % 2 - 0.5) * spacing, (0.6 + i // 4) * spacing)
        O.bodies.append(particle(center, generator, material))
        O.bodies[-1].state.vel = Vector3(generator.uniform(-0.1, 0.1), generator.uniform(-0.1, 0.1), -2)
    O.engines = sq.superquadricEngines()
    for engine in O.engines:
        if isinstance(engine, (InteractionLoop, InsertionSortCollider)):
            engine.ompThreads = 1
    O.dt = 0.1 * sq.criticalTimeStep()


def particle(center, generator, material):
    if generator.random() < 0.3:
        return utils.sphere(center, SIZE, material=material)
    n1, n2 = generator.uniform(2, 12), generator.uniform(2, 12)
    extents = sq.equalVolumeExtents(SIZE, n1, n2, aspect=generator.uniform(0.7, 1.5))
    return sq.superquadric(center, extents, n1, n2, material, sq.randomOrientation(generator))


def condition():
    """All that moves and all that contacts remember, by body and by pair."""
    bodies = {body.id: tuple(map(tuple, (s.pos, s.vel, s.ori, s.angVel, s.angMom)))
              for body, s in ((body, body.state) for body in O.bodies)}
    contacts = {(i.id1, i.id2): (tuple(i.phys.shearDisplacement), tuple(i.phys.normalForce), tuple(i.phys.shearForce),
                                 tuple(i.geom.normal), i.geom.penetrationDepth)
                for i in O.interactions}
    return bodies, contacts


def differences(first, second):
    return [key for key in first.keys() | second.keys() if first.get(key) != second.get(key)]


def assertSame(first, second):
    assert not differences(first[0], second[0])
    assert not differences(first[1], second[1])


@pytest.fixture(scope='module')
def uninterrupted(tmp_path_factory):
    """The conditions of a run at the time it is saved and at its end, and the names of the files it saved."""
    folder = tmp_path_factory.mktemp('saved')
    bed(seed=5)
    O.run(BEFORE, wait=True)
    atSaving = condition()
    files = {kind: str(folder / f'bed.{kind}') for kind in ('yade.bz2', 'xml', 'bin')}
    for name in files.values():
        O.save(name)
    O.run(AFTER, wait=True)
    return atSaving, condition(), files


def test_bedHasContactsWithHistoryWhenSaved(uninterrupted):
    # A bed in free fall would continue exactly whatever was forgotten.
    (_, contacts), (_, contactsAtEnd), _ = uninterrupted
    assert len(contacts) > NUMBER / 2
    assert sum(any(displacement) for displacement, *_ in contacts.values()) > NUMBER / 3
    assert contacts.keys() != contactsAtEnd.keys()


@pytest.mark.parametrize('kind', ['yade.bz2', 'xml', 'bin'])
def test_loadedSceneIsTheSavedOne(uninterrupted, kind):
    atSaving, _, files = uninterrupted
    O.load(files[kind])
    bodies, contacts = condition()
    assert not differences(atSaving[0], bodies)
    # YADE does not save the overlap, it follows from the positions in the next step.
    assert not differences(withoutOverlap(atSaving[1]), withoutOverlap(contacts))


def withoutOverlap(contacts):
    return {ids: values[:-1] for ids, values in contacts.items()}


@pytest.mark.parametrize('kind', ['yade.bz2', 'xml', 'bin'])
def test_continuedRunEqualsTheUninterrupted(uninterrupted, kind):
    _, atEnd, files = uninterrupted
    O.load(files[kind])
    O.run(AFTER, wait=True)
    assertSame(atEnd, condition())


def test_sameSeedGivesTheSameRun(uninterrupted):
    _, atEnd, _ = uninterrupted
    bed(seed=5)
    O.run(BEFORE + AFTER, wait=True)
    assertSame(atEnd, condition())


def test_otherSeedGivesAnother(uninterrupted):
    atSaving, _, _ = uninterrupted
    bed(seed=6)
    O.run(BEFORE, wait=True)
    assert differences(atSaving[0], condition()[0])
