"""Scenes of many pairs of bodies that collide far from all others, and what must be conserved in them.

YADE's integrator leaps: after a step velocities and spins belong to the middle of that step, positions and orientations
to its end. A free body keeps its velocity and its spin in its own frame over a step, so kinetic energy needs no
correction; for the angular momentum the orientation is turned back by half a step.
"""
import math
import random

from yade import O
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq

MEAN_SIZE = 5e-3  # [m]
GAP = 1e-6  # between the bodies of a pair at the start [m]
SMOOTH = dict(young=1e9, poisson=0.2, density=2500, frictionAngle=0)  # neither friction nor damping


class Pair:
    """Ids of two bodies at rest as a whole, and the kinetic energy [J] they start with."""

    def __init__(self, id1, id2):
        self.ids = id1, id2
        self.initialEnergy = self.kineticEnergy()

    def states(self):
        return [O.bodies[i].state for i in self.ids]

    def kineticEnergy(self):
        return sum(kineticEnergy(state) for state in self.states())

    def momentum(self):
        """Sum of m v, and the sum of its parts' magnitudes [kg m/s]."""
        parts = [state.mass * state.vel for state in self.states()]
        return parts[0] + parts[1], sum(part.norm() for part in parts)

    def angularMomentum(self):
        """About the first body's reference position, and the sum of its parts' magnitudes [kg m2/s]."""
        parts = []
        for state in self.states():
            parts += [state.mass * (state.pos - self.states()[0].refPos).cross(state.vel), spinMomentum(state)]
        return sum(parts, Vector3.Zero), sum(part.norm() for part in parts)


def kineticEnergy(state):
    spin = state.ori.conjugate() * state.angVel
    return (state.mass * state.vel.squaredNorm() + sum(i * w * w for i, w in zip(state.inertia, spin))) / 2


def spinMomentum(state):
    """Angular momentum of a body about its centre in the middle of the last step [kg m2/s]."""
    speed = state.angVel.norm()
    back = Quaternion(state.angVel / speed, -speed * O.dt / 2) if speed > 0 else Quaternion.Identity
    orientation = back * state.ori
    spin = orientation.conjugate() * state.angVel
    return orientation * Vector3(*(i * w for i, w in zip(state.inertia, spin)))


def randomShape(generator):
    """Half sizes [m] within a factor of 2 of the mean and of aspect up to 2.5, exponents in [2, 20]."""
    size = MEAN_SIZE * 2 ** generator.uniform(-1, 1)
    extents = [size * 2.5 ** generator.uniform(-0.5, 0.5) for _ in range(3)]
    return extents, generator.uniform(2, 20), generator.uniform(2, 20)


def randomEllipsoid(generator):
    extents, _, _ = randomShape(generator)
    return extents, 2, 2


def randomSphere(generator):
    return [MEAN_SIZE * 2 ** generator.uniform(-1, 1)] * 3, 2, 2


def randomDirection(generator):
    return sq.randomOrientation(generator) * Vector3(0, 0, 1)


def addPair(corner, shapes, material, speed, spin, generator):
    """A pair about `corner` that is about to collide obliquely, with its centre of mass at rest.

    The surface point of each body that lies farthest along a random direction, for the second body against it, faces the
    other's across a narrow gap. A plane between the two proves that the bodies do not overlap.
    """
    bodies = [sq.superquadric(corner, *shape, material=material, orientation=sq.randomOrientation(generator))
              for shape in shapes]
    along = randomDirection(generator)
    farthest = [farthestPoint(body, direction) for body, direction in zip(bodies, (along, -along))]
    bodies[1].state.pos = bodies[1].state.refPos = corner + farthest[0] - farthest[1] + GAP * along
    approach = speed * (along + generator.random() * randomDirection(generator).cross(along))
    masses = [body.state.mass for body in bodies]
    bodies[0].state.vel = masses[1] / sum(masses) * approach
    bodies[1].state.vel = -masses[0] / sum(masses) * approach
    for body in bodies:
        body.state.angVel = spin * randomDirection(generator)
    return Pair(*O.bodies.append(bodies))


def farthestPoint(body, direction):
    """From the body's centre [m]."""
    return body.state.ori * body.shape.supportPoint(body.state.ori.conjugate() * direction)


def makePairs(number, seed, timeStepFraction, randomShape=randomShape, material=lambda generator: {},
              speed=(0.2, 2), spin=20, kind=CurvatureMat):
    """A new scene of `number` pairs on a wide grid, ready to step.

    :param timeStepFraction: time step over the critical one (14)
    :param randomShape: called with the generator, gives half sizes and exponents of a body
    :param material: called with the generator, gives attributes of the pair's material other than SMOOTH's
    :param kind: class of the material
    :param speed: range of the speed of approach [m/s]
    :param spin: of every body at the start [rad/s]
    :returns: list of `Pair`
    """
    O.reset()
    generator = random.Random(seed)
    columns = math.ceil(number ** (1 / 3))
    pairs = []
    for i in range(number):
        corner = 40 * MEAN_SIZE * Vector3(i % columns, i // columns % columns, i // columns ** 2)
        ownMaterial = kind(**dict(SMOOTH, **material(generator)))
        shapes = [randomShape(generator), randomShape(generator)]
        pairs.append(addPair(corner, shapes, ownMaterial, generator.uniform(*speed), spin, generator))
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0), verletDist=MEAN_SIZE)
    # YADE's default, every 5,000 steps, lets the rounding of the quaternion's norm scale the spin, by 1e-9 in the end.
    O.engines[-1].normalizeEvery = 1
    O.dt = timeStepFraction * sq.criticalTimeStep()
    return pairs


def collide(pairs, duration, everyStep=lambda touching: None):
    """Step for `duration` [s], and on until no pair is in contact.

    :param everyStep: called after each step with a dict of the contacts by their ids
    :returns: set of the pairs that have been in contact
    """
    met, touching = set(), {}
    byIds = {pair.ids: pair for pair in pairs}
    end = O.time + duration
    while O.time < end or touching:
        O.step()
        touching = {(i.id1, i.id2): i for i in O.interactions}
        met.update(touching)
        everyStep(touching)
        assert O.time < 20 * end, f'{len(touching)} pairs do not part'
    return {byIds[ids] for ids in met}
