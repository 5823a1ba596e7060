"""A bed of cubes on one or several processes: at rest, or hit by a sphere. The same command with other ranks gives the same bed and blow.

    tools/env yade -n -x -j1 scripts/parallel_bed.py --bed results/bed.yade.gz                       # one process
    tools/env mpirun -np 3 yade -n -x -j1 scripts/parallel_bed.py --bed results/bed.yade.gz --speed 3  # walls on rank 0, two domains

The bed is poured and brought to rest on rank 0 and kept in the file of --bed, if it is not there yet (1,000 cubes: two minutes). Prints the totals
over all ranks; --output writes them as CSV. See docs/scaling.md.
"""
import argparse
import math
import os
import sys
import time

from yade import O
from yade import superquadric as sq
from yade.wrapper import CurvatureMat, Superquadric, Wall

from yade.superquadric import checks
from yade.superquadric.experiments.impact import impactor
from yade.superquadric.files import results
from yade.superquadric.runs.commandline import BAD_INPUT
from yade.superquadric.scene import parallel

FAILED = 1                   # exit code beside those of all scripts
RADIUS = 5e-3                # of the sphere of a cube's volume [m]
IMPACTOR = 0.04, 7800.0      # diameter [m], density [kg/m3]
COLUMNS = ('time', 'bodies', 'momentumX', 'momentumY', 'momentumZ', 'forceX', 'forceY', 'forceZ')
ENERGIES = ('kinetic', 'elastPotential', 'gravWork', 'plastDissip', 'normDampDissip', 'shearDampDissip', 'rollingDissip', 'nonconservative')


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bed', required=True, help='file of the bed, .yade.gz; made if it is not there')
    parser.add_argument('--count', type=int, default=1000, help='cubes of a bed that is poured (default 1000)')
    parser.add_argument('--seed', type=int, default=1, help='of a bed that is poured (default 1)')
    parser.add_argument('--speed', type=float, default=0.0, help="the sphere's at the surface of the bed [m/s]; 0: no sphere (default)")
    parser.add_argument('--steps', type=int, default=10000, help='time steps (default 10000)')
    parser.add_argument('--every', type=int, default=10, help='steps from one record to the next (default 10)')
    parser.add_argument('--rebalance', type=int, default=0, help='runs of the collider until bodies change their rank (default 0: never)')
    parser.add_argument('--output', help='CSV file of the records')
    given = parser.parse_args(sys.argv[1:])
    checks.notNegative('speed', given.speed)
    for name, least in (('count', 1), ('steps', 1), ('every', 1), ('rebalance', 0)):
        checks.wholeNumber(name, getattr(given, name), least)
    if given.every > given.steps:
        raise ValueError(f'every = {given.every}: must not be above steps = {given.steps}; there would be no record')
    for path in filter(None, (given.bed, given.output)):
        os.makedirs(os.path.dirname(path) or '.', exist_ok=True)
    return given


def pour(count, seed, path):
    """Cubes at rest in a box as wide as it takes for a bed about as deep as wide; kept in the file `path`."""
    material = O.materials[O.materials.append(CurvatureMat(young=1e8, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                                                           tangentialDamping=0.1, rollingFriction=0.002))]
    cube = sq.particleShape('cube', RADIUS)
    width = 1.2 * (count * cube.volume / 0.6) ** (1 / 3)
    container = sq.boxContainer(width, width, 10 * width, material, cube.boundingRadius)
    cubes, container = sq.rainFilling([cube] * count, container, material, seed)
    O.engines, O.dt = sq.superquadricEngines(), 0.1 * sq.criticalTimeStep()
    with sq.Stepper() as stepper:
        stepper.begin('settling')
        if not sq.settle(stepper, sq.RestCriterion(cubes, [container.baseId, *container.sideIds]), maxTime=3.0):
            raise RuntimeError('the bed did not come to rest within 3 s')
    O.trackEnergy = True
    partial = f'{path}.part.gz'  # YADE takes the format from the name's end
    O.save(partial)
    os.replace(partial, path)


def load(given):
    """Put the bed, and the sphere above it, into the scene of rank 0; return the id of the base."""
    if not os.path.exists(given.bed):
        pour(given.count, given.seed, given.bed)
    O.load(given.bed)
    base = next((body for body in O.bodies if isinstance(body.shape, Wall) and body.shape.axis == 2), None)
    if base is None:
        raise ValueError(f'bed = {given.bed!r}: there is no bed in that file')
    cubes = [body.id for body in O.bodies if isinstance(body.shape, Superquadric)]
    if given.speed:
        surface = max(O.bodies[cube].state.pos[2] for cube in cubes)
        impactor.addImpactor(*IMPACTOR, base.mat, given.speed, 0.0, surface, cubes)
    return base.id


def row(record):
    return (record['time'], record['bodies'], *record['momentum'], *record['force'], *(record['energy'].get(name, 0) for name in ENERGIES))


def report(totals, seconds, steps):
    first, last = totals.rows[0], totals.rows[-1]
    total = {key: sum(record['energy'].values()) for key, record in (('first', first), ('last', last))}
    push = max(-record['force'][2] for record in totals.rows)
    print(f'ranks          {parallel.ranks()}, {last["bodies"]} particles, {steps} steps in {seconds:.1f} s: {1e3 * seconds / steps:.3f} ms a step')
    print('momentum       ({:.6e}, {:.6e}, {:.6e}) kg m/s'.format(*last['momentum']))
    print(f'kinetic energy {last["energy"]["kinetic"]:.6e} J')
    print(f'O.energy       {total["last"]:.6e} J, all entries together; at the first record {total["first"]:.6e} J')
    print(f'force on base  {-last["force"][2]:.6f} N, largest {push:.6f} N')


def compute(given, base):
    """All steps; rank 0 tells what came out."""
    totals = parallel.Totals([base], given.every)
    begin = time.perf_counter()
    parallel.run(given.steps, given.rebalance)
    seconds = time.perf_counter() - begin
    if parallel.rank() == 0:
        report(totals, seconds, given.steps)
        if given.output:
            results.writeCsv(given.output, COLUMNS + ENERGIES, map(row, totals.rows))


def main():
    try:
        given = options()
        base = load(given) if parallel.rank() == 0 else None
        compute(given, base)
    except (OSError, RuntimeError, ValueError) as error:
        print(f'parallel_bed.py: {error}', file=sys.stderr)
        return FAILED if isinstance(error, RuntimeError) else BAD_INPUT
    return 0


sys.exit(main())
