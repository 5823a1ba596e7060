"""Studies of oedometer tests (scripts/oedometer.py). The bed is a job of its own: tests that differ only in what is done to it share it."""
from ..experiment import PROVENANCE, Experiment
from .case import CONSERVED, SLOW
from .curves import drawContacts, drawGradings, drawStresses
from .parameters import OedometerParameters

MEASURED = {
    'number': ('particles', 'number'),
    'broken': ('particles', 'broken'),
    'generations': ('particles', 'generations'),
    'smallest': ('particles', 'smallest'),
    'volumeError': ('particles', 'volumeError'),
    'lost': ('particles', 'lost'),
    'centresOutside': ('particles', 'centresOutside'),
    'H': ('bed', 'height'),
    'C0': ('bed', 'packingFraction'),
    'strain': ('compression', 'strain'),
    'stress': ('compression', 'stress'),
    'lateralRatio': ('compression', 'lateralRatio'),
    'startVoidRatio': ('compression', 'voidRatio', 'start'),
    'voidRatio': ('compression', 'voidRatio', 'end'),
    'firstStress': ('compression', 'stressAtFirstEvent'),
    'onsetStress': ('compression', 'stressAtOnset'),
    'hardin': ('grading', 'hardin'),
    'einav': ('grading', 'einav'),
    'd50Before': ('grading', 'before', 'd50'),
    'd50': ('grading', 'after', 'd50'),
    'widestGap': ('grading', 'after', 'widestGap', 'factor'),
    'steepestPart': ('grading', 'after', 'steepestPart', 'mass'),
    'rattlerShareBefore': ('contacts', 'before', 'rattlerShare'),
    'rattlerShare': ('contacts', 'after', 'rattlerShare'),
    'contactNumberBefore': ('contacts', 'before', 'meanNumber'),
    'contactNumber': ('contacts', 'after', 'meanNumber'),
    'carryingContactNumber': ('contacts', 'after', 'meanNumberWithoutRattlers'),
    'contactForce': ('contacts', 'after', 'meanForce'),
    'carryingContactForce': ('contacts', 'after', 'meanForceWithoutRattlers'),
    'forceSpread': ('contacts', 'after', 'forceSpread'),
    'carryingForceSpread': ('contacts', 'after', 'forceSpreadWithoutRattlers'),
    'dt': ('timeStep',),
    'stepSeconds': ('secondsPerStep',),
    'bedSeconds': ('bed', 'wallSeconds'),
    'runSeconds': ('wallSeconds',),
    **PROVENANCE,
}


def _within(*keys):
    """What is there in a summary, None where one of the parts on the way to it is missing."""
    def value(summary):
        for key in keys:
            summary = summary and summary[key]
        return summary
    return value


DERIVED = {
    'fragmentsWidestGap': _within('grading', 'fragments', 'widestGap', 'factor'),
    'fragmentsSteepestPart': _within('grading', 'fragments', 'steepestPart', 'mass'),
    'fractalDimension': _within('grading', 'fractal', 'dimension'),
    'fractalFit': _within('grading', 'fractal', 'correlation'),
    'inertialNumberReached': _within('quasiStatic', 'inertialNumber', 'largest'),
    'unbalancedForce': _within('quasiStatic', 'unbalancedForce'),
    'plateOverBase': _within('quasiStatic', 'plateOverBase'),
    'waiting': lambda summary: summary['breakage']['waiting'] if summary['breakage'] else 0,
    'uncertified': lambda summary: summary['solver'].get('uncertified', 0),
}


def _concerns(done):
    smooth = done['wallFriction'] == 0  # rough walls bear a part of the stress
    counts = ((done['lost'] > 0, 'with particles outside the container'),
              (done['volumeError'].abs() > CONSERVED, 'in which the volume of the particles is not conserved'),
              (done['waiting'] > 0, 'in which particles at their strength were left waiting: maxEvents is too small'),
              (smooth & ((done['plateOverBase'] - 1).abs() > SLOW), f'too fast: plate and base differ by more than {100 * SLOW:g} %'))
    return [f'tests {text}: {int(wrong.sum())} of {len(done)}' for wrong, text in counts if wrong.any()]


def _costs(particles):
    """Of a bed and a test on it: the test has as many steps again, and more and more particles."""
    return particles, 4 * particles


OEDOMETERS = Experiment(
    name='oedometer', script='oedometer.py', folder='tests', parameters=OedometerParameters, bedJobs=True,
    particleCount=lambda parameters: parameters.particles, costs=_costs, places=None,
    measured=MEASURED, derived=DERIVED, mayBeMissing=('firstStress', 'onsetStress'),  # where so few break
    runSeconds='runSeconds', shown=('strain', 'stress', 'onsetStress', 'number', 'hardin', 'fragmentsWidestGap', 'carryingContactNumber',
                                    'carryingForceSpread', 'plateOverBase'),
    concerns=_concerns, validations={'singleParticleCrushing': 'single_particle_crushing'},
    drawings={'stresses': drawStresses, 'gradings': drawGradings, 'contacts': drawContacts})
