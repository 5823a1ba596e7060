"""Particles that break, and what is measured of them: the tests of breakage share it."""
import random

import numpy as np
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import BreakableMat, BreakageEngine, InsertionSortCollider, InteractionLoop

import yade.superquadric as sq

RADIUS = 5e-3
NOTHING_MOVES = 1e-30  # a time step, below the critical one of the smallest fragments [s]
GLASS = dict(young=1e8, poisson=0.2, density=2500, frictionAngle=0.4, characteristicStrength=2e5, referenceSize=2 * RADIUS, weibullModulus=3)


def material(**others):
    return BreakableMat(**{**GLASS, **others})


def singleThread():
    for engine in O.engines:
        if isinstance(engine, (InteractionLoop, InsertionSortCollider)):
            engine.ompThreads = 1


class Motion:
    """Mass [kg], first moment [kg m], momentum [kg m/s], angular momentum about the origin [kg m2/s] and kinetic energy [J] of bodies."""

    def __init__(self, ids):
        self.mass, self.kinetic = 0.0, 0.0
        self.moment, self.momentum, self.angular = (np.zeros(3) for _ in range(3))
        for state in (O.bodies[i].state for i in ids):
            position, velocity, spin = (np.array(vector) for vector in (state.pos, state.vel, state.angVel))
            turn = np.array(state.ori.toRotationMatrix()).reshape(3, 3)
            own = turn @ (np.array(state.inertia) * (turn.T @ spin))
            self.mass += state.mass
            self.moment += state.mass * position
            self.momentum += state.mass * velocity
            self.angular += state.mass * np.cross(position, velocity) + own
            self.kinetic += (state.mass * velocity @ velocity + own @ spin) / 2


def scatter(shapes, mat, seed, spacing=0.03):
    """Moving, spinning particles on a grid that do not touch each other; their ids."""
    rng = random.Random(seed)
    side = int(np.ceil(len(shapes) ** (1 / 3)))
    ids = []
    for i, shape in enumerate(shapes):
        place = Vector3(i % side, i // side % side, i // side ** 2) * spacing
        body = shape.body(place, sq.randomOrientation(rng), mat)
        body.state.vel = Vector3(*(rng.gauss(0, 2) for _ in range(3)))
        body.state.angVel = Vector3(*(rng.gauss(0, 300) for _ in range(3)))
        ids.append(O.bodies.append(body))
    return ids


def randomShape(rng):
    """A superquadric with half sizes around RADIUS."""
    extents = [RADIUS * rng.uniform(0.5, 2) for _ in range(3)]
    return sq.ParticleShape(tuple(extents), rng.uniform(2, 12), rng.uniform(2, 12), False)


def breakAll(ids, **attributes):
    """Break the particles in one step in which nothing else happens; the engine."""
    engine = BreakageEngine(forced=ids, **attributes)
    O.engines, O.dt = [engine], NOTHING_MOVES
    O.step()
    return engine
