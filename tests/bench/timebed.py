"""Time a settled bed: yade -n -x -j1 timebed.py KIND COUNT --output FILE [--steps ...]. The driver is `run`, beside this file.

Writes a JSON file: seconds of each block of steps (wall clock and CPU of all threads), contacts and candidate pairs, how quiet the bed
was, what the contact solver met. With --phases the engines' own times as well; with --pairs a file for `kernel_bench --bed`.
"""
import argparse
import json
import sys
import time

import beds
import levelset
from bedcache import bedFile
from yade import O
from yade import superquadric as sq
from yade.wrapper import PyRunner


class Clock:
    """Reads the clocks every `steps` steps, called by an engine: `O.run(wait=True)` itself looks only every 40 ms."""

    def __init__(self, steps):
        self.blocks, self.contacts, self.pairs, self.last, self.steps = [], [], [], None, steps

    def tick(self):
        now = time.perf_counter(), time.process_time()
        if self.last:
            self.blocks.append([end - begin for begin, end in zip(self.last, now)])
        self.contacts.append(O.interactions.countReal())
        self.pairs.append(len(O.interactions))
        self.last = time.perf_counter(), time.process_time()

    def run(self, blocks):
        """Time `blocks` blocks of steps. Two steps more are run, so that the engine's first look falls before the first block."""
        O.engines = O.engines + [PyRunner(command='clock.tick()', iterPeriod=self.steps, initRun=True)]
        O.run(blocks * self.steps + 2, wait=True)
        O.engines = O.engines[:-1]


def phases(steps):
    """Seconds per step of each engine, and of the parts that an engine itself tells apart (its timingDeltas). The clocks are read
    between the engines, which costs well below 1 %."""
    O.timingEnabled = True
    for each in O.engines:
        each.execTime, each.execCount = 0, 0
        if each.timingDeltas:
            each.timingDeltas.reset()
    O.run(steps, wait=True)
    O.timingEnabled = False
    return {type(each).__name__: {'seconds': each.execTime * 1e-9 / steps, 'runs': each.execCount / steps, 'parts': _parts(each, steps)}
            for each in O.engines}


def _parts(engine, steps):
    return {name: time * 1e-9 / steps for name, time, _ in engine.timingDeltas.data} if engine.timingDeltas else {}


def writePairs(path, ids, kind):
    """Places of the particles at two steps in a row, and the collider's pairs of particles, as text for kernel_bench."""
    shape = beds.particleShape(kind)
    before = [_place(i) for i in ids]
    O.step()
    number = {body: i for i, body in enumerate(ids)}
    pairs = [(number[i.id1], number[i.id2]) for i in O.interactions.all() if i.id1 in number and i.id2 in number]
    with open(path, 'w') as out:
        print(*(repr(float(value)) for value in (*shape.extents, shape.n1, shape.n2)), file=out)
        print(len(ids), len(pairs), file=out)
        for first, body in zip(before, ids):
            print(*(repr(value) for value in first + _place(body)), file=out)
        for pair in pairs:
            print(*pair, file=out)


def _place(body):
    state = O.bodies[body].state
    return (*state.pos, state.ori[3], state.ori[0], state.ori[1], state.ori[2])


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument('kind')
    parser.add_argument('count', type=int)
    parser.add_argument('--output', required=True)
    parser.add_argument('--warmup', type=int, default=400)
    parser.add_argument('--blocks', type=int, default=5)
    parser.add_argument('--steps', type=int, default=100)
    parser.add_argument('--phases', type=int, default=0)
    parser.add_argument('--pairs')
    return parser.parse_args(sys.argv[1:])


options = arguments()
levelSet = options.kind == 'levelSet'
bed = beds.Bed.load(bedFile(options.kind, options.count))
ids, walls = levelset.place(bed) if levelSet else beds.place(options.kind, bed)
criterion = sq.RestCriterion(ids, walls)
counted = not levelSet and beds.KINDS[options.kind].law == 'curvature'

O.run(options.warmup, wait=True)
before = criterion.kineticEnergy()
if counted:
    sq.solverCounters(reset=True)
clock = Clock(options.steps)
clock.run(options.blocks)
result = {'kind': options.kind, 'count': options.count, 'steps': options.steps, 'wall': [wall for wall, _ in clock.blocks],
          'cpu': [cpu for _, cpu in clock.blocks], 'contacts': clock.contacts, 'pairs': clock.pairs,
          'kineticEnergy': [before, criterion.kineticEnergy()],
          'solver': sq.solverCounters() if counted else None, 'solverSteps': options.blocks * options.steps + 2}
if options.phases:
    result['phases'] = phases(options.phases)
if options.pairs:
    writePairs(options.pairs, ids, options.kind)
with open(options.output, 'w') as out:
    json.dump(result, out)
