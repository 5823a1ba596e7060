"""Pictures of an impact: the force over time, the bed before and after, the force chains at the peak, and an animation (docs/view.md)."""
from __future__ import annotations

import dataclasses
import os
from typing import TYPE_CHECKING

from ...pictures import attempt, render, renderer
from ...pictures.snapshotrecorder import SnapshotRecorder, SnapshotSequence, removeSnapshots
from ...vtk import recorder
from . import forceplot
from .parameters import ImpactParameters
from .pulse import Pulse

if TYPE_CHECKING:
    from .run import ImpactRun

FORCE, BED, CHAINS, ANIMATION = FILES = ('force.png', 'bed.png', 'chains.png', 'impact.gif')
FRAMES, SERIES = 'frames', 'vtk'  # folders
PERIOD = 1.5e-4    # from frame to frame [s]: a pulse lasts some 2 ms
AFTERWARDS = 2e-3  # for which the animation goes on when the pulse is over [s]
MOST = 60          # frames of the animation


def film(run: ImpactRun) -> SnapshotRecorder | None:
    """The `SnapshotRecorder` of the impact of a `run` (`ImpactRun`), None where none is wanted."""
    drawn = run.pictures and renderer.missing() is None
    if not drawn and not run.state.vtk:
        return None
    return SnapshotRecorder(run.path(FRAMES) if drawn else None, run.path(SERIES) if run.state.vtk else None, run.state.startTime, PERIOD)


def removeOld(run: ImpactRun) -> None:
    """Remove the frames and the series that an earlier run left in the folder."""
    removeSnapshots(run.path(FRAMES))
    recorder.remove(run.path(SERIES))


def made(run: ImpactRun) -> list[str]:
    """Names of the pictures that are in the run's folder."""
    return [name for name in FILES if os.path.exists(run.path(name))]


def draw(run: ImpactRun) -> None:
    """Draw all pictures of a finished `run`; those of particles only where the packages for it are (`renderer.missing`). Frames that could not be
    drawn are kept."""
    state, recorded = run.state, run.openRecord()
    pulse = Pulse(**state.pulse)
    title = f'{len(run.ids)} particles ({_describe(run.parameters)}), thickness {1e3 * state.bed["thickness"]:.1f} mm'
    record, bare = (recorded.column('time'), recorded.column('baseForce')), (state.bare['times'], state.bare['forces'])
    attempt.attempt(run, 'the force', lambda: forceplot.forcePicture(run.path(FORCE), record, pulse, state.staticForce, bare, title))
    frames = None if run.film is None else run.film.snapshots()
    if not frames or attempt.attempt(run, 'the particles', lambda: _drawParticles(run, frames, pulse, title)):
        removeSnapshots(run.path(FRAMES))


def _drawParticles(run: ImpactRun, frames: SnapshotSequence, pulse: Pulse, title: str) -> None:
    start = run.state.startTime
    render.picture(run.path(BED), [('before the impact', frames[0]), ('after the impact', frames[-1])], cut=True,
                   title=title + ' (front half taken away)')
    peak = frames[min(range(len(frames)), key=lambda k: abs(frames.times[k] - pulse.peakTime))]
    render.picture(run.path(CHAINS), [('', peak)], chains=True, title=f'Forces at the peak on the base, {1e3 * pulse.peakTime:.2f} ms')
    shown = frames[:sum(time <= pulse.lastTime + AFTERWARDS for time in frames.times)]
    render.animation(run.path(ANIMATION), shown[::-(-len(shown) // MOST)], cut=True, start=start)


def _describe(p: ImpactParameters) -> str:
    """The shape in words: its name, and exponents and aspect that are not the name's own."""
    shape, own = p.meanShape, dataclasses.replace(p, n1=None, n2=None).meanShape
    special = [f'$n_1$ = {shape.n1:g}'] * (shape.n1 != own.n1) + [f'$n_2$ = {shape.n2:g}'] * (shape.n2 != own.n2)
    return ', '.join([p.shape, *special, *[f'c/a = {p.aspect:g}'] * (p.aspect != 1)])
