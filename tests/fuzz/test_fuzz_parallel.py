"""Scenes for several processes, in one: any arguments are taken or refused by name before a step is done."""
import math

import pytest
from fuzzing import anything, fuzz, refused
from hypothesis import strategies as st
from yade import O
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.scene import parallel


def scene():
    """Two particles in a cylinder; body 3 is erased."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    O.materials.append(material)
    sq.cylinderContainer(0.05, 0.1, material)
    for z in (5e-3, 0.02, 0.04):
        O.bodies.append(sq.superquadric((0, 0, z), (5e-3,) * 3, 8, 8, material))
    O.bodies.erase(3)
    O.engines, O.dt = sq.superquadricEngines(), 1e-9


@pytest.fixture(scope='module', autouse=True)
def alone():
    """One process; what parallel remembers of this one is taken back."""
    assert parallel.ranks() == 1 and parallel.rank() == 0
    yield
    parallel.Totals.begun = parallel.Totals.ended = False
    parallel.Totals._all.clear()


def few(steps):
    """What a run of is short, if it is accepted."""
    return steps if not isinstance(steps, (int, float)) or not 50 < steps <= 1e15 else 3


@fuzz(weight=3, steps=anything, rebalanceEvery=st.one_of(st.just(0), anything))
def test_runs(steps, rebalanceEvery):
    scene()
    before, asked = O.iter, few(steps)
    _, no = refused(lambda: parallel.run(asked, rebalanceEvery), 'steps', 'rebalanceEvery')
    assert O.iter - before == (0 if no else int(float(asked)))


@fuzz(weight=3, supports=st.one_of(st.just([0, 1]), st.lists(st.integers(-1, 6), max_size=3), anything), every=st.one_of(st.just(1), anything))
def test_totals(supports, every):
    scene()
    before = len(parallel.Totals._all)
    totals, no = refused(lambda: parallel.Totals(supports, every), 'supports', 'every')
    if no:
        assert len(O.engines) == 4 and len(parallel.Totals._all) == before
        return
    parallel.run(3)
    assert len(totals.rows) == 3 // int(float(every))
    assert all(row['bodies'] == 2 and all(map(math.isfinite, (*row['force'], *row['momentum']))) for row in totals.rows)


@fuzz(weight=2, forGood=anything)
def test_merging(forGood):
    scene()
    parallel.Totals([0])
    _, no = refused(lambda: parallel.merge(forGood), 'forGood')
    assert len(O.engines) == (5 if no or str(forGood).lower() != 'true' else 4)
