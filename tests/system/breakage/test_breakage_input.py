"""Bad input of BreakableMat, BreakableState and BreakageEngine: a ValueError with name and value, and nothing has changed."""
import math
import re

import pytest
from breakagescene import RADIUS, breakAll, material, scatter
from yade import O, utils
from yade.wrapper import (
    BreakableMat,
    BreakableState,
    BreakageEngine,
    CurvatureMat,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_FrictMat_FrictMat_FrictPhys,
    Law2_ScGeom_FrictPhys_CundallStrack,
    State,
    Superquadric,
)

import yade.superquadric as sq

MATERIAL = dict(characteristicStrength=3e6, referenceSize=0.02, weibullModulus=4, smallestSize=1e-3)
BAD_MATERIAL = [('characteristicStrength', 0), ('characteristicStrength', -1), ('characteristicStrength', math.nan), ('referenceSize', 0),
                ('referenceSize', math.inf), ('weibullModulus', 0), ('weibullModulus', -3), ('weibullModulus', math.nan), ('smallestSize', -1e-9),
                ('smallestSize', math.nan)]
ENGINE = dict(criterion='force', mode='balls4', cutExponent=3, maxEvents=7, seed=5, smallestFragment=1e-4)
BAD_ENGINE = [('criterion', 'stress'), ('criterion', ''), ('mode', 'balls'), ('mode', 'Cube'), ('cutExponent', 0), ('cutExponent', -2),
              ('cutExponent', math.inf), ('maxEvents', 0), ('maxEvents', -1), ('seed', -1), ('smallestFragment', -1e-3),
              ('smallestFragment', math.nan), ('inertialSize', 1e31)]


@pytest.mark.parametrize('kind, good, name, value', [(BreakableMat, MATERIAL, *bad) for bad in BAD_MATERIAL]
                         + [(BreakageEngine, ENGINE, *bad) for bad in BAD_ENGINE])
def test_refusedValueIsNamedAndTheObjectStaysAsItWas(kind, good, name, value):
    thing = kind(**good)
    with pytest.raises(ValueError, match=f'{name} must be .*, got {re.escape(str(value))}'):
        setattr(thing, name, value)
    with pytest.raises(ValueError, match=f'{name} must be'):
        kind(**{name: value})
    assert {key: getattr(thing, key) for key in good} == good


@pytest.mark.parametrize('size, survival, name', [(0, 0.5, 'size'), (-1, 0.5, 'size'), (1, 0, 'survival'),
                                                  (1, 1, 'survival'), (1, math.nan, 'survival')])
def test_strengthOfNothingIsRefused(size, survival, name):
    with pytest.raises(ValueError, match=f'{name} must be'):
        BreakableMat(**MATERIAL).strength(size, survival)


def aBall(mat=None):
    """The id of one ball alone in a scene."""
    O.reset()
    return scatter([sq.particleShape('sphere', RADIUS)], mat or material(), seed=1)[0]


@pytest.mark.parametrize('missing', (-1, 1, 1000))
def test_bodiesThatAreNotThereCannotBreak(missing):
    aBall()
    with pytest.raises(ValueError, match=f'forced must be ids of bodies in the scene, got {missing}'):
        breakAll([0, missing])
    assert len(O.bodies) == 1 and O.bodies[0] is not None


@pytest.mark.parametrize('change', ('fixed', 'small', 'other material', 'fragments too small'))
def test_bodiesThatDoNotBreakAreNotForced(change):
    mat = CurvatureMat() if change == 'other material' else material(smallestSize=1 if change == 'small' else 0)
    ball = aBall(mat)
    O.bodies[ball].dynamic = change != 'fixed'
    with pytest.raises(ValueError, match='forced must be ids of particles that can break, got 0'):
        breakAll([ball], smallestFragment=1.01 * RADIUS if change == 'fragments too small' else 0)


@pytest.mark.parametrize('strength', (0, -1))
def test_strengthThatIsNotPositiveIsRefused(strength):
    ball = aBall()
    O.bodies[ball].state.strength = strength
    with pytest.raises(ValueError, match=f'strength must be positive, got {strength}'):
        breakAll([])


def test_stateOfAnotherMaterialIsRefused():
    ball = aBall()
    O.bodies[ball].state = State()
    with pytest.raises(RuntimeError, match='should be BreakableState'):  # YADE's own check
        breakAll([])


def test_superquadricsKnowNoBalls():
    O.reset()
    scatter([sq.particleShape('cube', RADIUS)], material(), seed=1)
    with pytest.raises(ValueError, match="mode must be 'cube' where superquadrics can break, got balls4"):
        breakAll([], mode='balls4')


def test_engineBehindTheColliderIsRefused():
    aBall()
    O.engines = [*sq.superquadricEngines(), BreakageEngine()]
    O.dt = 1e-9
    with pytest.raises(ValueError, match='BreakageEngine must stand before the collider'):
        O.step()


def test_lawThatWouldMakeFragmentsExplodeIsRefused():
    ball = aBall()
    O.engines = [BreakageEngine(forced=[ball]), InsertionSortCollider([]), InteractionLoop([], [Ip2_FrictMat_FrictMat_FrictPhys()],
                                                                                            [Law2_ScGeom_FrictPhys_CundallStrack()])]
    with pytest.raises(ValueError, match='CundallStrack cannot hold fragments'):
        O.step()
    assert len(O.bodies) == 1 and O.bodies[0] is not None


def test_materialMakesItsState():
    assert type(BreakableMat().newAssocState()) is BreakableState
    ball = aBall()
    assert math.isnan(O.bodies[ball].state.strength)
    body = sq.superquadric((0, 0, 0), (1, 1, 1), 2, 2, BreakableMat())
    assert type(body.state) is BreakableState and type(body.shape) is Superquadric


def test_breakableMaterialThatDoesNotYieldKeepsTheElasticLaw():
    aBall()
    assert 'HertzMindlin' in type(sq.superquadricEngines()[2].lawDispatcher.functors[0]).__name__
    O.bodies.append(utils.sphere((1, 1, 1), 1e-3, material=material(yieldStress=1e7, m0=2.6, exponent=2)))
    assert 'LoadingUnloading' in type(sq.superquadricEngines()[2].lawDispatcher.functors[0]).__name__


@pytest.mark.parametrize('settings, steps, name', [({}, 10, 'O.dt'), ({'cutExponent': 300}, 1e-6, 'smallestFragment')])
def test_aRefusedFragmentBreaksNothing(settings, steps, name):
    """Of two that are to break at one call, where the second (too small for O.dt), or both, cannot, neither does, and both are still asked for.
    `steps`: O.dt over the critical step of the small one."""
    O.reset()
    balls = scatter([sq.particleShape('sphere', radius) for radius in (RADIUS, RADIUS / 1e4)], material(), seed=1)
    breaker = BreakageEngine(forced=balls, **settings)
    O.engines, O.dt = [breaker], steps * sq.criticalTimeStep()
    with pytest.raises(ValueError, match=f'{name} must be'):
        O.step()
    assert [body.id for body in O.bodies if body] == balls and breaker.forced == balls and breaker.events() == [] and breaker.evenCuts == 0
