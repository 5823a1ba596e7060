"""A bed of YADE's own non-spherical particles, level sets, of the cubes' shape and in their places.

As in YADE's example examples/levelSet/discharge.py: 2,000 surface nodes a particle, 20 grid cells across, linear springs. The stiffness
is chosen for overlaps of the size that the other beds have. The bed then comes to rest anew: with this resolution the surfaces are not
quite where they were.
"""
import math

import beds
from bedcache import bedFile
from yade import O, utils
from yade import superquadric as sq
from yade.config import features
from yade.wrapper import (
    Bo1_Wall_Aabb,
    ForceResetter,
    FrictMat,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_FrictMat_FrictMat_FrictPhys,
    Law2_ScGeom_FrictPhys_CundallStrack,
    MatchMaker,
    NewtonIntegrator,
)

NODES, CELLS = 2000, 20
STIFFNESS = 1e4   # N/m
DAMPING = 0.3     # the example's, YADE's non-viscous one: the linear springs of its law have none
STEP = 0.1        # time step over sqrt(m/k)
MAX_STEPS = 1500  # until it must rest; a step takes 0.3 ms a particle


def pour(count):
    """Put the bed of `count` cubes as level sets into the empty scene and let it come to rest; return a `Bed`."""
    ids, walls = place(beds.Bed.load(bedFile('cube', count)))
    stepper, criterion = sq.Stepper(stream=None), sq.RestCriterion(ids, walls)
    rests = sq.settle(stepper, criterion, MAX_STEPS * O.dt)
    facts = {'kind': 'levelSet', 'count': count, 'steps': O.iter, 'rests': rests, 'seconds': stepper.seconds,
             'kineticEnergy': criterion.kineticEnergy(), 'contacts': O.interactions.countReal()}
    return beds.Bed.ofScene(ids, facts)


def place(bed):
    """Put the bed as level sets into the empty scene; return the particles' ids and the walls' ids."""
    if 'LS_DEM' not in features:
        raise RuntimeError('this YADE has no level sets (feature LS_DEM)')
    from yade.wrapper import Bo1_LevelSet_Aabb, Ig2_LevelSet_LevelSet_ScGeom, Ig2_Wall_LevelSet_ScGeom
    common = O.materials[O.materials.append(FrictMat(density=beds.DENSITY, frictionAngle=math.atan(beds.FRICTION)))]
    container = beds.box(len(bed.positions), common)
    for wall in beds.wallIds(container):
        O.bodies[wall].shape.sense = 0  # level sets know walls with two sides only
    make = _maker(beds.particleShape('cube'), common)
    ids = beds.addBodies(bed, make)
    springs = Ip2_FrictMat_FrictMat_FrictPhys(kn=MatchMaker(algo='val', val=STIFFNESS), ks=MatchMaker(algo='val', val=0.7 * STIFFNESS))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_LevelSet_Aabb(), Bo1_Wall_Aabb()], verletDist=0),
        InteractionLoop([Ig2_LevelSet_LevelSet_ScGeom(), Ig2_Wall_LevelSet_ScGeom()], [springs],
                        [Law2_ScGeom_FrictPhys_CundallStrack(sphericalBodies=False)]),
        NewtonIntegrator(gravity=beds.GRAVITY, damping=DAMPING),
    ]
    O.dt = STEP * math.sqrt(O.bodies[ids[0]].state.mass / STIFFNESS)
    return ids, beds.wallIds(container)


def _maker(shape, common):
    """makeBody(position, orientation); all bodies share the grid and the distances of the first."""
    # YADE's exponents are 2/n, that in the x-y plane first.
    first = utils.levelSetBody('superellipsoid', extents=shape.extents, epsilons=(2 / shape.n2, 2 / shape.n1),
                               spacing=2 * min(shape.extents) / CELLS, nSurfNodes=2, nodesPath=2)
    grid, distances = first.shape.lsGrid, first.shape.distField
    return lambda position, orientation: utils.levelSetBody(
        center=position, orientation=orientation, grid=grid, distField=distances, nSurfNodes=NODES, nodesPath=2, material=common)
