"""A scene for test_mpi.py, run by every rank: [mpirun -np N] yade -n -x -j1 parallelscene.py SCENE DIVISION STEPS OUTPUT.

SCENE: bed, yielding, mesh or clump. DIVISION: domains (as `parallel.distribute` cuts them), or scattered: particles are dealt out in turn, so
that nearly every contact crosses a border, and then go to where they belong while the scene runs. Rank 0 writes what came out as JSON.
"""
import json
import math
import random
import sys

from yade import O, utils
from yade import superquadric as sq
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat

from yade.superquadric.scene import parallel

ALONE = 600   # steps that rank 0 does before the scene is cut, so that there are contacts at the borders and walls then
SIZE = 4.5e-3  # radius of the sphere of a particle's volume [m]


def elastic(friction=0.4):
    return CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=math.atan(friction), normalDamping=0.05, tangentialDamping=0.1,
                        rollingFriction=0.002)


def bed(material):
    """Cubes, cylinders and spheres close above each other in a cylinder, thrown onto its base; its id is returned."""
    generator = random.Random(3)
    container = sq.cylinderContainer(0.03, 0.2, material)
    kinds = [sq.particleShape(name, SIZE) for name in ('cube', 'cylinder', 'sphere')]
    spacing = 2.7 * SIZE
    for i in range(64):
        place = Vector3(i % 4 - 1.5, i // 4 % 4 - 1.5, 0.75 + i // 16) * spacing
        if math.hypot(place[0], place[1]) > 0.022:
            continue
        body = kinds[i % 3].body(place, sq.randomOrientation(generator), material)
        body.state.vel = Vector3(generator.uniform(-1, 1), generator.uniform(-1, 1), -1)
        O.bodies.append(body)
    return [container.baseId]


def mesh(material):
    """Cubes that slide along a floor of triangles: on each rank these come and go."""
    cell = 4e-3
    x, y = Vector3(cell, 0, 0), Vector3(0, cell, 0)
    floor = []
    for i in range(40):
        for k in range(6):
            corner = i * x + (k - 3) * y
            floor += [O.bodies.append(utils.facet(triangle, material=material))
                      for triangle in ((corner, corner + x, corner + y), (corner + x + y, corner + y, corner + x))]
    for i in range(4):
        O.bodies.append(sq.superquadric((0.012 + 0.02 * i, 0.3e-3, 5e-3 - 1e-5), (5e-3,) * 3, 8, 8, material=material))
        O.bodies[-1].state.vel = Vector3(4, 0, 0)
    return floor


def clump(material):
    """What cannot be cut."""
    O.bodies.appendClumped([sq.superquadric((x, 0, 0), (5e-3,) * 3, 8, 8, material=material) for x in (0, 0.01)])
    return []


SCENES = {'bed': lambda: bed(elastic()),
          'yielding': lambda: bed(sq.elastoplasticMat('aluminium-2024-T351', young=1e7, yieldStress=1e4, density=2500, frictionAngle=0.4,
                                                      normalDamping=0.05)),
          'mesh': lambda: mesh(elastic(friction=0.05)), 'clump': lambda: clump(elastic())}


def contacts():
    """How many contacts there are, and what they remember: sums over all of them."""
    real = [contact for contact in O.interactions if contact.isReal]
    return {'number': len(real), 'shearDisplacement': sum(contact.phys.shearDisplacement.norm() for contact in real),
            'plasticDissipation': sum(getattr(contact.phys, 'plasticDissipation', 0) for contact in real)}


scene, division, steps, output = sys.argv[1:]
supports = []
if parallel.rank() == 0:
    supports = SCENES[scene]()
    O.engines = sq.superquadricEngines()
    O.dt = 0.05 * sq.criticalTimeStep()
    O.trackEnergy = True
    if scene != 'clump':
        O.run(ALONE, wait=True)
if division == 'scattered':
    def scatter(places, domains):
        for i, (_, number) in enumerate(places):
            O.bodies[number].subdomain = domains[i % len(domains)]

    parallel._bisect = scatter
totals = parallel.Totals(supports, every=int(steps) // 10)
parallel.run(int(steps), rebalanceEvery=1 if division == 'scattered' else 0)
mine = sorted(body.id for body in O.bodies if body.subdomain == parallel.rank() and body.dynamic and not body.isSubdomain)
held = parallel._mpy().comm.gather(mine, root=0)
parallel.merge(forGood=True)
if parallel.rank() == 0:
    remembered = contacts()
    O.run(50, wait=True)  # rank 0 goes on alone
    totals.record()
    with open(output, 'w') as out:
        json.dump({'rows': totals.rows, 'contacts': remembered, 'held': held}, out)
