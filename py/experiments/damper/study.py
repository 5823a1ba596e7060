"""Studies of particle dampers (scripts/damper.py). What a run calls a bed is the filling of its box: each run settles its own."""
import os

import numpy

from ...files.results import readCsv, readJson
from ...pictures.style import COLOURS, MARKERS, newFigure, outerLegend
from ...runs.filenames import SUMMARY
from ...statistics.samples import typicalValue
from ..experiment import PROVENANCE, Experiment
from ..quantities import axisLabel, xSentence
from .energy import CLOSED, STEADY
from .motion import RECORD, Motion, lastPeriods, spectrum
from .parameters import DamperParameters

MEASURED = {
    'number': ('particles', 'number'),
    'particlesMass': ('particles', 'mass'),
    'amplitude': ('box', 'amplitude'),
    'phaseLag': ('box', 'phaseLag'),
    'peakToPeak': ('box', 'peakToPeak'),
    'harmonicShare': ('box', 'harmonicShare'),
    'fundamentalShare': ('box', 'fundamentalShare'),
    'work': ('energy', 'work'),
    'dissipated': ('energy', 'dissipated'),
    'balanceError': ('energy', 'balanceError'),
    'dt': ('timeStep', 'step'),
    'runSeconds': ('wallSeconds',),
    **PROVENANCE,
}
SINKS = {'plastic': 'plastic, normal', 'normalViscous': 'viscous, normal', 'tangentialViscous': 'viscous, tangential',
         'frictionDissip': 'sliding friction', 'rollingViscous': 'viscous, rolling', 'rollingFriction': 'rolling friction', 'rolling': 'rolling'}
FROZEN = (':', '-.')  # lines of the boxes with particles frozen to them
HIGHEST = 4    # frequency in the spectra, over the drive's


def _ofCentroid(key):
    return lambda summary: summary['centroid'][key] if summary['centroid'] else None


def _periodOf(body):
    """Periods of the drive after which it repeats, 0 if it does not: a number for tests."""
    return lambda summary: summary[body]['period'] or 0 if summary[body] else None


def _centroidRatio(summary):
    return summary['centroid']['rms'] / summary['box']['rms'] if summary['centroid'] and summary['box']['rms'] else None


def _storedShare(summary):
    """Of the work; 0 where nothing damps, so that the motion can only be what it began with."""
    energy = summary['energy']
    return energy['stored'] / energy['work'] if energy['dissipated'] else 0.0


def _shareOf(sink):
    return lambda summary: summary['energy']['shares'].get(sink, 0.0)


def _normalViscousLead(summary):
    """How far the normal viscous share is above the largest other one."""
    shares = {**summary['energy']['shares']}
    own = shares.pop('normalViscous', 0.0)
    return own - max(shares.values(), default=0.0)


DERIVED = {
    'period': _periodOf('box'),
    'centroidAmplitude': _ofCentroid('amplitude'),
    'centroidPhaseLag': _ofCentroid('phaseLag'),
    'centroidPeakToPeak': _ofCentroid('peakToPeak'),
    'centroidPeriod': _periodOf('centroid'),
    'centroidRatio': _centroidRatio,
    'centroidHarmonicShare': _ofCentroid('harmonicShare'),
    'centroidLoopFill': _ofCentroid('loopFill'),
    'storedShare': _storedShare,
    'normalViscousLead': _normalViscousLead,
    'uncertified': lambda summary: summary['solver'].get('uncertified', 0),
    **{f'{sink}Share': _shareOf(sink) for sink in SINKS},
}


def _concerns(done):
    counts = ((done['balanceError'].abs() > CLOSED, f'runs whose energy account is off by more than {100 * CLOSED:g} % of the work'),
              (done['storedShare'].abs() > STEADY, 'runs that were still building up or dying out'))
    return [f'{text}: {", ".join(f"{x:g} Hz" for x in sorted(set(done["frequency"][wrong])))}' for wrong, text in counts if wrong.any()]


def drawShares(data, series, values, panels, records):
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


def drawResponse(data, series, values, panels, records):
    """Amplitude of the box over the frequency of the drive, with the closed forms of the empty box and of particles frozen to it, and lag."""
    figure, ((amplitudes, lags),) = newFigure(2, 1, 5.4, 4.2)
    for k, name in enumerate(series):
        at = [x for x in values if len(data.sample('amplitude', name, x))]
        style = {'marker': MARKERS[k], 'ms': 6, 'lw': 1.5, 'color': COLOURS[data.series.index(name)], 'mec': 'white', 'mew': 0.7}
        amplitudes.plot(at, [1e3 * typicalValue(data.sample('amplitude', name, x)).mean for x in at], label=name or 'with particles', **style)
        lags.plot(at, [data.sample('phaseLag', name, x).mean() for x in at], **style)
    _drawClosedForms(amplitudes, data, series, values)
    amplitudes.set(xlabel=data.xLabel, ylabel=axisLabel('amplitude'), yscale='log')
    lags.set(xlabel=data.xLabel, ylabel=axisLabel('phaseLag'))
    outerLegend(figure, [amplitudes])
    return figure


def _drawClosedForms(axes, data, series, values):
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


def drawSpectra(data, series, values, panels, records):
    """Amplitude spectra of box and centre of mass, a panel per x, of the first seed of the first series (figure 7)."""
    return _panelPerFrequency(data, series, values, records, _drawSpectrum)


def drawPhasePlanes(data, series, values, panels, records):
    """Velocity over displacement of box and centre of mass, a panel per x, of the first seed of the first series (figures 8 and 9)."""
    return _panelPerFrequency(data, series, values, records, _drawPlane)


def _panelPerFrequency(data, series, values, records, draw):
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


def _recordOf(folder):
    """The measured part of a run's `Motion`, and its parameters."""
    given = readJson(os.path.join(folder, SUMMARY))['parameters']
    record = Motion(*numpy.array(readCsv(os.path.join(folder, RECORD))[1]).T)
    return lastPeriods(record, given['periods'], given['samples']), given


def _bodies(motion):
    """(displacement, velocity, colour, label) of box and particles."""
    yield motion.box, motion.boxVelocity, COLOURS[0], 'box'
    yield motion.centroid - motion.centroid.mean(), motion.centroidVelocity, COLOURS[1], 'centre of mass of the particles, its mean taken off'


def _drawPlane(panel, motion, given):
    for displacement, velocity, colour, label in _bodies(motion):
        panel.plot(1e3 * displacement, velocity, lw=0.6, color=colour, label=label)
    panel.set(xlabel='displacement [mm]', ylabel='velocity [m/s]')


def _drawSpectrum(panel, motion, given):
    for displacement, _, colour, label in _bodies(motion):
        frequencies, amplitudes = spectrum(displacement, numpy.mean(numpy.diff(motion.time)))
        ratio = frequencies / given['frequency']
        shown = (ratio > 0) & (ratio <= HIGHEST)
        panel.plot(ratio[shown], 1e3 * amplitudes[shown], lw=1, color=colour, label=label)
    panel.set(xlabel='frequency over the drive\'s', ylabel='amplitude [mm]')


def _costs(particles):
    return 0, 1 + particles


DAMPERS = Experiment(
    name='damper', script='damper.py', folder='vibrations', parameters=DamperParameters, bedJobs=False,
    particleCount=lambda parameters: parameters.particles, costs=_costs, places=None,
    measured=MEASURED, derived=DERIVED, mayBeMissing=(), runSeconds='runSeconds',
    shown=('amplitude', 'phaseLag', 'peakToPeak', 'centroidAmplitude', 'balanceError'), concerns=_concerns, validations={},
    drawings={'response': drawResponse, 'shares': drawShares, 'spectra': drawSpectra, 'phasePlanes': drawPhasePlanes})
