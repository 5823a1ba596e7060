"""Figures of studies of particle dampers: responses, shares of the dissipated energy, spectra and phase planes."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy

from ...files.results import readCsv, readJson
from ...pictures.style import COLOURS, MARKERS, newFigure, outerLegend
from ...runs.filenames import SUMMARY
from ...statistics.samples import typicalValue
from ...typealiases import Floats
from ..quantities import Quantity, axisLabel, xSentence
from .motion import RECORD, Motion, lastPeriods, spectrum

AMPLITUDE = Quantity('amplitude at the drive\'s frequency', '', 'mm', 1e3)
PHASE_LAG = Quantity('phase lag', '', 'degrees')
SINKS = {'yieldDissip': 'plastic, normal', 'normDampDissip': 'viscous, normal', 'shearDampDissip': 'viscous, tangential',
         'plastDissip': 'sliding friction', 'rollingDampDissip': 'viscous, rolling', 'rollingDissip': 'rolling friction'}
FROZEN = (':', '-.')  # lines of the boxes with particles frozen to them
HIGHEST = 4    # frequency in the spectra, over the drive's


def drawShares(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Share of each sink in the dissipated energy over x, a panel per series (figure 10 of Li et al. 2018)."""
    figure, axes = newFigure(len(series), 1, 4.6, 3.8, sharey=True)
    for panel, name in zip(axes[0], series):
        for k, (sink, label) in enumerate(SINKS.items()):
            shares = [data.sample(f'{sink}Share', name, x).mean() for x in values]
            if numpy.nanmax(shares) > 0:
                panel.plot(values, 100 * numpy.array(shares), marker=MARKERS[k], ms=5, lw=1.4, color=COLOURS[k], label=label)
        panel.set(xlabel=data.xLabel, title=name)
    axes[0, 0].set_ylabel('share of the dissipated energy [%]')
    outerLegend(figure, axes.flat, columns=3)
    return figure


def drawResponse(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Amplitude of the box over the frequency of the drive, with the closed forms of the empty box and of particles frozen to it, and lag."""
    figure, ((amplitudes, lags),) = newFigure(2, 1, 5.4, 4.2)
    for k, name in enumerate(series):
        at = [x for x in values if len(data.sample('amplitude', name, x))]
        style = {'marker': MARKERS[k], 'ms': 6, 'lw': 1.5, 'color': COLOURS[data.series.index(name)], 'mec': 'white', 'mew': 0.7}
        amplitudes.plot(at, [1e3 * typicalValue(data.sample('amplitude', name, x)).mean for x in at], label=name or 'with particles', **style)
        lags.plot(at, [data.sample('phaseLag', name, x).mean() for x in at], **style)
    _drawClosedForms(amplitudes, data, series, values)
    amplitudes.set(xlabel=data.xLabel, ylabel=axisLabel(AMPLITUDE), yscale='log')
    lags.set(xlabel=data.xLabel, ylabel=axisLabel(PHASE_LAG))
    outerLegend(figure, [amplitudes])
    return figure


def _drawClosedForms(axes: Any, data: Any, series: Sequence[str], values: Sequence[float]) -> None:
    """F/|k - M (2 pi f)^2| of the box alone, and with each mass of particles frozen to it."""
    frequencies = numpy.linspace(min(values), max(values), 400)
    box = data.runs.iloc[0]
    masses = sorted({round(float(mass), 4) for name in series for mass in data.runs[data.runs['series'] == name]['particlesMass'] if mass})
    frozen = [(mass, FROZEN[k % len(FROZEN)], f'with {mass:.3g} kg frozen to it') for k, mass in enumerate(masses)]
    for mass, line, label in ((0.0, '-', 'empty box, closed form'), *frozen):
        inertia = (box['boxMass'] + mass) * (2 * numpy.pi * frequencies) ** 2
        axes.plot(frequencies, 1e3 * box['forceAmplitude'] / abs(box['stiffness'] - inertia), line, lw=1.1, color='#666666', label=label)
    top = 1e3 * data.runs['amplitude'].max()
    axes.set_ylim(1e3 * data.runs['amplitude'].min() / 2, 4 * top)


def drawSpectra(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Amplitude spectra of box and centre of mass, a panel per x, of the first seed of the first series (figure 7)."""
    return _panelPerFrequency(data, series, values, records, _drawSpectrum)


def drawPhasePlanes(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Velocity over displacement of box and centre of mass, a panel per x, of the first seed of the first series (figures 8 and 9)."""
    return _panelPerFrequency(data, series, values, records, _drawPlane)


def _panelPerFrequency(data: Any, series: Sequence[str], values: Sequence[float], records: str,
                       draw: Callable[[Any, Motion, dict[str, Any]], None]) -> Any:
    columns = min(len(values), 3)
    figure, axes = newFigure(columns, -(-len(values) // columns), 3.8, 3.4)
    for panel, x in zip(axes.flat, values):
        rows = data.rows(series[0], x)
        if len(rows):
            draw(panel, *_recordOf(os.path.join(records, rows['run'].iloc[0])))
        panel.set_title(xSentence(data.xLabel, x), fontsize=11)
    for panel in axes.flat[len(values):]:
        panel.set_axis_off()
    outerLegend(figure, axes.flat)
    return figure


def _recordOf(folder: str) -> tuple[Motion, dict[str, Any]]:
    """The measured part of a run's `Motion`, and its parameters."""
    given = readJson(os.path.join(folder, SUMMARY))['parameters']
    record = Motion(*numpy.array(readCsv(os.path.join(folder, RECORD))[1]).T)
    return lastPeriods(record, given['periods'], given['samples']), given


def _bodies(motion: Motion) -> Iterator[tuple[Floats, Floats, str, str]]:
    """(displacement, velocity, colour, label) of box and particles."""
    yield motion.box, motion.boxVelocity, COLOURS[0], 'box'
    yield motion.centroid - motion.centroid.mean(), motion.centroidVelocity, COLOURS[1], 'centre of mass of the particles, its mean taken off'


def _drawPlane(panel: Any, motion: Motion, given: dict[str, Any]) -> None:
    for displacement, velocity, colour, label in _bodies(motion):
        panel.plot(1e3 * displacement, velocity, lw=0.6, color=colour, label=label)
    panel.set(xlabel='displacement [mm]', ylabel='velocity [m/s]')


def _drawSpectrum(panel: Any, motion: Motion, given: dict[str, Any]) -> None:
    for displacement, _, colour, label in _bodies(motion):
        frequencies, amplitudes = spectrum(displacement, numpy.mean(numpy.diff(motion.time)))
        ratio = frequencies / given['frequency']
        shown = (ratio > 0) & (ratio <= HIGHEST)
        panel.plot(ratio[shown], 1e3 * amplitudes[shown], lw=1, color=colour, label=label)
    panel.set(xlabel='frequency over the drive\'s', ylabel='amplitude [mm]')
