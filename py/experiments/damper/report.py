"""The results of a finished run of a damper: summary, motion, pictures."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from yade import O
from yade.wrapper import VibrationRecorder

from ...files import results
from ...pictures import attempt
from ...runs.filenames import SUMMARY
from ...runs.versions import versions
from ...scene.engines import engine
from . import motion as dampermotion
from . import plots
from .energy import CLOSED, account, isSteady
from .motion import RECORD, Motion

if TYPE_CHECKING:
    from .run import DamperRun

PICTURES = SPECTRUM, PHASES, HISTORY, ENERGIES = ('spectrum.png', 'phases.png', 'motion.png', 'energies.png')
FILES = (SUMMARY, RECORD, *PICTURES)


def write(run: DamperRun) -> dict[str, Any]:
    """Write all results of the `run`; the summary, then the pictures. Returns the summary."""
    p, state = run.parameters, run.state
    motion = dampermotion.ofRecorder(engine(VibrationRecorder), p.axis, state.startTime, state.restCentroid)
    measured = dampermotion.lastPeriods(motion, p.periods, p.samples)
    content = summary(run, measured)
    results.writeCsv(run.path(RECORD), motion._fields, zip(*motion))
    results.writeJson(run.path(SUMMARY), content)
    if run.pictures:
        attempt.attempt(run, 'the motion', lambda: _draw(run, motion, measured, content))
    return content


def _draw(run: DamperRun, motion: Motion, measured: Motion, content: Mapping[str, Any]) -> None:
    p = run.parameters
    plots.spectra(run.path(SPECTRUM), measured, p)
    plots.phasePlanes(run.path(PHASES), measured, p)
    plots.history(run.path(HISTORY), motion, p)
    plots.shares(run.path(ENERGIES), content['energy'], p)


def summary(run: DamperRun, measured: Motion) -> dict[str, Any]:
    """All that is known of the finished `run`, as a dict for JSON. SI units."""
    p, state = run.parameters, run.state
    mass = sum(O.bodies[i].state.mass for i in run.ids)
    shape, energies = p.meanShape, state.energies
    described = (p.periods, p.samples, p.frequency, p.forceAmplitude)
    return {
        'parameters': p.asDict(),
        'material': {name: value for name, value in O.materials['particles'].dict().items() if isinstance(value, float)},
        'particles': {'number': len(run.ids), 'mass': mass, 'density': p.particleDensity(), 'filling': p.filling(), 'extents': list(shape.extents),
                      'n1': shape.n1, 'n2': shape.n2, 'yadeSphere': shape.asSphere, 'settled': state.settled},
        'naturalFrequency': {'empty': p.naturalFrequency(), 'withParticles': p.naturalFrequency(mass)},
        'staticDeflection': p.forceAmplitude / p.stiffness if p.stiffness else None,
        'box': dampermotion.describe(measured.time, measured.box, measured.boxVelocity, *described),
        'centroid': dampermotion.describe(measured.time, measured.centroid, measured.centroidVelocity, *described) if run.ids else None,
        'energy': account(energies[-p.periods - 1] if len(energies) > p.periods else {}, energies[-1]),
        'timeStep': {'step': O.dt, 'critical': p.smallestCriticalStep(), 'collision': p.collisionTime(), 'perRecord': p.stepsPerSample()},
        'solver': state.solver,
        'versions': versions(),
        'threads': O.numThreads,
        'driveSteps': len(energies) * p.stepsPerPeriod(),
        'driveSeconds': state.stageSeconds['drive'],
        'wallSeconds': state.seconds,
    }


def text(content: Mapping[str, Any]) -> str:
    """The main results of a `summary` in a few lines, and what is wrong with them."""
    box, centroid, energy, p = (content[name] for name in ('box', 'centroid', 'energy', 'parameters'))
    natural = content['naturalFrequency']
    return '\n'.join((
        f'damper     {content["particles"]["number"]} particles, {content["particles"]["mass"]:.4g} kg, in a box of {p["boxMass"]:g} kg; '
        f'{natural["empty"]:.2f} Hz empty, {natural["withParticles"]:.2f} Hz with them as added mass',
        f'drive      {p["forceAmplitude"]:g} N at {p["frequency"]:g} Hz, {p["periods"]} periods measured',
        _motionText('box', box), *([_motionText('centroid', centroid)] if centroid else []),
        f'energy     work {energy["work"]:.4g} J; ' + ', '.join(f'{name} {100 * share:.1f} %' for name, share in _ordered(energy['shares'])),
        f'balance    {100 * energy["balanceError"]:+.3f} % of the work',
        f'time       {content["wallSeconds"]:.0f} s on {content["threads"]} thread(s), {content["driveSteps"] / content["driveSeconds"]:.0f} steps/s',
        *(f'WARNING    {warning}' for warning in warnings(content))))


def warnings(content: Mapping[str, Any]) -> Iterator[str]:
    """What makes the results of a `summary` doubtful, one sentence each."""
    if abs(content['energy']['balanceError']) > CLOSED:
        yield 'the energy balance is off by more than one per cent of the work; take a smaller time step'
    if not isSteady(content['energy']):
        yield 'the motion was still building up or dying out while it was measured; take a longer transientTime'
    if content['solver'].get('uncertified'):
        yield f'{content["solver"]["uncertified"]} of {content["solver"]["solves"]} solutions of the contact problem are not certified'


def _motionText(name: str, motion: Mapping[str, Any]) -> str:
    period = 'aperiodic' if motion['period'] is None else f'period {motion["period"]}'
    return (f'{name:10} amplitude {1e3 * motion["amplitude"]:.4g} mm at the drive\'s frequency, {motion["phaseLag"]:.1f} degrees behind it; '
            f'peak to peak {1e3 * motion["peakToPeak"]:.4g} mm; {period}')


def _ordered(shares: Mapping[str, float]) -> list[tuple[str, float]]:
    return sorted(shares.items(), key=lambda item: -item[1])
