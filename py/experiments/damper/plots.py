"""Pictures of a damper's run, like figures 7-10 of Li et al. (2018): without a display, lengths over the static deflection A0 = F/k."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ...pictures.style import COLOURS, newFigure, save
from . import motion as dampermotion
from .motion import Motion
from .parameters import DamperParameters

BOX, PARTICLES = COLOURS[0], COLOURS[1]
HIGHEST_FREQUENCY = 6.0  # in the spectra, over the drive's
HISTORY_PERIODS = 12     # of the time series, at its end


def spectra(path: str, motion: Motion, p: DamperParameters) -> None:
    """Amplitude spectra of the box and of the particles' centre of mass over the drive's frequency (figure 7)."""
    figure, panels = newFigure(2, 1, 4.6, 3.4)
    step, unit = np.mean(np.diff(motion.time)), _unit(p)
    for axes, values, colour, name in zip(panels.flat, (motion.box, motion.centroid), (BOX, PARTICLES), ('box', 'centre of mass of the particles')):
        frequencies, amplitudes = dampermotion.spectrum(values, step)
        ratio = frequencies / p.frequency
        shown = ratio <= HIGHEST_FREQUENCY
        axes.plot(ratio[shown], amplitudes[shown] / unit, color=colour, lw=1)
        for frequency, amplitude in dampermotion.lines(frequencies, amplitudes):
            if frequency / p.frequency <= HIGHEST_FREQUENCY:
                axes.annotate(f'{frequency / p.frequency:.2f}', (frequency / p.frequency, amplitude / unit),
                              xytext=(2, 2), textcoords='offset points', fontsize=7)
        axes.set(xlabel='frequency over the drive\'s', ylabel='amplitude/$A_0$', title=name)
    figure.suptitle(_title(p))
    save(figure, path)


def phasePlanes(path: str, motion: Motion, p: DamperParameters) -> None:
    """Velocity over displacement, of the box and of the centre of mass (figures 8 and 9)."""
    figure, panels = newFigure(2, 1, 4.2, 4.0)
    unit = _unit(p)
    speed = 2 * np.pi * p.frequency * unit
    for axes, values, velocities, colour, name in (
            (panels[0, 0], motion.box, motion.boxVelocity, BOX, 'box'),
            (panels[0, 1], motion.centroid - motion.centroid.mean(), motion.centroidVelocity, PARTICLES, 'centre of mass, its mean taken off')):
        axes.plot(values / unit, velocities / speed, color=colour, lw=0.6)
        axes.set(xlabel='displacement/$A_0$', ylabel=r'velocity/($\omega A_0$)', title=name)
    figure.suptitle(_title(p))
    save(figure, path)


def history(path: str, motion: Motion, p: DamperParameters) -> None:
    """Displacements and force of the contacts over time, at the end of the run."""
    figure, panels = newFigure(1, 2, 8, 2.6, sharex=True)
    last = dampermotion.lastPeriods(motion, min(HISTORY_PERIODS, len(motion.time) // p.samples), p.samples)
    upper, lower = panels[:, 0]
    upper.plot(last.time, last.box / _unit(p), color=BOX, lw=1.2, label='box')
    upper.plot(last.time, last.centroid / _unit(p), color=PARTICLES, lw=1.2, label='centre of mass of the particles')
    upper.set(ylabel='displacement/$A_0$')
    upper.legend(loc='upper right', fontsize=8)
    lower.plot(last.time, last.contactForce / p.forceAmplitude, color=COLOURS[2], lw=0.8)
    lower.set(xlabel='time since the drive began [s]', ylabel='contact force/F')
    figure.suptitle(_title(p))
    save(figure, path)


def shares(path: str, energy: Mapping[str, Any], p: DamperParameters) -> None:
    """Share of each sink in the energy that was dissipated (one column of figure 10)."""
    figure, panels = newFigure(1, 1, 6, 3.2)
    axes, ordered = panels[0, 0], sorted(energy['shares'].items(), key=lambda item: item[1])
    axes.barh([name for name, _ in ordered], [100 * share for _, share in ordered], color=BOX)
    axes.set(xlabel='share of the dissipated energy [%]', title=_title(p))
    save(figure, path)


def _unit(p: DamperParameters) -> float:
    """The static deflection [m], or without a spring a millimetre."""
    return p.forceAmplitude / p.stiffness if p.stiffness else 1e-3


def _title(p: DamperParameters) -> str:
    return f'{p.particles} particles ({p.shape}), {p.frequency:g} Hz'
