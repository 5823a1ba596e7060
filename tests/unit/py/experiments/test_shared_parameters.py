"""What the experiments' parameters have in common: one name for one thing, the same members of the groups, the sizes that are drawn."""
import math

import pytest

from yade.superquadric.experiments.damper.parameters import DamperParameters
from yade.superquadric.experiments.impact.parameters import ImpactParameters
from yade.superquadric.experiments.material import Material
from yade.superquadric.experiments.oedometer.parameters import OedometerParameters
from yade.superquadric.experiments.renamedparameters import RENAMED
from yade.superquadric.scene.restitution import normalDampingFor

KINDS = {'impact': ImpactParameters, 'damper': DamperParameters, 'oedometer': OedometerParameters}


def test_oneNameHasOneUnitInAllExperiments():
    units = {}
    for kind in KINDS.values():
        for name, declared in kind.declarations().items():
            assert units.setdefault(name, declared.unit) == declared.unit, name


@pytest.mark.parametrize('name', KINDS)
def test_oldNamesLeadToPresentOnes(name):
    names = KINDS[name].declarations()
    assert KINDS[name].RENAMED is RENAMED[name]
    assert set(RENAMED[name].values()) <= set(names) and not set(RENAMED[name]) & set(names)


@pytest.mark.parametrize('kind', KINDS.values(), ids=KINDS)
def test_dampingIsGivenByRestitutionOrItself(kind):
    assert kind.checked({'restitution': 0.8}).attributes()['normalDamping'] == normalDampingFor(0.8)
    assert kind.checked({'normalDamping': 0.06}).attributes()['normalDamping'] == 0.06
    assert kind.checked({'normalDamping': 0.06, 'tangentialDamping': 0.2}).attributes()['tangentialDamping'] == 0.2
    with pytest.raises(ValueError, match='normalDamping = 0.06: follows from restitution = 0.8; only one can be given'):
        kind.checked({'normalDamping': 0.06, 'restitution': 0.8})
    with pytest.raises(ValueError, match='restitution = None: must be given, or else normalDamping'):
        kind.checked({'normalDamping': None, 'restitution': None})


def test_thePapersCasesKeepTheirNumbers():
    """Of Wang & Ji (2018): Cn = Ct = 0.1; of the other two: a restitution of 0.5, and its damping in both directions."""
    assert [ImpactParameters.checked({}).attributes()[name] for name in ('normalDamping', 'tangentialDamping')] == [0.1, 0.1]
    for kind in (DamperParameters, OedometerParameters):
        assert [kind.checked({}).attributes()[name] for name in ('normalDamping', 'tangentialDamping')] == [normalDampingFor(0.5)] * 2


@pytest.mark.parametrize('distribution, deviation', (('uniform', 0.3 / math.sqrt(3)), ('normal', 0.1)))
def test_sizesAreDrawnWithinTheSpread(distribution, deviation):
    """The cut at three standard deviations makes a normal distribution narrower by 1.3 %."""
    p = ImpactParameters.checked({'shape': 'sphere', 'radiusSpread': 0.3, 'radiusDistribution': distribution})
    radii = [shape.extents[0] / p.radius - 1 for shape in p.drawnShapes(4000, seed=2)]
    assert max(map(abs, radii)) <= 0.3 and p.smallestHalfSize == pytest.approx(0.7 * p.radius)
    assert math.sqrt(sum(r * r for r in radii) / 4000) == pytest.approx(deviation, rel=0.03)
    assert p.drawnShapes(3, seed=2) == p.drawnShapes(4000, seed=2)[:3] != p.drawnShapes(3, seed=5)


def test_equalSizesNeedNoDrawing():
    assert len(set(ImpactParameters.checked({}).drawnShapes(20, seed=1))) == 1


def test_softeningIsInTheDampersMaterialOnly():
    damper = DamperParameters.checked({'softening': 100})
    assert damper.attributes()['young'] == damper.young / 100
    assert ImpactParameters.checked({'pouringSoftening': 10}).attributes()['young'] == ImpactParameters.checked({}).young
    assert damper.smallestCriticalStep() == pytest.approx(10 * DamperParameters.checked({}).smallestCriticalStep())


def test_aMaterialIsCompleteByItself():
    assert Material.checked({'density': 1000}).criticalTimeStep(0.01) > 0
