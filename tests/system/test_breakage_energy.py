"""Total energy from before an event until its fragments have come apart: none is created. Many parents, each squeezed between neighbours by overlaps of
contacts that push and slide, all at once and far from each other; nothing dissipates but breakage, so that every joule shows.

What rounding and the time step may do is measured by the same clusters without breakage.
"""
import random

import numpy as np
import pytest
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import BreakageEngine, Superquadric

import yade.superquadric as sq

from breakagescene import RADIUS, Motion, material, singleThread

CLUSTERS = 60
OVERLAP = 0.01         # of the parent with its neighbours, over RADIUS, at most
STEP = 0.02            # over the critical one of the smallest fragment: what the integration creates shrinks with it
SMALLEST = 0.4 * RADIUS
STEPS = 4000           # until fragments and neighbours have left each other
ROUNDING = 1e-12       # of the event itself, relative
INTEGRATION = 1e-4     # what the time step adds in the course of spheres, over the energy; the same without breakage
CURVATURE = 0.05       # of superquadrics, whose law has no potential and books what that costs as 'nonconservative'


def cluster(index, shape, mat, rng):
    """A spinning parent with six neighbours that press on it along its axes; the ids, the parent's first."""
    centre = Vector3(index % 8, index // 8, 0) * 0.1
    turn = sq.randomOrientation(rng)
    bodies = [shape.body(centre, turn, mat)]
    for axis in range(3):
        for side in (-1, 1):
            size = rng.uniform(0.6, 1) * RADIUS
            place = Vector3.Zero
            place[axis] = side * (shape.extents[axis] + size - rng.uniform(0, OVERLAP) * RADIUS)
            bodies.append(sq.particleShape('sphere', size).body(centre + turn * place, turn, mat))
    for body in bodies:
        body.state.vel = Vector3(*(rng.gauss(0, 0.1) for _ in range(3)))
    bodies[0].state.angVel = Vector3(*(rng.gauss(0, 100) for _ in range(3)))
    return [O.bodies.append(body) for body in bodies]


def clusters(kind, frictionAngle, **attributes):
    O.reset()
    rng = random.Random(7)
    mat = material(characteristicStrength=1e30, frictionAngle=frictionAngle)
    shape = sq.particleShape('sphere', RADIUS) if kind == 'spheres' else sq.ParticleShape((RADIUS, 1.2 * RADIUS, 0.9 * RADIUS), 6, 6, False)
    groups = [cluster(i, shape, mat, rng) for i in range(CLUSTERS)]
    O.trackEnergy = True
    engine = BreakageEngine(seed=3, smallestFragment=SMALLEST, **attributes)
    O.engines = [engine, *sq.superquadricEngines(gravity=(0, 0, 0))]
    singleThread()
    O.dt = STEP * mat.criticalTimeStep(SMALLEST / 2)
    return engine, groups


def energies(groups):
    """Kinetic and stored energy [J] of each cluster."""
    owner = {i: k for k, group in enumerate(groups) for i in group}
    sums = np.zeros(CLUSTERS)
    for body in O.bodies:
        owner.setdefault(body.id, owner.get(body.state.ancestor))
        sums[owner[body.id]] += Motion([body.id]).kinetic
    for interaction in O.interactions:
        sums[owner[interaction.id1]] += interaction.phys.storedEnergy()
    return sums


class Course:
    """Energies of the clusters [J]: `before` the event, just `after` it, and in its `course` until the end, an array (times, clusters); what the engine says to
    have taken out, `losses`; and how O.energy has changed, `booked`."""

    def __init__(self, kind, frictionAngle=0.0, breaks=True, **attributes):
        engine, groups = clusters(kind, frictionAngle, **attributes)
        O.run(20, True)
        self.before = energies(groups)
        booked = O.energy.total()
        if breaks:
            engine.forced = [group[0] for group in groups]
        O.run(1, True)
        self.after, rows = energies(groups), []
        for _ in range(10):
            O.run(STEPS // 10, True)
            rows.append(energies(groups))
        self.course = np.array(rows)
        self.losses = np.array([event['elasticLoss'] + event['spinLoss'] for event in engine.events()]) if breaks else np.zeros(CLUSTERS)
        self.booked = (O.energy.total() - booked) / booked
        self.sinks = dict(O.energy.items())


@pytest.mark.parametrize('kind, attributes', [('spheres', {}), ('spheres', {'mode': 'balls4'}), ('spheres', {'mode': 'balls18'}), ('blocks', {})])
def test_noEnergyIsCreated(kind, attributes):
    with_, without = Course(kind, **attributes), Course(kind, breaks=False, **attributes)
    atOnce = with_.after + with_.losses - with_.before
    gain = (with_.course - with_.after).max(axis=0) / with_.before
    lost = (with_.course - with_.after).min(axis=0) / with_.before
    print(kind, attributes, 'loss', np.percentile(with_.losses / with_.before, [0, 50, 100]), 'at once', np.abs(atOnce / with_.before).max(),
       'gain', np.percentile(gain, [0, 50, 95, 100]), 'lost', np.percentile(lost, [0, 5, 50]), 'without',
       np.percentile((without.course-without.after).max(axis=0)/without.before, [50, 95, 100]), np.percentile((without.course-without.after).min(axis=0)/without.before, [0,5,50]), 'booked', with_.booked, without.booked, with_.sinks)
