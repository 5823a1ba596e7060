"""Studies of particle dampers (scripts/damper.py). What a run calls a bed is the filling of its box: each run settles its own."""
import os

import numpy

from .. import damperparameters as parameters
from ..dampermotion import Motion, lastPeriods
from ..results import readCsv, readJson
from .experiment import Experiment
from .impacts import standard
from .quantities import xSentence
from .style import COLOURS, MARKERS, newFigure, outerLegend

MEASURED = {
    'number': ('particles', 'number'),
    'particlesMass': ('particles', 'mass'),
    'amplitude': ('box', 'amplitude'),
    'phaseLag': ('box', 'phaseLag'),
    'peakToPeak': ('box', 'peakToPeak'),
    'harmonicShare': ('box', 'harmonicShare'),
    'work': ('energy', 'work'),
    'dissipated': ('energy', 'dissipated'),
    'balanceError': ('energy', 'balanceError'),
    'dt': ('timeStep', 'step'),
    'runSeconds': ('wallSeconds',),
    'threads': ('threads',),
    'versionYade': ('versions', 'yade'),
    'versionPlugin': ('versions', 'yade-superquadric'),
    'versionPython': ('versions', 'python'),
    'versionNumpy': ('versions', 'numpy'),
}
SINKS = {'plastic': 'plastic, normal', 'normalViscous': 'viscous, normal', 'tangentialViscous': 'viscous, tangential', 'frictionDissip': 'sliding friction',
         'rollingViscous': 'viscous, rolling', 'rollingFriction': 'rolling friction', 'rolling': 'rolling'}
CLOSED = 0.01  # of the work: an account that is off by more is not closed


def _ofCentroid(key):
    return lambda summary: summary['centroid'][key] if summary['centroid'] else None


def _periodOf(body):
    """Periods of the drive after which it repeats, 0 if it does not: a number for tests."""
    return lambda summary: summary[body]['period'] or 0 if summary[body] else None


def _centroidRatio(summary):
    return summary['centroid']['rms'] / summary['box']['rms'] if summary['centroid'] and summary['box']['rms'] else None


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
    'normalViscousLead': _normalViscousLead,
    'uncertified': lambda summary: summary['solver'].get('uncertified', 0),
    **{f'{sink}Share': _shareOf(sink) for sink in SINKS},
}


def _concerns(done):
    open_ = int((done['balanceError'].abs() > CLOSED).sum())
    return [f'runs whose energy account is off by more than {100 * CLOSED:g} % of the work: {open_}'] if open_ else []


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
    outerLegend(figure, axes.flat)
    return figure


def drawPhasePlanes(data, series, values, panels, records):
    """Velocity over displacement of box and centre of mass, a panel per x, of the first seed of the first series (figures 8 and 9)."""
    columns = min(len(values), 3)
    figure, axes = newFigure(columns, -(-len(values) // columns), 3.8, 3.6)
    for panel, x in zip(axes.flat, values):
        rows = data.rows(series[0], x)
        if len(rows):
            _drawPlane(panel, os.path.join(records, rows['run'].iloc[0]))
        panel.set_title(xSentence(data.xLabel, x), fontsize=11)
    for panel in axes.flat[len(values):]:
        panel.set_axis_off()
    outerLegend(figure, axes.flat)
    return figure


def _drawPlane(panel, folder):
    given = readJson(os.path.join(folder, 'summary.json'))['parameters']
    record = Motion(*numpy.array(readCsv(os.path.join(folder, 'motion.csv'))[1]).T)
    motion = lastPeriods(record, given['periods'], given['samples'])
    centred = motion.centroid - motion.centroid.mean()
    panel.plot(1e3 * motion.box, motion.boxVelocity, lw=0.6, color=COLOURS[0], label='box')
    panel.plot(1e3 * centred, motion.centroidVelocity, lw=0.6, color=COLOURS[1], label='centre of mass of the particles, its mean taken off')
    panel.set(xlabel='displacement [mm]', ylabel='velocity [m/s]')


def _costs(particles):
    return 0, 1 + particles


DAMPERS = Experiment(
    name='damper', script='damper.py', folder='vibrations', parameters=parameters.PARAMETERS, bedScope=parameters.BOX, bedJobs=False,
    checked=parameters.checked, standard=standard, particleCount=lambda values: values['particles'], costs=_costs, places=None,
    measured=MEASURED, derived=DERIVED, mayBeMissing=(), runSeconds='runSeconds',
    shown=('amplitude', 'phaseLag', 'peakToPeak', 'centroidAmplitude', 'balanceError'), concerns=_concerns, validations={},
    drawings={'shares': drawShares, 'phasePlanes': drawPhasePlanes})
