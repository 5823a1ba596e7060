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
OVERLAP = 0.01      # of the parent with its neighbours, over its half size, at most
STEP = 0.02         # over the critical one: what is created by the integration shrinks with it
STEPS = 1500        # until the fragments have left each other
INTEGRATION = 2e-3  # error of the energy by the time step in the same clusters without breakage, over the energy: largest seen 6e-4
CURVATURE = 0.1     # the same of superquadrics, whose law has no potential: 4 % are seen without breakage


def cluster(index, shape, mat, rng):
    """A spinning parent with six neighbours that press on it along its axes; its id and all ids."""
    centre = Vector3(index % 8, index // 8, 0) * 0.1
    turn = sq.randomOrientation(rng)
    parent = shape.body(centre, turn, mat)
    parent.state.vel = Vector3(*(rng.gauss(0, 0.2) for _ in range(3)))
    parent.state.angVel = Vector3(*(rng.gauss(0, 30) for _ in range(3)))
    ids = [O.bodies.append(parent)]
    for axis in range(3):
        for side in (-1, 1):
            way = shape.extents[axis] + rng.uniform(0.6, 1) * RADIUS * (1 - 0.0)
            size = way - shape.extents[axis]
            place = Vector3.Zero
            place[axis] = side * (way - rng.uniform(0, OVERLAP) * RADIUS)
            neighbour = sq.particleShape('sphere', size).body(centre + turn * place, turn, mat)
            neighbour.state.vel = parent.state.vel
            ids.append(O.bodies.append(neighbour))
    return ids


def clusters(kind, **attributes):
    O.reset()
    rng = random.Random(7)
    mat = material(characteristicStrength=1e30)
    shape = sq.particleShape('sphere', RADIUS) if kind == 'spheres' else sq.ParticleShape((RADIUS, 1.2 * RADIUS, 0.9 * RADIUS), 6, 6, False)
    groups = [cluster(i, shape, mat, rng) for i in range(CLUSTERS)]
    O.trackEnergy = True
    engine = BreakageEngine(seed=3, **attributes)
    O.engines = [engine, *sq.superquadricEngines(gravity=(0, 0, 0))]
    singleThread()
    O.dt = STEP * sq.criticalTimeStep()
    return engine, groups


class Energies:
    """Kinetic and stored energy [J] of each cluster; velocities of half a step ago and ahead are averaged by the caller's small steps."""

    def __init__(self, groups):
        self.owner = {i: k for k, group in enumerate(groups) for i in group}

    def total(self):
        sums = np.zeros(CLUSTERS)
        for body in O.bodies:
            self.owner.setdefault(body.id, self.owner.get(getattr(body.state, 'ancestor', None)))
            sums[self.owner[body.id]] += Motion([body.id]).kinetic
        for interaction in O.interactions:
            sums[self.owner[interaction.id1]] += interaction.phys.storedEnergy()
        return sums


def course(kind, breaks, steps=STEPS, **attributes):
    """Energies of the clusters before the event, just after, and from time to time until the end: an array (times, clusters) [J]; and what the engine
    says to have taken out of each."""
    engine, groups = clusters(kind, **attributes)
    energies = Energies(groups)
    O.run(20, True)
    rows = [energies.total()]
    if breaks:
        engine.forced = [group[0] for group in groups]
    O.run(1, True)
    for _ in range(10):
        rows.append(energies.total())
        O.run(steps // 10, True)
    rows.append(energies.total())
    losses = np.array([event['elasticLoss'] + event['spinLoss'] for event in engine.events()]) if breaks else np.zeros(CLUSTERS)
    return np.array(rows), losses


@pytest.mark.parametrize('kind, attributes', [('spheres', {}), ('spheres', {'mode': 'balls4'}), ('spheres', {'mode': 'balls18'}), ('blocks', {})])
def test_noEnergyIsCreated(kind, attributes):
    rows, losses = course(kind, breaks=True, **attributes)
    before = rows[0]
    after = rows[1:] + losses - before
    still = course(kind, breaks=False, **attributes)[0]
    drift = np.abs(still - still[0]).max(axis=0) / still[0]
    gain = after.max(axis=0) / before
    print(kind, attributes, 'loss', np.percentile(losses / before, [0, 50, 100]), 'gain', np.percentile(gain, [0, 50, 95, 100]),
          'lowest', (after.min(axis=0) / before).min(), 'without', np.percentile(drift, [50, 95, 100]))
