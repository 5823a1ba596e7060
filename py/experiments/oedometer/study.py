"""Studies of oedometer tests (scripts/oedometer.py). The bed is a job of its own: tests that differ only in what is done to it share it."""
from __future__ import annotations

from typing import Any

from ..experiment import PROVENANCE, Column, Experiment
from ..quantities import BED_SECONDS, NUMBER, PACKING_FRACTION, RUN_SECONDS, THICKNESS, UNCERTIFIED, Quantity
from .case import CONSERVED, SLOW
from .curves import drawContacts, drawGradings, drawStresses
from .parameters import OedometerParameters

COLUMNS = (
    Column('number', 'particles.number', NUMBER),
    Column('broken', 'particles.broken', Quantity('breakages')),
    Column('generations', 'particles.generations', Quantity('generations of fragments')),
    Column('smallest', 'particles.smallest', Quantity('smallest particle', '', 'mm', 1e3)),
    Column('volumeError', 'particles.volumeError', Quantity('error of the particles\' volume')),
    Column('lost', 'particles.lost', Quantity('particles lost')),
    Column('centresOutside', 'particles.centresOutside', Quantity('particles with their centre outside')),
    Column('H', 'bed.height', THICKNESS),
    Column('C0', 'bed.packingFraction', PACKING_FRACTION),
    Column('strain', 'compression.strain', Quantity('axial strain', '', '%', 100)),
    Column('stress', 'compression.stress', Quantity('axial stress at the end', '', 'MPa', 1e-6)),
    Column('lateralRatio', 'compression.lateralRatio', Quantity('lateral stress over the axial one'), mayBeMissing=True),  # the bed may just give way
    Column('startVoidRatio', 'compression.voidRatio.start', Quantity('void ratio at the start')),
    Column('voidRatio', 'compression.voidRatio.end', Quantity('void ratio at the end')),
    Column('firstStress', 'compression.stressAtFirstEvent', Quantity('axial stress at the first breakage', '', 'MPa', 1e-6), mayBeMissing=True),
    Column('onsetStress', 'compression.stressAtOnset', Quantity('axial stress at which 1 % are broken', '', 'MPa', 1e-6), mayBeMissing=True),
    Column('hardin', 'grading.hardin', Quantity('relative breakage', '$B_r$')),
    Column('einav', 'grading.einav', Quantity('breakage (Einav)', '$B$')),
    Column('d50Before', 'grading.before.d50', Quantity('median size before', '', 'mm', 1e3)),
    Column('d50', 'grading.after.d50', Quantity('median size after', '', 'mm', 1e3)),
    Column('widestGap', 'grading.after.widestGap.factor', Quantity('widest gap of the sizes')),
    Column('steepestPart', 'grading.after.steepestPart.mass', Quantity('steepest part of the grading', '', '%', 100)),
    # None of these where nothing breaks, or too little for a fit.
    Column('fragmentsWidestGap', 'grading.fragments.widestGap.factor', Quantity('widest gap of the fragments\' sizes'), mayBeMissing=True),
    Column('fragmentsSteepestPart', 'grading.fragments.steepestPart.mass', Quantity('steepest part of the fragments\' grading', '', '%', 100),
           mayBeMissing=True),
    Column('fractalDimension', 'grading.fractal.dimension', Quantity('fractal dimension of the tail'), mayBeMissing=True),
    Column('fractalFit', 'grading.fractal.correlation', Quantity('correlation of its fit', '$r^2$'), mayBeMissing=True),
    Column('rattlerShareBefore', 'contacts.before.rattlerShare', Quantity('rattlers before', '', '%', 100)),
    Column('rattlerShare', 'contacts.after.rattlerShare', Quantity('rattlers', '', '%', 100)),
    Column('contactNumberBefore', 'contacts.before.meanNumber', Quantity('contacts of a particle before')),
    Column('contactNumber', 'contacts.after.meanNumber', Quantity('contacts of a particle')),
    Column('carryingContactNumber', 'contacts.after.meanNumberWithoutRattlers', Quantity('contacts of a particle that is no rattler')),
    Column('contactForce', 'contacts.after.meanForce', Quantity('mean contact force', '', 'N')),
    Column('carryingContactForce', 'contacts.after.meanForceWithoutRattlers', Quantity('mean contact force without rattlers', '', 'N')),
    Column('forceSpread', 'contacts.after.forceSpread', Quantity('scatter of the contact force')),
    Column('carryingForceSpread', 'contacts.after.forceSpreadWithoutRattlers', Quantity('scatter of the contact force without rattlers')),
    # None of these in a test that ends at a low stress.
    Column('inertialNumberReached', 'quasiStatic.inertialNumber.largest', Quantity('largest inertial number'), mayBeMissing=True),
    Column('unbalancedForce', 'quasiStatic.unbalancedForce', Quantity('unbalanced force'), mayBeMissing=True),
    Column('plateOverBase', 'quasiStatic.plateOverBase', Quantity('stress on the plate over that on the base'), mayBeMissing=True),
    Column('waiting', lambda summary: summary['breakage']['waiting'] if summary['breakage'] else 0),
    Column('uncertified', lambda summary: summary['solver'].get('uncertified', 0), UNCERTIFIED),
    Column('dt', 'timeStep'),
    Column('stepSeconds', 'secondsPerStep', Quantity('computing a step', '', 'ms', 1e3)),
    Column('bedSeconds', 'bed.wallSeconds', BED_SECONDS),
    Column('runSeconds', 'wallSeconds', RUN_SECONDS),
    *PROVENANCE,
)


def _concerns(done: Any) -> list[str]:
    smooth = done['wallFriction'] == 0  # rough walls bear a part of the stress
    counts = ((done['lost'] > 0, 'with particles outside the container'),
              (done['volumeError'].abs() > CONSERVED, 'in which the volume of the particles is not conserved'),
              (done['waiting'] > 0, 'in which particles at their strength were left waiting: maxEvents is too small'),
              (smooth & ((done['plateOverBase'] - 1).abs() > SLOW), f'too fast: plate and base differ by more than {100 * SLOW:g} %'))
    return [f'tests {text}: {int(wrong.sum())} of {len(done)}' for wrong, text in counts if wrong.any()]


def _costs(particles: int) -> tuple[float, float]:
    """Of a bed and a test on it: the test has as many steps again, and more and more particles."""
    return particles, 4 * particles


OEDOMETERS = Experiment(
    name='oedometer', script='oedometer.py', folder='tests', parameters=OedometerParameters, bedJobs=True,
    particleCount=lambda parameters: parameters.particles, costs=_costs, places=None,
    measured=COLUMNS, runSeconds='runSeconds',
    shown=('strain', 'stress', 'onsetStress', 'number', 'hardin', 'fragmentsWidestGap', 'carryingContactNumber', 'carryingForceSpread',
           'plateOverBase'),
    concerns=_concerns, validations={'singleParticleCrushing': 'single_particle_crushing'},
    drawings={'stresses': drawStresses, 'gradings': drawGradings, 'contacts': drawContacts})
