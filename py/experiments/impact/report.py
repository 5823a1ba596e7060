"""The results of a finished run: summary and time series."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from yade import O

from ...files import results
from ...measure.snapshot import Snapshot
from ...pictures import snapshotrecorder
from ...runs.filenames import BEFORE, SUMMARY
from ...runs.versions import versions
from ...scene.engines import criticalTimeStep
from . import pictures
from .curves import RECORD
from .fall import surfaceSpeed

if TYPE_CHECKING:
    from .run import ImpactRun

AFTER = 'after.npz'
FILES = (SUMMARY, RECORD, BEFORE, AFTER)


def write(run: ImpactRun) -> dict[str, Any]:
    """Write what belongs to the end of the `run` (`ImpactRun`): all but the record and the bed before; pictures last, as the results do not
    depend on them. Returns the summary."""
    after = Snapshot.ofBodies(run.ids)
    after.save(run.path(AFTER))
    content = summary(run)
    results.writeJson(run.path(SUMMARY), content)
    if run.pictures:
        pictures.draw(run)
    else:
        snapshotrecorder.removeSnapshots(run.path(pictures.FRAMES))
    return content


def summary(run: ImpactRun) -> dict[str, Any]:
    """All that is known of the finished `run`, as a dict for JSON. SI units."""
    p, state, bare = run.parameters, run.state, run.state.bare['pulse']
    shape = p.meanShape
    return {
        'parameters': p.asDict(),
        'particle': {'number': len(run.ids), 'extents': list(shape.extents), 'n1': shape.n1, 'n2': shape.n2,
                     'yadeSphere': shape.asSphere, 'volume': shape.volume, 'mass': shape.volume * p.density},
        'bed': {**state.bed, 'pours': state.pours, 'staticForce': state.staticForce, 'staticWallForce': state.staticWallForce,
                'weight': sum(O.bodies[i].state.mass for i in run.ids) * p.gravity, 'atRest': state.settled,
                **({'wallSeconds': state.bedSeconds} if state.has('bedSeconds') else {})},  # of a bed that was made by itself
        'impactor': {'mass': O.bodies[state.impactor].state.mass, 'surfaceSpeed': surfaceSpeed(p.speed, p.dropHeight, p.gravity)},
        'impact': {**state.pulse, 'over': state.impactOver},
        'bare': bare,
        'P0': bare['peak'],
        'bufferingRatio': (bare['peak'] - state.pulse['peak']) / bare['peak'],
        'energy': dict(O.energy.items()),
        'timeStep': {'impact': O.dt, 'critical': criticalTimeStep()},
        'solver': state.solver,
        'versions': versions(),
        'threads': O.numThreads,
        'wallSeconds': state.seconds,
    }


def text(content: Mapping[str, Any]) -> str:
    """The main results of a `summary` in a few lines, and what is wrong with them."""
    bed, impact = content['bed'], content['impact']
    return '\n'.join((
        f'bed        {content["particle"]["number"]} particles, thickness {1e3 * bed["thickness"]:.1f} mm, '
        f'packing fraction {bed["packingFraction"]:.3f}',
        f'peak P     {impact["peak"]:.1f} N at {1e3 * impact["peakTime"]:.2f} ms',
        f'duration   {1e3 * impact["duration"]:.2f} ms (force above a tenth of the peak)',
        f'P0         {content["P0"]:.1f} N without a bed',
        f'buffering  {content["bufferingRatio"]:.3f} = (P0 - P)/P0',
        f'time       {content["wallSeconds"]:.0f} s on {content["threads"]} thread(s)',
        *(f'WARNING    {warning}' for warning in warnings(content))))


def warnings(content: Mapping[str, Any]) -> Iterator[str]:
    """What makes the results of a `summary` doubtful, one sentence each."""
    rest, solver = content['bed']['atRest'], content['solver']
    if not rest['soft']:
        yield 'the bed was still moving when maxSettlingTime ended the pouring'
    if not rest['true']:
        yield 'the bed was not at rest before the impact'
    target, thickness = content['parameters']['thickness'], content['bed']['thickness']
    if content['parameters']['particles'] is None and abs(thickness / target - 1) > content['parameters']['thicknessTolerance']:
        yield f'the bed is {1e3 * thickness:.2f} mm thick instead of {1e3 * target:.2f} mm, after {len(content["bed"]["pours"])} attempt(s)'
    if not content['impact']['over']:
        yield 'the impact was not over when maxImpactTime ended the record'
    if solver.get('uncertified'):
        yield f'{solver["uncertified"]} of {solver["solves"]} solutions of the contact problem are not certified'
