"""Settled beds of equal particles in a box of five walls: how they are poured, kept and put back into a scene.

A bed is poured once and kept (bedcache.py) under a name with the hash of this file: whoever changes it gets new beds. Everything
that decides how a bed looks is in here. All kinds have particles of the volume of a 5 mm sphere, the same density,
friction, stiffness and restitution, and the same box.
"""
import json
import math
import os
from collections import namedtuple
from pathlib import Path

import numpy as np
from yade import O
from yade import superquadric as sq
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    Bo1_Wall_Aabb,
    CurvatureMat,
    ForceResetter,
    FrictMat,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Wall_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_FrictMat_FrictMat_MindlinPhys,
    Law2_ScGeom_MindlinPhys_Mindlin,
    NewtonIntegrator,
)

from yade.superquadric.scene import settlingrules

RADIUS = 5e-3                   # m, of the sphere of a particle's volume
WIDTH = 0.168                   # m, of the box: the cross section of a cylinder 19 cm wide,
SMALL_WIDTH, SMALL = 0.07, 500  # and of the one for fewer than so many particles, which would make no bed in the other
DENSITY, POISSON = 2500.0, 0.2
FRICTION = 0.4
YOUNG = 1e8                     # Pa; overlaps at the base are then a few thousandths of a particle
SOFTENING = 10.0                # while superquadrics are poured; YADE's spheres are poured at YOUNG
RESTITUTION = 0.725             # what normalDamping = 0.1 gives
GRAVITY = (0, 0, -9.81)
POURING_STEP, STEP = 0.2, 0.1   # time step over the critical one
MAX_TIME = 3.0                  # s until a bed must rest
SEED = 1

Kind = namedtuple('Kind', 'proportions n1 n2 law')
KINDS = {
    'cube': Kind((1, 1, 1), 8, 8, 'curvature'),
    'cylinder': Kind((1, 1, 1), 8, 2, 'curvature'),
    'odd': Kind((1, 1, 1), 3.3, 5.7, 'curvature'),
    'ellipsoid': Kind((1, 0.8, 0.6), 2, 2, 'curvature'),
    'sphere': Kind((1, 1, 1), 2, 2, 'curvature'),
    'yadeSphere': Kind((1, 1, 1), 2, 2, 'mindlin'),
}


class Bed(namedtuple('Bed', 'positions orientations velocities spins momenta facts')):
    """Particles at rest: positions (N, 3) [m], orientations (N, 4) as w, x, y, z, velocities (N, 3) [m/s], angular velocities
    (N, 3) [rad/s], angular momenta (N, 3) [kg m2/s]; `facts`: how it was made, plain values."""

    __slots__ = ()
    ARRAYS = ('positions', 'orientations', 'velocities', 'spins', 'momenta')

    @classmethod
    def ofScene(cls, ids, facts):
        states = [O.bodies[i].state for i in ids]
        return cls(np.array([tuple(s.pos) for s in states]),
                   np.array([(s.ori[3], s.ori[0], s.ori[1], s.ori[2]) for s in states]),
                   np.array([tuple(s.vel) for s in states]), np.array([tuple(s.angVel) for s in states]),
                   np.array([tuple(s.angMom) for s in states]), facts)

    @classmethod
    def load(cls, path):
        with np.load(path) as stored:
            return cls(*(stored[name] for name in cls.ARRAYS), json.loads(str(stored['facts'])))

    def save(self, path):
        """Write the file, whole or not at all: another benchmark may be looking for it."""
        unfinished = Path(path).with_suffix(f'.{os.getpid()}.npz')
        np.savez_compressed(unfinished, facts=json.dumps(self.facts), **{name: getattr(self, name) for name in self.ARRAYS})
        unfinished.replace(path)


def particleShape(kind):
    """The kind's `ParticleShape`."""
    kind = KINDS[kind]
    proportions = np.array(kind.proportions)
    unit = sq.ParticleShape(tuple(proportions), kind.n1, kind.n2, False).volume
    size = RADIUS * (4 / 3 * math.pi / unit) ** (1 / 3)
    return sq.ParticleShape(tuple(size * proportions), kind.n1, kind.n2, kind.law == 'mindlin')


def curvatureMaterial(young=YOUNG):
    return CurvatureMat(young=young, poisson=POISSON, density=DENSITY, frictionAngle=math.atan(FRICTION), normalDamping=0.1,
                        tangentialDamping=0.1, rollingFriction=0.002)


def material(kind, young=YOUNG):
    """The material of a kind's particles and walls, not yet in the scene."""
    if KINDS[kind].law == 'curvature':
        return curvatureMaterial(young)
    return FrictMat(young=young, poisson=POISSON, density=DENSITY, frictionAngle=math.atan(FRICTION))


def engines(kind):
    """The engines of a kind; for YADE's own spheres those that its users write, with its defaults."""
    if KINDS[kind].law == 'curvature':
        return sq.superquadricEngines(gravity=GRAVITY)
    return [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                        [Ip2_FrictMat_FrictMat_MindlinPhys(en=RESTITUTION)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
        NewtonIntegrator(gravity=GRAVITY, damping=0),
    ]


def timeStep(kind, fraction, young=YOUNG):
    """`fraction` of the critical time step (14) [s]."""
    return fraction * curvatureMaterial(young).criticalTimeStep(min(particleShape(kind).extents))


def pour(kind, count):
    """Pour a bed in the empty scene and let it come to rest.

    :returns: `Bed`; its facts hold the steps done, whether it rests, its kinetic energy per particle over m g d, and
        what the contact solver met (of superquadrics)
    """
    softening = SOFTENING if KINDS[kind].law == 'curvature' else 1.0
    common = O.materials[O.materials.append(material(kind, YOUNG / softening))]
    container = box(count, common)
    ids, container = sq.rainFilling([particleShape(kind)] * count, container, common, seed=SEED)
    O.engines = engines(kind)
    O.dt = timeStep(kind, POURING_STEP, YOUNG / softening)
    stepper, walls = sq.Stepper(stream=None), wallIds(container)
    rests = sq.settle(stepper, sq.RestCriterion(ids, walls), MAX_TIME)
    if softening != 1:
        sq.stiffen(stepper, softening, STEP)
        criterion = sq.RestCriterion(ids, walls, settlingrules.TRUE_QUIET, settlingrules.TRUE_SUPPORT)
        rests = sq.settle(stepper, criterion, MAX_TIME) and rests
    facts = {'kind': kind, 'count': count, 'steps': O.iter, 'rests': rests, 'seconds': stepper.seconds,
             'kineticEnergy': sq.RestCriterion(ids, walls).kineticEnergy(), 'contacts': O.interactions.countReal(),
             'solver': sq.solverCounters() if KINDS[kind].law == 'curvature' else None}
    return Bed.ofScene(ids, facts)


def place(kind, bed):
    """Put a bed with its box and engines into the empty scene; return the particles' ids and the walls' ids."""
    common = O.materials[O.materials.append(material(kind))]
    container = box(len(bed.positions), common)
    shape = particleShape(kind)
    ids = addBodies(bed, lambda position, orientation: shape.body(position, orientation, common))
    O.engines = engines(kind)
    O.dt = timeStep(kind, STEP)
    return ids, wallIds(container)


def box(count, common):
    """Put the walls for `count` particles, of the material `common`, into the scene; return the `Container`."""
    width = WIDTH if count >= SMALL else SMALL_WIDTH
    return sq.boxContainer(width, width, 10 * width, common)


def wallIds(container):
    return [container.baseId, *container.sideIds]


def addBodies(bed, makeBody):
    """Append a body of `makeBody(position, orientation)` for every particle of the bed, moving as it did; return their ids."""
    ids = []
    for position, orientation, velocity, spin, momentum in zip(*bed[:5]):
        body = makeBody(Vector3(*position), Quaternion(*orientation))
        body.state.vel, body.state.angVel, body.state.angMom = Vector3(*velocity), Vector3(*spin), Vector3(*momentum)
        ids.append(O.bodies.append(body))
    return ids
