"""Studies of impacts on beds (scripts/impact.py)."""
import math

from ..experiment import PROVENANCE, Experiment
from .curves import drawCurves
from .parameters import ImpactParameters

RING = 3.0  # distance of the other places from the first, over the particles' radius: other particles take the blow there
MEASURED = {
    'number': ('particle', 'number'),
    'H': ('bed', 'thickness'),
    'C0': ('bed', 'packingFraction'),
    'innerC0': ('bed', 'innerPackingFraction'),
    'staticForce': ('bed', 'staticForce'),
    'weight': ('bed', 'weight'),
    'peak': ('impact', 'peak'),
    'peakTime': ('impact', 'peakTime'),
    'duration': ('impact', 'duration'),
    'lastTime': ('impact', 'lastTime'),
    'impulse': ('impact', 'impulse'),
    'P0': ('P0',),
    'bufferingRatio': ('bufferingRatio',),
    'surfaceSpeed': ('impactor', 'surfaceSpeed'),
    'over': ('impact', 'over'),
    'solves': ('solver', 'solves'),
    'iterations': ('solver', 'iterations'),
    'fallbacks': ('solver', 'fallbacks'),
    'uncertified': ('solver', 'uncertified'),
    'dtImpact': ('timeStep', 'impact'),
    'bedSeconds': ('bed', 'wallSeconds'),
    'impactSeconds': ('wallSeconds',),
    **PROVENANCE,
}
DERIVED = {
    'pours': lambda summary: len(summary['bed']['pours']),
    'atRest': lambda summary: bool(summary['bed']['atRest']['soft'] and summary['bed']['atRest']['true']),
}
DOUBTS = (('atRest', False, 'impacts on beds that were not at rest'), ('over', False, 'impacts that were not over when the record ended'))


def placesOf(p: ImpactParameters, number: int) -> list[dict[str, float]]:
    """The places on the bed where the impactor falls: the one that the parameters say, the others on a ring about it.

    What a bed does to a blow depends on the few particles that it meets, and an impact costs a tenth of what its bed does.
    """
    x, y, ring = p.impactorX, p.impactorY, RING * p.radius
    angles = [2 * math.pi * k / (number - 1) for k in range(number - 1)]
    return [{}, *({'impactorX': round(x + ring * math.cos(a), 9), 'impactorY': round(y + ring * math.sin(a), 9)} for a in angles)]


def _costs(particles):
    """Higher beds take longer to rest, impacts last alike."""
    return particles ** 1.5, 9 * particles


def _concerns(done):
    counts = [(int((done[column] == bad).sum()), text) for column, bad, text in DOUBTS]
    return [f'{text}: {count}' for count, text in counts if count] + _offThickness(done)


def _offThickness(done):
    """A sentence on the beds that are not as thick as they should be, if there are any. Those of a given number of particles may be."""
    aimed = done[done['particles'].isna()].drop_duplicates('bed')
    off = (aimed['H'] / aimed['thickness'] - 1).abs() > aimed['thicknessTolerance']
    return [f'beds thicker or thinner than thicknessTolerance allows: {int(off.sum())}'] if off.any() else []


IMPACTS = Experiment(
    name='impact', script='impact.py', folder='impacts', parameters=ImpactParameters, bedJobs=True,
    particleCount=ImpactParameters.particleCount, costs=_costs, places=placesOf,
    measured=MEASURED, derived=DERIVED, mayBeMissing=('innerC0',),  # in a thin bed
    runSeconds='impactSeconds', shown=('peak', 'C0', 'duration', 'H'), concerns=_concerns,
    validations={'cylinderOnPlane': 'cylinder_on_plane'}, drawings={'curves': drawCurves})
