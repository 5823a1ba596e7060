"""Studies of impacts on beds (scripts/impact.py)."""
from __future__ import annotations

import math
from typing import Any

from ..experiment import PROVENANCE, Column, Experiment
from ..quantities import BED_SECONDS, NUMBER, PACKING_FRACTION, THICKNESS, UNCERTIFIED, Quantity
from .curves import drawCurves
from .parameters import ImpactParameters

RING = 3.0  # distance of the other places from the first, over the particles' radius: other particles take the blow there
COLUMNS = (
    Column('peak', 'impact.peak', Quantity('peak force', '$P$', 'kN', 1e-3)),
    Column('peakTime', 'impact.peakTime', Quantity('time of the peak in the record', '', 'ms', 1e3)),
    Column('duration', 'impact.duration', Quantity('duration', '', 'ms', 1e3)),
    Column('lastTime', 'impact.lastTime', Quantity('end of the last pulse in the record', '', 'ms', 1e3)),
    Column('impulse', 'impact.impulse', Quantity('impulse', '', 'N s')),
    Column('P0', 'P0', Quantity('peak force without a bed', '$P_0$', 'kN', 1e-3)),
    Column('bufferingRatio', 'bufferingRatio', Quantity('buffering ratio')),
    Column('number', 'particle.number', NUMBER),
    Column('H', 'bed.thickness', THICKNESS),
    Column('C0', 'bed.packingFraction', PACKING_FRACTION),
    Column('innerC0', 'bed.innerPackingFraction', Quantity('inner packing fraction'), mayBeMissing=True),  # in a thin bed
    Column('staticForce', 'bed.staticForce', Quantity('static force', '', 'N')),
    Column('weight', 'bed.weight', Quantity('weight of the bed', '', 'N')),
    Column('pours', lambda summary: len(summary['bed']['pours']), Quantity('pours')),
    Column('atRest', lambda summary: bool(summary['bed']['atRest']['soft'] and summary['bed']['atRest']['true'])),
    Column('surfaceSpeed', 'impactor.surfaceSpeed', Quantity('speed at the surface', '', 'm/s')),
    Column('over', 'impact.over'),
    Column('solves', 'solver.solves', Quantity('contact problems')),
    Column('iterations', 'solver.iterations', Quantity('iterations')),
    Column('fallbacks', 'solver.fallbacks', Quantity('fallbacks')),
    Column('uncertified', 'solver.uncertified', UNCERTIFIED),
    Column('dtImpact', 'timeStep.impact', Quantity('time step of the impact', '', 'us', 1e6)),
    Column('bedSeconds', 'bed.wallSeconds', BED_SECONDS),
    Column('impactSeconds', 'wallSeconds', Quantity('computing the impact', '', 's')),
    *PROVENANCE,
)
DOUBTS = (('atRest', False, 'impacts on beds that were not at rest'), ('over', False, 'impacts that were not over when the record ended'))


def placesOf(p: ImpactParameters, number: int) -> list[dict[str, float]]:
    """The places on the bed where the impactor falls: the one that the parameters say, the others on a ring about it.

    What a bed does to a blow depends on the few particles that it meets, and an impact costs a tenth of what its bed does.
    """
    x, y, ring = p.impactorX, p.impactorY, RING * p.radius
    angles = [2 * math.pi * k / (number - 1) for k in range(number - 1)]
    return [{}, *({'impactorX': round(x + ring * math.cos(a), 9), 'impactorY': round(y + ring * math.sin(a), 9)} for a in angles)]


def _costs(particles: int) -> tuple[float, float]:
    """Higher beds take longer to rest, impacts last alike."""
    return particles ** 1.5, 9 * particles


def _concerns(done: Any) -> list[str]:
    counts = [(int((done[column] == bad).sum()), text) for column, bad, text in DOUBTS]
    return [f'{text}: {count}' for count, text in counts if count] + _offThickness(done)


def _offThickness(done: Any) -> list[str]:
    """A sentence on the beds that are not as thick as they should be, if there are any. Those of a given number of particles may be."""
    aimed = done[done['particles'].isna()].drop_duplicates('bed')
    off = (aimed['H'] / aimed['thickness'] - 1).abs() > aimed['thicknessTolerance']
    return [f'beds thicker or thinner than thicknessTolerance allows: {int(off.sum())}'] if off.any() else []


IMPACTS = Experiment(
    name='impact', script='impact.py', folder='impacts', parameters=ImpactParameters, bedJobs=True,
    particleCount=ImpactParameters.particleCount, costs=_costs, places=placesOf,
    measured=COLUMNS, runSeconds='impactSeconds', shown=('peak', 'C0', 'duration', 'H'), concerns=_concerns,
    validations={'cylinderOnPlane': 'cylinder_on_plane'}, drawings={'curves': drawCurves})
