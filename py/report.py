"""The results of a finished run: summary, time series, pictures."""
from yade import O

from . import plots, results, study
from .impact import Recorder, pulse, surfaceSpeed
from .engines import criticalTimeStep, solverCounters
from .snapshot import Snapshot

FORCE_PICTURE, BED_PICTURE = 'force.png', 'bed.png'


def write(run):
    """Write all files of the finished `run` (`ImpactRun`), remove its checkpoint, and set `run.summary`."""
    recorder = run.recorder
    measured = pulse(recorder.column('time'), recorder.column('baseForce'), run.state['staticForce'])
    results.writeCsv(run.path('force.csv'), Recorder.COLUMNS, recorder.rows)
    after = Snapshot.ofBodies(run.ids)
    after.save(run.path('after.npz'))
    run.summary = summary(run, measured)
    results.writeJson(run.path('summary.json'), run.summary)
    _pictures(run, measured, after)
    run.removeCheckpoint()


def summary(run, measured):
    """All that is known of the finished `run`, as a dict for JSON. SI units."""
    p, state, bare = run.parameters, run.state, run.state['bare']['pulse']
    shape = study.shapeOf(p)
    return {
        'parameters': p,
        'particle': {'number': len(run.ids), 'extents': list(shape.extents), 'n1': shape.n1, 'n2': shape.n2,
                     'yadeSphere': shape.asSphere, 'volume': shape.volume, 'mass': shape.volume * p['density']},
        'bed': {**state['bed'], 'staticForce': state['staticForce'],
                'staticWallForce': state['staticWallForce'],
                'weight': sum(O.bodies[i].state.mass for i in run.ids) * p['gravity'], 'atRest': state['settled']},
        'impactor': {'mass': O.bodies[state['impactor']].state.mass,
                     'surfaceSpeed': surfaceSpeed(p['speed'], p['dropHeight'], p['gravity'])},
        'impact': {**measured._asdict(), 'over': state['impactOver']},
        'bare': bare,
        'P0': bare['peak'],
        'bufferingRatio': (bare['peak'] - measured.peak) / bare['peak'],
        'energy': dict(O.energy.items()),
        'timeStep': {'impact': O.dt, 'critical': criticalTimeStep()},
        'solver': solverCounters(),
        'versions': results.versions(),
        'threads': O.numThreads,
        'wallSeconds': state['seconds'],
    }


def text(content):
    """The main results of a `summary` in a few lines."""
    bed, impact = content['bed'], content['impact']
    return '\n'.join((
        f'bed        {content["particle"]["number"]} particles, thickness {1e3 * bed["thickness"]:.1f} mm, '
        f'packing fraction {bed["packingFraction"]:.3f}',
        f'peak P     {impact["peak"]:.1f} N at {1e3 * impact["peakTime"]:.2f} ms',
        f'duration   {1e3 * impact["duration"]:.2f} ms (force above a tenth of the peak)',
        f'P0         {content["P0"]:.1f} N without a bed',
        f'buffering  {content["bufferingRatio"]:.3f} = (P0 - P)/P0',
        f'time       {content["wallSeconds"]:.0f} s on {content["threads"]} thread(s)'))


def _pictures(run, measured, after):
    p, state = run.parameters, run.state
    radius = p['impactorDiameter'] / 2
    title = f'{len(run.ids)} particles ({p["shape"]}), thickness {1e3 * state["bed"]["thickness"]:.1f} mm'
    record = run.recorder.column('time'), run.recorder.column('baseForce')
    plots.forcePicture(run.path(FORCE_PICTURE), record, measured, state['staticForce'],
                       (state['bare']['times'], state['bare']['forces']), title)
    views = [('before the impact', Snapshot.load(run.path('before.npz')), (state['impactorStart'], radius)),
             ('after the impact', after, (tuple(O.bodies[state['impactor']].state.pos), radius))]
    plots.bedPicture(run.path(BED_PICTURE), views, run.container, title + ' (front half taken away)')
