"""Kinetic energy plus everything in O.energy stays constant in collisions of random shapes, up to the time step."""
import pytest
from isolatedpairs import collide, makePairs
from yade import O

DURATION = 1e-3  # by then the collisions are over [s]
OWN_ENTRIES = ('elastPotential', 'nonconservative')  # of the law, besides the sinks
SINKS = ('plastDissip', 'normDampDissip', 'shearDampDissip', 'rollingDissip')


def roughMaterial(generator):
    return dict(frictionAngle=generator.uniform(0.1, 0.6), normalDamping=generator.uniform(0.02, 0.1),
                tangentialDamping=generator.uniform(0, 0.3), rollingFriction=generator.uniform(0, 0.01))


def imbalance(timeStepFraction, material):
    """Total energy after the collisions of 60 pairs less that before, over the kinetic energy before; and the energies [J]."""
    pairs = makePairs(60, 11, timeStepFraction, material=material)
    O.trackEnergy = True
    before = sum(pair.kineticEnergy() for pair in pairs)
    collide(pairs, DURATION)
    energies = {name: O.energy[name] for name in SINKS + OWN_ENTRIES}
    after = sum(pair.kineticEnergy() for pair in pairs)
    return (after + sum(energies.values()) - before) / before, energies, before


@pytest.mark.parametrize('material', [lambda generator: {}, roughMaterial], ids=['smooth', 'rough'])
def testBalanceClosesWithTheTimeStep(material):
    coarse, _, _ = imbalance(0.1, material)
    fine, energies, before = imbalance(0.02, material)
    assert abs(coarse) < 2e-3
    assert abs(fine) < 1e-4
    # The law's own part is there to be seen, and it is small.
    assert 1e-5 * before < abs(energies['nonconservative']) < 0.03 * before


def testEverySinkTakes():
    _, energies, before = imbalance(0.1, roughMaterial)
    for sink in SINKS:
        assert energies[sink] > 1e-5 * before, sink
