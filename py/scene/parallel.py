"""A scene on several processes (MPI): YADE's `mpy` with what superquadrics need, and totals over all ranks.

A script scene.py, started by `tools/env mpirun -np 3 yade -n -x -j1 scene.py`::

    from yade.superquadric import parallel
    if parallel.rank() == 0:
        ...                                    # bodies, O.engines, O.dt as for one process
    totals = parallel.Totals(supports=[base], every=100)
    parallel.run(10000)                        # by all ranks; rank 0 then has totals.rows

Every rank runs the script. Rank 0 builds the scene, keeps what cannot move (walls, meshes, containers) and gets the whole force on it; the others
share the particles among them, each a domain of space. With one process everything runs as usual, and the totals mean the same.

Bodies near a border are known on both sides, and their contacts are computed on both, with the same history; a contact goes with its body when
the body changes its rank. O.energy of a rank holds half of such a contact, so that sums over ranks count it once. See docs/scaling.md.
"""
from __future__ import annotations

import atexit
import sys
import traceback
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, ClassVar

from yade import O, config
from yade.minieigenHP import Vector3
from yade.wrapper import Body, BoundaryController, BreakageEngine, InsertionSortCollider, KinematicEngine, PyRunner, VibratingBoxEngine

from .. import checks
from .bodies import present
from .engines import engine

WHOLE_SCENE = (BreakageEngine, VibratingBoxEngine)  # engines that need all bodies in one process
MOVERS = (KinematicEngine, BoundaryController)      # engines that move walls
VTK_RECORDER = 'superquadric.vtk.recorder'          # stands in the command of the PyRunner that vtkRecorder makes
SPARED = ('unboundRemoteBodies', 'eraseRemote')     # functions of mpy, see _split


@cache
def _mpy() -> Any:
    # Not at the top: importing it starts MPI.
    from yade import mpy
    atexit.register(_leave, mpy.comm)
    return mpy


def _leave(comm: Any) -> None:
    """A rank that ends while others want to go on (after an error) takes them along: they would wait for it for ever."""
    if any(comm.allgather(False)):
        comm.Abort(1)


def _meet() -> None:
    """All ranks are about to go on, or have left."""
    comm = _mpy().comm
    if not all(comm.allgather(True)):
        print(f'rank {rank()}: another rank has ended, so this one does', file=sys.stderr, flush=True)
        comm.Abort(1)


def rank() -> int:
    """Number of this process, from 0."""
    return _mpy().rank


def ranks() -> int:
    """Number of processes; 1 without mpirun."""
    return _mpy().numThreads


def run(steps: int, rebalanceEvery: int = 0) -> None:
    """Do `steps` steps on all ranks; to be called by all of them. The first time it cuts the scene of rank 0 into domains, and O.energy starts
    from zero.

    :param rebalanceEvery: bodies change to the rank whose domain they have moved into at every so many runs of the collider; 0: never.
        mpy's median filter, which also evens out the numbers of bodies
    :raises ValueError: the scene cannot be cut, or a wall moves (rank 0 only; the other ranks then end with mpirun); several ranks after
        `merge(forGood=True)` (on all)
    """
    steps, rebalanceEvery = checks.wholeNumber('steps', steps, 1, checks.STEPS), checks.wholeNumber('rebalanceEvery', rebalanceEvery, 0)
    if Totals.ended and ranks() > 1:
        raise ValueError('run: not on several ranks after merge(forGood=True)')
    mpy = _mpy()
    mpy.REALLOCATE_FREQUENCY = rebalanceEvery
    if rank() == 0 and ranks() > 1:
        (_checkEnginesAndWalls if Totals.begun else distribute)()
    if rank() == 0 and not Totals.begun:
        for name in O.energy.keys():
            O.energy[name] = 0  # clearing it would confuse NewtonIntegrator, which knows the places of its entries
    Totals.begun = True
    if ranks() == 1:
        O.run(steps, wait=True)
        return
    _meet()
    if not O.splittedOnce:
        _orAbort(_split)
    _orAbort(mpy.mpirun, steps)


def _split() -> None:
    """`mpy.splitScene`, with the contacts at borders and walls as they are. It erases all bodies of other ranks, and gets those near a border
    back without what their contacts remember. Here the first erasing is left out, and all keep their boxes, so that the collider knows them; the
    second erasing, of those that are not near, does all that is needed.

    :raises RuntimeError: mpy is another one than this was made for"""
    mpy = _mpy()
    functions = {name: getattr(mpy, name) for name in SPARED}
    for name, function in functions.items():
        _spareFirstCall(mpy, name, function)
    silent, mpy.NO_OUTPUT = mpy.NO_OUTPUT, True  # mpy wonders that the walls are known already
    try:
        mpy.splitScene()
    finally:
        mpy.NO_OUTPUT = silent
    unused = [name for name, function in functions.items() if getattr(mpy, name) is not function]
    if unused:
        raise RuntimeError(f'yade.mpy of YADE {config.version}: splitScene no longer calls {", ".join(unused)}, so that contacts at '
                           'borders would be forgotten')


def _spareFirstCall(module: Any, name: str, function: Callable[..., Any]) -> None:
    setattr(module, name, lambda: setattr(module, name, function))


def merge(forGood: bool = False) -> None:
    """Bring all bodies and contacts back to rank 0, where they can be drawn or measured; to be called by all ranks.

    :param forGood: rank 0 then has an ordinary scene of one process, to be saved or run by `O.run`, without `Totals`; no `run` on several ranks
        can follow
    """
    forGood = checks.boolean('forGood', forGood)
    if ranks() > 1:
        _meet()
        _orAbort(_mpy().mergeScene)
    Totals.ended = Totals.ended or forGood
    if forGood and rank() == 0:
        _makeOrdinary()


def _makeOrdinary() -> None:
    for body in list(O.bodies):
        if body.isSubdomain:
            O.bodies.erase(body.id)
        body.subdomain = 0
    O.engines = [each for each in O.engines if not (isinstance(each, PyRunner) and each.command.startswith(Totals.COMMAND))]


def _orAbort(do: Callable[..., object], *arguments: Any) -> None:
    # An error of one rank would leave the others in the middle of their messages.
    try:
        do(*arguments)
    except BaseException:  # Ctrl-C and sys.exit too
        traceback.print_exc()
        sys.stderr.flush()
        _mpy().comm.Abort(1)


def distribute() -> None:
    """Give every body of the scene its rank: what cannot move 0, the others domains of equal numbers, by recursive bisection along the longest
    side of the box around their centres.

    :raises ValueError: an engine that needs the whole scene, walls that move, a periodic cell, clumps, or fewer particles than domains
    """
    moving = [body for body in O.bodies if body.dynamic]
    _checkEnginesAndWalls()
    _checkScene(moving, ranks() - 1)
    for body in O.bodies:
        body.subdomain = 0
        if body.mat is not None and body.mat.id < 0:
            O.materials.append(body.mat)  # mpy finds them there when bodies come back
    _bisect([(tuple(body.state.pos), body.id) for body in moving], range(1, ranks()))
    engine(InsertionSortCollider).label = 'collider'  # mpy knows it by this name
    O.engines = O.engines


def _checkEnginesAndWalls() -> None:
    for each in O.engines:
        if isinstance(each, WHOLE_SCENE):
            raise ValueError(f'engine = {type(each).__name__}: it needs the whole scene in one process')
        if isinstance(each, MOVERS):
            raise ValueError(f'engine = {type(each).__name__}: walls cannot move on several ranks')
        if isinstance(each, PyRunner) and VTK_RECORDER in each.command:
            raise ValueError('engine = vtkRecorder: each rank would write its own part under the same names; record on rank 0 after merge')
    # Rank 0 tells no other rank where its bodies are: a wall that moved would stand still for the particles.
    for body in O.bodies:
        if not (body.dynamic or body.isSubdomain) and (body.state.vel.norm() > 0 or body.state.angVel.norm() > 0):
            raise ValueError(f'body {body.id}: it is not dynamic and has a velocity, but walls cannot move on several ranks')


def _checkScene(moving: Sequence[Body], domains: int) -> None:
    if O.periodic:
        raise ValueError('O.periodic = True: periodic scenes cannot be cut into domains')
    if any(body.isClump for body in O.bodies):
        raise ValueError('O.bodies: clumps cannot be cut into domains')
    if len(moving) < domains:
        raise ValueError(f'ranks = {domains + 1}: more domains than the {len(moving)} particles')


def _bisect(places: Sequence[tuple[tuple[float, ...], int]], domains: range) -> None:
    """Give the bodies of `places`, (position, id) each, the subdomains in the range `domains`, in equal shares."""
    if len(domains) == 1:
        for _, number in places:
            O.bodies[number].subdomain = domains[0]
        return
    spans = [max(column) - min(column) for column in zip(*(position for position, _ in places))]
    axis, half = spans.index(max(spans)), len(domains) // 2
    places = sorted(places, key=lambda place: (place[0][axis], place[1]))
    cut = len(places) * half // len(domains)
    _bisect(places[:cut], domains[:half])
    _bisect(places[cut:], domains[half:])


class Totals:
    """Sums over all ranks, taken at the end of every `every`-th step; to be made by all ranks before the first `run`.

    :param supports: ids of fixed bodies whose forces are added up
    :raises ValueError: `every` is no whole number, on rank 0 a support is not in the scene; on several ranks also after a `run`
    :ivar rows: on rank 0 a dict for each record: `time` [s], `momentum` (3) [kg m/s] of all particles, `force` (3) [N] on the supports in this step,
        `bodies` that moved, and with O.trackEnergy `energy`, the entries of O.energy [J] since the scene was cut; on other ranks empty
    """

    COMMAND = f"sys.modules['{__name__}'].Totals._all"  # of the scene's PyRunner, which has the number in this list:
    _all: ClassVar[list[Totals]] = []
    begun = False  # whether there was a `run`
    ended = False  # whether there was a `merge` for good

    def __init__(self, supports: Sequence[int] = (), every: int = 1) -> None:
        if Totals.begun and ranks() > 1:  # the other ranks have their engines by then, and would not take part
            raise ValueError('Totals: must be made before the first run')
        every = checks.wholeNumber('every', every, 1, checks.STEPS)
        # Only rank 0 has the bodies by now.
        self.rows: list[dict[str, Any]] = []
        self.supports = present('supports', supports) if rank() == 0 else list(supports)
        Totals._all.append(self)
        if rank() == 0:
            command = f'{self.COMMAND}[{len(Totals._all) - 1}].record()'
            first = O.iter + every - 1
            # Step 0 is no firstIterRun to YADE.
            O.engines = O.engines + [PyRunner(command=command, iterPeriod=every, firstIterRun=first, initRun=first == 0)]

    def record(self) -> None:
        """Called on all ranks in the same step."""
        own = rank()
        states = [body.state for body in O.bodies if body.subdomain == own and not body.isSubdomain and body.dynamic]
        momentum = sum((state.mass * state.vel for state in states), Vector3.Zero)
        parts = [(len(states), tuple(momentum), dict(O.energy.items()))]
        if O.splitted:
            parts = _mpy().comm.gather(parts[0], root=0)
        if own:
            return
        numbers, momenta, energies = zip(*parts)
        force = sum((O.forces.f(support) for support in self.supports), Vector3.Zero)
        self.rows.append({'time': O.time + O.dt, 'bodies': sum(numbers), 'momentum': tuple(map(sum, zip(*momenta))), 'force': tuple(force),
                          'energy': {name: sum(energy.get(name, 0) for energy in energies) for name in set().union(*energies)}})
