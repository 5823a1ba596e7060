"""The results of a finished oedometer test: tables, summary, pictures."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from yade import O
from yade.wrapper import BreakageEngine

from ...files import results
from ...measure import contactstatistics, enclosure, grading
from ...measure.bed import particleVolumes
from ...measure.contactstatistics import Contacts
from ...measure.snapshot import Snapshot
from ...pictures import attempt, renderer
from ...runs.filenames import BEFORE, SUMMARY
from ...runs.versions import versions
from ...scene.engines import engine
from . import case as oedometercase
from . import plots
from .case import CONSERVED, EVENTS, FORCES, GRADING, NUMBERS, PARTICLES, SLOW, STRESS, sizesOf
from .parameters import OedometerParameters
from .record import COLUMNS

if TYPE_CHECKING:
    from .run import OedometerRun

PICTURES = ('grading.png', 'stress.png', 'contacts.png', 'specimen.png')
FILES = (SUMMARY, *oedometercase.TABLES, BEFORE, *PICTURES)
EVENT_COLUMNS = ('time', 'step', 'parent', 'generation', 'size', 'value', 'strength', 'elasticLoss', 'spinLoss')
PARTICLE_COLUMNS = ('id', 'diameter', 'volume', 'x', 'y', 'z', 'generation', 'ancestor', 'contacts', 'meanForce')
GRADING_POINTS = 200    # equally spaced in log d
QUASISTATIC_STRESS = 1e5  # Pa: below, the bed's own weight and the plate's start count
ONSET = 0.01            # of the particles broken: where breakage begins to show


def contactsNow(ids: Sequence[int]) -> dict[str, list[float]]:
    """`Contacts` of the particles as a dict of lists, for JSON."""
    return {name: values.tolist() for name, values in contactstatistics.ofBodies(ids)._asdict().items()}


def write(run: OedometerRun) -> dict[str, Any]:
    """Write all results of the `run`; the summary after the tables, the pictures last. Returns the summary."""
    ids = run.ids
    snapshot, before = Snapshot.ofBodies(ids), Snapshot.load(run.path(BEFORE))
    particles = _particles(ids, snapshot)
    events = _events()
    results.writeCsv(run.path(STRESS), COLUMNS, [[row[name] for name in COLUMNS] for row in run.state.rows])
    results.writeCsv(run.path(EVENTS), (*EVENT_COLUMNS, 'children', 'smallestChild', 'largestChild'), events)
    results.writeCsv(run.path(PARTICLES), PARTICLE_COLUMNS, zip(*(particles[name] for name in PARTICLE_COLUMNS)))
    _writeDistributions(run, particles, before)
    content = summary(run, particles, snapshot, before)
    results.writeJson(run.path(SUMMARY), content)
    if run.pictures:
        attempt.attempt(run, 'the test', lambda: _drawTables(run))
        if renderer.missing() is None:
            views = (('before', before), ('after', snapshot))
            attempt.attempt(run, 'the particles', lambda: plots.specimens(run.path(PICTURES[3]), views, run.container))
    return content


def _drawTables(run: OedometerRun) -> None:
    case = [oedometercase.load(run.output)]
    for name, draw in zip(PICTURES, (plots.gradings, plots.stresses, plots.contacts)):
        draw(run.path(name), case)


def _particles(ids: Sequence[int], snapshot: Snapshot) -> dict[str, Any]:
    """{column: array} by PARTICLE_COLUMNS."""
    contacts, states = contactstatistics.ofBodies(ids), [O.bodies[i].state for i in ids]
    x, y, z = snapshot.positions.T
    columns = (ids, sizesOf(snapshot), particleVolumes(snapshot), x, y, z, [state.generation for state in states],
               [state.ancestor for state in states], contacts.numbers, contacts.forces)
    return {name: np.asarray(values) for name, values in zip(PARTICLE_COLUMNS, columns)}


def _events() -> list[list[float]]:
    """Rows of the table of events."""
    if not _breaks():
        return []
    return [[event[name] for name in EVENT_COLUMNS] + [len(event['children']), min(event['childSizes']), max(event['childSizes'])]
            for event in engine(BreakageEngine).events()]


def _breaks() -> bool:
    return any(isinstance(candidate, BreakageEngine) for candidate in O.engines)


def _writeDistributions(run: OedometerRun, particles: Mapping[str, Any], before: Snapshot) -> None:
    gradings = grading.Grading(sizesOf(before)), grading.Grading(particles['diameter'], particles['volume'])
    sizes = np.geomspace(gradings[1].sizes[0], 1.001 * gradings[0].sizes[-1], GRADING_POINTS)
    results.writeCsv(run.path(GRADING), ('size', 'before', 'after'), zip(sizes, *(g.finer(sizes) for g in gradings)))
    chosen = [Contacts(particles['contacts'], particles['meanForce'])]
    chosen.append(contactstatistics.withoutRattlers(chosen[0]))
    shares = [contactstatistics.numberDistribution(c)[1] for c in chosen]
    numbers = range(max(map(len, shares)))
    results.writeCsv(run.path(NUMBERS), ('contacts', 'all', 'withoutRattlers'),
                     [[n, *(s[n] if n < len(s) else 0.0 for s in shares)] for n in numbers])
    edges = plots.FORCE_EDGES
    results.writeCsv(run.path(FORCES), ('forceOverMean', 'all', 'withoutRattlers'),
                     zip((edges[1:] + edges[:-1]) / 2, *(contactstatistics.forceDistribution(c, edges) for c in chosen)))


def summary(run: OedometerRun, particles: Mapping[str, Any], snapshot: Snapshot, before: Snapshot) -> dict[str, Any]:
    """All that is known of the finished `run`, as a dict for JSON. SI units."""
    p, state, rows = run.parameters, run.state, run.state.rows
    volume = float(particles['volume'].sum())
    steps = O.iter - state.startIter
    return {
        'parameters': p.asDict(),
        'material': p.attributes(),
        'bed': {'particles': len(before), 'height': state.height, 'settled': state.settled,
                'packingFraction': state.solid / (p.section() * state.height), 'wallSeconds': state.bedSeconds},
        'particles': {'number': len(particles['id']), 'broken': rows[-1]['events'], 'generations': int(particles['generation'].max()),
                      'smallest': float(particles['diameter'].min()), 'volumeError': volume / state.solid - 1,
                      **enclosure.describe(snapshot, particles['diameter'], run.container, float(run.plate.state.pos[2]))},
        'compression': _compression(rows, p),
        'quasiStatic': _quasiStatic(rows),
        'grading': _gradings(particles, before, p),
        'contacts': {'before': contactstatistics.describe(Contacts(*map(np.array, (state.before['numbers'], state.before['forces'])))),
                     'after': contactstatistics.describe(Contacts(particles['contacts'], particles['meanForce']))},
        'breakage': {name: getattr(engine(BreakageEngine), name) for name in ('waiting', 'evenCuts', 'spinGains')} if _breaks() else None,
        'energy': dict(O.energy.items()),
        'timeStep': O.dt,
        'steps': steps,
        'secondsPerStep': state.stageSeconds['compress'] / steps,
        'stageSeconds': dict(state.stageSeconds),
        'wallSeconds': state.seconds,
        'solver': state.solver,
        'threads': O.numThreads,
        'versions': versions(),
    }


def _compression(rows: Sequence[Mapping[str, Any]], p: OedometerParameters) -> dict[str, Any]:
    last = rows[-1]
    onset = next((row for row in rows if row['events'] >= ONSET * p.particles), None)
    first = next((row for row in rows if row['events']), None)
    ratio = last['lateralStress'] / last['plateStress'] if last['plateStress'] else None  # the bed may have just given way
    return {'strain': last['strain'], 'stress': last['plateStress'], 'lateralRatio': ratio,
            'voidRatio': {'start': rows[0]['voidRatio'], 'end': last['voidRatio']},
            'stressAtFirstEvent': first and first['plateStress'], 'stressAtOnset': onset and onset['plateStress']}


def _quasiStatic(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any] | None:
    """How slow the test was: over the records above QUASISTATIC_STRESS; None without any."""
    slow = [row for row in rows if row['plateStress'] >= QUASISTATIC_STRESS]
    if not slow:
        return None
    ratios = [row['plateStress'] / row['baseStress'] for row in slow if row['baseStress'] > 0]
    return {'inertialNumber': {'largest': max(row['inertialNumber'] for row in slow), 'end': slow[-1]['inertialNumber']},
            'unbalancedForce': float(np.median([row['unbalancedForce'] for row in slow])),
            'plateOverBase': float(np.median(ratios)) if ratios else None}


def _gradings(particles: Mapping[str, Any], before: Snapshot, p: OedometerParameters) -> dict[str, Any]:
    first, last = grading.Grading(sizesOf(before)), grading.Grading(particles['diameter'], particles['volume'])
    relative = oedometercase.relativeGrading(particles, before)
    tail = grading.fractal(last, p.smallestDiameter) if p.breaks() else None
    return {'before': _grading(first), 'after': _grading(last), 'fragments': relative and _grading(relative),
            'hardin': grading.hardin(first, last), 'einav': grading.einav(first, last), 'fractal': tail and tail._asdict()}


def _grading(curve: grading.Grading) -> dict[str, Any]:
    gap, steepest = grading.widestGap(curve), grading.steepestPart(curve)
    return {**{f'd{share}': curve.size(share / 100) for share in (10, 30, 50, 60)}, 'uniformity': curve.uniformity(),
            'widestGap': {'factor': gap[0], 'low': gap[1], 'high': gap[2]}, 'steepestPart': {'mass': steepest[0], 'low': steepest[1]}}


def text(content: Mapping[str, Any]) -> str:
    """The main results of a `summary` in a few lines, and what is wrong with them."""
    p, particles, compression, curves = (content[name] for name in ('parameters', 'particles', 'compression', 'grading'))
    bed, contacts = content['bed'], content['contacts']['after']
    return '\n'.join((
        f'bed        {bed["particles"]} particles ({p["shape"]}), {1e3 * bed["height"]:.1f} mm high, packing fraction {bed["packingFraction"]:.3f}',
        f'end        axial stress {1e-6 * compression["stress"]:.3f} MPa, strain {100 * compression["strain"]:.2f} %, lateral ratio '
        f'{_ratioText(compression["lateralRatio"])}, void ratio {compression["voidRatio"]["start"]:.3f} to {compression["voidRatio"]["end"]:.3f}',
        f'breakage   mode {p["mode"]}: {particles["broken"]} events, {particles["number"]} particles in {particles["generations"]} generations; '
        f'1 % broken at {_megapascals(compression["stressAtOnset"])}',
        f'grading    B_r (Hardin) {curves["hardin"]:.4f}, d50 {1e3 * curves["before"]["d50"]:.2f} to {1e3 * curves["after"]["d50"]:.2f} mm; '
        f'{_fractalText(curves["fractal"])}; widest gap of fragments {_gapText(curves["fragments"])}',
        f'contacts   {contacts["meanNumber"]:.2f} a particle, {contacts["meanNumberWithoutRattlers"]:.2f} without '
        f'{100 * contacts["rattlerShare"]:.1f} % rattlers',
        f'volume     conserved to {particles["volumeError"]:.1e}; {particles["lost"]} particles lost, {particles["centresOutside"]} with their '
        f'centre outside', *_slowness(content['quasiStatic']),
        f'time       {content["wallSeconds"]:.0f} s on {content["threads"]} thread(s), {1e3 * content["secondsPerStep"]:.2f} ms a step',
        *(f'WARNING    {warning}' for warning in warnings(content))))


def _megapascals(stress: float | None) -> str:
    return 'no stress' if stress is None else f'{1e-6 * stress:.3f} MPa'


def _ratioText(ratio: float | None) -> str:
    return '-' if ratio is None else f'{ratio:.2f}'


def _fractalText(fit: Mapping[str, float] | None) -> str:
    return 'no tail' if fit is None else f'fractal dimension {fit["dimension"]:.2f} (r2 {fit["correlation"]:.3f})'


def _gapText(fragments: Mapping[str, Any] | None) -> str:
    return '-' if fragments is None else f'{fragments["widestGap"]["factor"]:.2f}'


def _slowness(content: Mapping[str, Any] | None) -> Iterator[str]:
    if content is not None:
        yield (f'slowness   inertial number {content["inertialNumber"]["end"]:.1e} at the end, unbalanced force {content["unbalancedForce"]:.1e}, '
               f'plate/base {content["plateOverBase"] or 0:.3f}')


def warnings(content: Mapping[str, Any]) -> Iterator[str]:
    """What makes the results of a `summary` doubtful, one sentence each."""
    particles = content['particles']
    if particles['lost']:
        yield f'{particles["lost"]} particles are outside the container'
    if abs(particles['volumeError']) > CONSERVED:
        yield 'the volume of the particles is not conserved'
    if content['breakage'] and content['breakage']['waiting']:
        yield f'{content["breakage"]["waiting"]} particles that had reached their strength were left waiting; maxEvents is too small'
    slow = content['quasiStatic']
    if slow and not content['parameters']['wallFriction'] and slow['plateOverBase'] is not None and abs(slow['plateOverBase'] - 1) > SLOW:
        yield f'the stresses on plate and base differ by more than {100 * SLOW:g} %: the test is too fast'
    if content['solver'].get('uncertified'):
        yield f'{content["solver"]["uncertified"]} of {content["solver"]["solves"]} solutions of the contact problem are not certified'
