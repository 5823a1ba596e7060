"""Studies of particle dampers (scripts/damper.py). What a run calls a bed is the filling of its box: each run settles its own."""
from __future__ import annotations

from typing import Any

from ..experiment import PROVENANCE, Column, Experiment, Summary
from ..quantities import NUMBER, RUN_SECONDS, UNCERTIFIED, Quantity
from .curves import AMPLITUDE, PHASE_LAG, drawPhasePlanes, drawResponse, drawShares, drawSpectra
from .energy import CLOSED, STEADY
from .parameters import DamperParameters


def _periodOf(summary: Summary, body: str) -> int | None:
    """Periods of the drive after which it repeats, 0 if it does not: a number for tests."""
    return summary[body]['period'] or 0 if summary[body] else None


def _centroidRatio(summary: Summary) -> float | None:
    return summary['centroid']['rms'] / summary['box']['rms'] if summary['centroid'] and summary['box']['rms'] else None


def _storedShare(summary: Summary) -> float:
    """Of the work; 0 where nothing damps, so that the motion can only be what it began with."""
    energy = summary['energy']
    return float(energy['stored'] / energy['work']) if energy['dissipated'] else 0.0


def _normalViscousLead(summary: Summary) -> float:
    """How far the normal viscous share is above the largest other one."""
    shares = {**summary['energy']['shares']}
    own = shares.pop('normDampDissip', 0.0)
    return float(own - max(shares.values(), default=0.0))


def _share(sink: str, name: str = '') -> Column:
    """The column of a sink's share of the dissipation."""
    return Column(f'{sink}Share', lambda summary: summary['energy']['shares'].get(sink, 0.0),
                  Quantity(f'{name} share of the dissipation', '', '%', 100) if name else None)


COLUMNS = (
    Column('number', 'particles.number', NUMBER),
    Column('particlesMass', 'particles.mass', Quantity('mass of the particles', '', 'kg')),
    Column('amplitude', 'box.amplitude', AMPLITUDE),
    Column('phaseLag', 'box.phaseLag', PHASE_LAG),
    Column('peakToPeak', 'box.peakToPeak', Quantity('displacement, peak to peak', '', 'mm', 1e3)),
    Column('harmonicShare', 'box.harmonicShare', Quantity('harmonic part of the variance')),
    Column('fundamentalShare', 'box.fundamentalShare', Quantity('part of the variance at the drive\'s frequency')),
    Column('period', lambda summary: _periodOf(summary, 'box'), Quantity('period of the box over the drive\'s, 0 for none')),
    # None of these in an empty box.
    Column('centroidAmplitude', 'centroid.amplitude', Quantity('amplitude of the centre of mass', '', 'mm', 1e3), mayBeMissing=True),
    Column('centroidPhaseLag', 'centroid.phaseLag', Quantity('phase lag of the centre of mass', '', 'degrees'), mayBeMissing=True),
    Column('centroidPeakToPeak', 'centroid.peakToPeak', Quantity('centre of mass, peak to peak', '', 'mm', 1e3), mayBeMissing=True),
    Column('centroidPeriod', lambda summary: _periodOf(summary, 'centroid'),
           Quantity('period of the centre of mass over the drive\'s, 0 for none'), mayBeMissing=True),
    Column('centroidRatio', _centroidRatio, Quantity('motion of the centre of mass over that of the box (rms)'), mayBeMissing=True),
    Column('centroidHarmonicShare', 'centroid.harmonicShare', Quantity('harmonic part of the variance of the centre of mass'), mayBeMissing=True),
    Column('centroidLoopFill', 'centroid.loopFill', Quantity('loop of the centre of mass in its phase plane over the rectangle about it'),
           mayBeMissing=True),
    Column('work', 'energy.work', Quantity('work of the drive', '', 'J')),
    Column('dissipated', 'energy.dissipated', Quantity('dissipated energy', '', 'J')),
    _share('yieldDissip', 'plastic'),
    _share('normDampDissip', 'normal viscous'),
    _share('plastDissip', 'sliding'),
    _share('shearDampDissip', 'tangential viscous'),
    _share('rollingDampDissip'),
    _share('rollingDissip'),
    Column('normalViscousLead', _normalViscousLead, Quantity('lead of the normal viscous share over the next one', '', '%', 100)),
    Column('storedShare', _storedShare, Quantity('stored energy gained, over the work', '', '%', 100)),
    Column('balanceError', 'energy.balanceError', Quantity('error of the energy account', '', '%', 100)),
    Column('uncertified', lambda summary: summary['solver'].get('uncertified', 0), UNCERTIFIED),
    Column('dt', 'timeStep.step'),
    Column('runSeconds', 'wallSeconds', RUN_SECONDS),
    *PROVENANCE,
)


def _concerns(done: Any) -> list[str]:
    counts = ((done['balanceError'].abs() > CLOSED, f'runs whose energy account is off by more than {100 * CLOSED:g} % of the work'),
              (done['storedShare'].abs() > STEADY, 'runs that were still building up or dying out'))
    return [f'{text}: {", ".join(f"{x:g} Hz" for x in sorted(set(done["frequency"][wrong])))}' for wrong, text in counts if wrong.any()]


def _costs(particles: int) -> tuple[float, float]:
    return 0, 1 + particles


DAMPERS = Experiment(
    name='damper', script='damper.py', folder='vibrations', parameters=DamperParameters, bedJobs=False,
    particleCount=lambda parameters: parameters.particles, costs=_costs, places=None,
    measured=COLUMNS, runSeconds='runSeconds',
    shown=('amplitude', 'phaseLag', 'peakToPeak', 'centroidAmplitude', 'balanceError'), concerns=_concerns, validations={},
    drawings={'response': drawResponse, 'shares': drawShares, 'spectra': drawSpectra, 'phasePlanes': drawPhasePlanes})
