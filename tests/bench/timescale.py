"""Time and memory of a large bed: [mpirun -np N] yade -n -x -jT timescale.py TILES_X TILES_Y --output FILE [...]. The driver is `scaling`.

The bed is the settled one of 1,000 cubes (beds.py), put side by side TILES_X times TILES_Y, with one box around all; where the walls between the
tiles were, the cubes then find new neighbours while the run warms up. Writes a JSON file: seconds of each block of steps (wall clock), contacts and
candidate pairs, the memory of this process before the bodies, with them, and after the run, how quiet the bed was.
"""
import argparse
import json
import sys
import time

import beds
import numpy as np
from bedcache import bedFile
from yade import O
from yade import superquadric as sq

from yade.superquadric.scene import parallel

TILE = 'cube', 1000


def memory():
    """Resident memory of this process [bytes]."""
    with open('/proc/self/status') as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith('VmRSS'))


def tiled(bed, tilesX, tilesY):
    """The bed side by side, centred about the z axis."""
    count = tilesX * tilesY
    shifts = np.array([((i - (tilesX - 1) / 2) * beds.WIDTH, (k - (tilesY - 1) / 2) * beds.WIDTH, 0) for i in range(tilesX) for k in range(tilesY)])
    arrays = {name: np.tile(getattr(bed, name), (count, 1)) for name in bed.ARRAYS}
    arrays['positions'] += np.repeat(shifts, len(bed.positions), axis=0)
    return beds.Bed(**arrays, facts=bed.facts)


def place(tilesX, tilesY):
    """Put bed, box and engines into the scene; return the ids of the particles and of the base."""
    material = O.materials[O.materials.append(beds.material(TILE[0]))]
    container = sq.boxContainer(tilesX * beds.WIDTH, tilesY * beds.WIDTH, 10 * beds.WIDTH, material)
    shape = beds.particleShape(TILE[0])
    bed = tiled(beds.Bed.load(bedFile(*TILE)), tilesX, tilesY)
    ids = beds.addBodies(bed, lambda position, orientation: shape.body(position, orientation, material))
    O.engines, O.dt = beds.engines(TILE[0]), beds.timeStep(TILE[0], beds.STEP)
    return ids, beds.wallIds(container)


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument('tilesX', type=int)
    parser.add_argument('tilesY', type=int)
    parser.add_argument('--output', required=True)
    parser.add_argument('--warmup', type=int, default=200)
    parser.add_argument('--blocks', type=int, default=3)
    parser.add_argument('--steps', type=int, default=100)
    return parser.parse_args(sys.argv[1:])


def seconds(steps):
    begin = time.perf_counter()
    parallel.run(steps)
    return time.perf_counter() - begin


def main(options):
    first, ids = parallel.rank() == 0, []
    result = {'memory': [memory()]}
    if first:
        ids, walls = place(options.tilesX, options.tilesY)
        result['memory'].append(memory())
    parallel.run(options.warmup)
    result['wall'] = [seconds(options.steps) for _ in range(options.blocks)]
    result['memory'].append(memory())
    if parallel.ranks() == 1:
        result |= {'contacts': O.interactions.countReal(), 'pairs': len(O.interactions),
                   'kineticEnergy': sq.RestCriterion(ids, walls).kineticEnergy()}
    if first:
        with open(options.output, 'w') as out:
            json.dump({'count': len(ids), 'steps': options.steps, **result}, out)


main(arguments())
