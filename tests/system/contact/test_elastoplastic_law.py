"""The elastoplastic law in scenes: who meets whom, both interaction loops, restarts, and what goes on around."""
import math
import os
import random
import subprocess
import sys

import pytest
from project import LIMIT
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, ElastoplasticMat, ElastoplasticPhys, InsertionSortCollider, InteractionLoop

import yade.superquadric as sq
from yade.superquadric.scene.settling import setYoung

SIZE = 5e-3  # [m]
SOFT = dict(young=1e8, poisson=0.3, density=2500, frictionAngle=0.4, normalDamping=0.05, tangentialDamping=0.05, rollingFriction=0.02,
            rollingDamping=0.1, yieldStress=1e5, m0=2.5, exponent=1.8)  # of the material that yields, at a few cm/s


def engine(kind):
    return next(e for e in O.engines if isinstance(e, kind))


def onOneThread():
    for each in O.engines:
        if isinstance(each, (InteractionLoop, InsertionSortCollider)):
            each.ompThreads = 1


def bed(seed, number=40):
    """Cubes, other superquadrics and spheres that yield fall into a cylinder that does not."""
    O.reset()
    generator = random.Random(seed)
    soft, hard = ElastoplasticMat(**SOFT), CurvatureMat(young=1e8, poisson=0.2, density=2500, frictionAngle=0.3, rollingFriction=0.02)
    O.materials.append([soft, hard])
    sq.cylinderContainer(4 * SIZE, 1.0, hard)
    for i in range(number):
        center = 2.6 * SIZE * Vector3(i % 2 - 0.5, i // 2 % 2 - 0.5, 0.6 + i // 4)
        O.bodies.append(particle(i, center, generator, soft))
        O.bodies[-1].state.vel = Vector3(generator.uniform(-0.1, 0.1), generator.uniform(-0.1, 0.1), -1)
    O.engines = sq.superquadricEngines()
    onOneThread()
    O.trackEnergy = True
    O.dt = 0.1 * sq.criticalTimeStep()


def particle(i, center, generator, material):
    if i % 3 == 0:
        return utils.sphere(center, 0.7 * SIZE, material=material)
    exponent = 8 if i % 3 == 1 else generator.uniform(2, 5)
    return sq.superquadric(center, (0.7 * SIZE,) * 3, exponent, exponent, material, sq.randomOrientation(generator))


def withStockLoop():
    """YADE's own loop in the place of the superquadrics', with the same functors."""
    current = engine(InteractionLoop)
    functors = [dispatcher.functors for dispatcher in (current.geomDispatcher, current.physDispatcher, current.lawDispatcher)]
    O.engines = [InteractionLoop(*functors, loopOnSortedInteractions=True) if each == current else each for each in O.engines]
    onOneThread()


def condition():
    bodies = {b.id: tuple(map(tuple, (b.state.pos, b.state.vel, b.state.ori, b.state.angVel, b.state.angMom))) for b in O.bodies}
    contacts = {(i.id1, i.id2): plain(i.phys.dict()) for i in O.interactions}
    return bodies, contacts


def plain(attributes):
    return {name: tuple(value) if isinstance(value, Vector3) else value for name, value in attributes.items()}


def yielded():
    return sum(i.phys.residualOverlap > 0 for i in O.interactions)


@pytest.fixture(scope='module')
def uninterrupted(tmp_path_factory):
    """The condition at saving and at the end, the energies, and the files."""
    folder = tmp_path_factory.mktemp('saved')
    bed(seed=3)
    O.run(5000, wait=True)
    files = {kind: str(folder / f'bed.{kind}') for kind in ('yade.bz2', 'xml', 'bin')}
    for name in files.values():
        O.save(name)
    atSaving = condition(), yielded()
    O.run(1500, wait=True)
    return atSaving, condition(), dict(O.energy.items()), files


def test_the_bed_has_yielding_contacts_of_all_kinds_when_saved(uninterrupted):
    (_, contacts), number = uninterrupted[0]
    assert number > 20
    for attribute in ('shearElastic', 'rollingElastic', 'normalViscous', 'rollingViscous'):
        assert sum(any(phys[attribute]) for phys in contacts.values()) > 4, attribute
    assert uninterrupted[1][1] != contacts


@pytest.mark.parametrize('kind', ('yade.bz2', 'xml', 'bin'))
def test_a_loaded_bed_continues_bit_for_bit(uninterrupted, kind):
    atSaving, atEnd, energies, files = uninterrupted
    O.load(files[kind])
    assert condition() == atSaving[0]
    assert O.materials[0].exponent == SOFT['exponent'] and O.materials[0].yieldStress == SOFT['yieldStress']
    O.run(1500, wait=True)
    assert condition() == atEnd
    assert dict(O.energy.items()) == energies


def test_all_sinks_take_energy_in_a_bed(uninterrupted):
    for name in ('yieldDissip', 'normDampDissip', 'shearDampDissip', 'plastDissip', 'rollingDampDissip', 'rollingDissip'):
        assert uninterrupted[2][name] > 1e-7, name  # [J]; the bed had some 1e-2 J to lose


def test_both_loops_move_a_bed_alike():
    places = []
    for prepare in (lambda: None, withStockLoop):
        bed(seed=4)
        prepare()
        O.run(1500, wait=True)  # later, rounding grows
        assert yielded() > 5
        places.append([Vector3(b.state.pos) for b in O.bodies])
    assert max((a - b).norm() for a, b in zip(*places)) < 1e-6 * SIZE


def pushed(shape, partner, soft=True, hardPartner=True):
    """The contact of a particle that falls onto a partner, after it has yielded."""
    O.reset()
    yields = ElastoplasticMat(**{**SOFT, **({} if soft else dict(yieldStress=math.inf))})
    partnerMaterial = CurvatureMat(young=1e8, poisson=0.3, density=2500) if hardPartner else yields
    at = Vector3(0, 0, 1.0001 * SIZE)
    if partner == 'wall':
        O.bodies.append(utils.wall(0, 2, material=partnerMaterial))
    elif partner == 'facet':
        O.bodies.append(utils.facet([(-0.1, -0.1, 0), (0.1, -0.1, 0), (0, 0.2, 0)], material=partnerMaterial))
    elif partner == 'cylinder':
        sq.cylinderContainer(0.05, 0.1, partnerMaterial)
        at = Vector3(0.05 - 1.0001 * SIZE, 0, 0.05)
    else:
        O.bodies.append(utils.sphere((0, 0, -SIZE), SIZE, material=partnerMaterial, fixed=True))
    cube = shape == 'cube'
    body = O.bodies[O.bodies.append(sq.superquadric(at, (SIZE,) * 3, 8, 8, yields) if cube else utils.sphere(at, SIZE, material=yields))]
    body.state.vel = Vector3(0.5, 0, 0) if partner == 'cylinder' else Vector3(0, 0, -0.5)
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
    O.dt = 0.1 * sq.criticalTimeStep()
    for _ in range(100):
        O.step()
        contacts = list(O.interactions)
        if contacts and (contacts[0].phys.residualOverlap > 0 or not soft):
            return contacts[0].phys
    raise AssertionError('no contact that yields')


@pytest.mark.parametrize('hardPartner', (True, False))
@pytest.mark.parametrize('partner', ('wall', 'facet', 'cylinder', 'sphere'))
@pytest.mark.parametrize('shape', ('sphere', 'cube'))
def test_particles_yield_at_every_kind_of_partner(shape, partner, hardPartner):
    phys = pushed(shape, partner, hardPartner=hardPartner)
    assert isinstance(phys, ElastoplasticPhys)
    assert phys.yieldStress == SOFT['yieldStress'] and phys.exponent == SOFT['exponent']
    assert phys.rollingDamping == SOFT['rollingDamping'] / (2 if hardPartner else 1)
    assert phys.plasticDissipation > 0


def test_what_never_yields_leaves_no_dent():
    assert pushed('sphere', 'wall', soft=False).residualOverlap == 0


def lawOf(engines):
    return type(engine(InteractionLoop).lawDispatcher.functors[0]).__name__


def test_the_law_follows_from_the_materials():
    O.reset()
    elastic, yields = CurvatureMat(young=1e8, poisson=0.3, density=2500), ElastoplasticMat(**SOFT)
    O.bodies.append(utils.sphere((0, 0, 0), SIZE, material=elastic))
    expected = {None: 'HertzMindlin', 'curvature': 'HertzMindlin', 'elastoplastic': 'LoadingUnloading'}
    for law, name in expected.items():
        O.engines = sq.superquadricEngines(law=law)
        assert lawOf(O.engines).endswith(name)
    O.bodies.append(utils.sphere((0, 0, 1), SIZE, material=yields))
    for law in (None, 'elastoplastic'):
        O.engines = sq.superquadricEngines(law=law)
        assert lawOf(O.engines).endswith('LoadingUnloading')
    with pytest.raises(ValueError, match="law = 'curvature': it knows no yielding, but body 1 .* yieldStress = 100000 Pa"):
        sq.superquadricEngines(law='curvature')
    yields.yieldStress = math.inf
    sq.superquadricEngines(law='curvature')
    with pytest.raises(ValueError, match="law = 'plastic': must be one of curvature, elastoplastic"):
        sq.superquadricEngines(law='plastic')
    assert sq.criticalTimeStep([O.bodies[1]]) == yields.criticalTimeStep(SIZE)


LATER = """
from yade.wrapper import CurvatureMat, ElastoplasticMat
import yade.superquadric as sq
from yade.superquadric.scene.settling import setYoung
O.bodies.append(utils.wall(0, 2, material=CurvatureMat(young=1e8, poisson=0.3, density=2500)))
O.engines = sq.superquadricEngines()
soft = ElastoplasticMat(young=1e8, poisson=0.3, density=2500, yieldStress=1e5, m0=2.5, exponent=1.8)
O.bodies.append(sq.superquadric((0, 0, 0.0049), (0.005,) * 3, 8, 8, soft))
O.dt = 1e-6
O.step()
print('it went on')
"""


def test_a_material_that_yields_never_meets_the_law_that_does_not_know_it(tmp_path):
    """A body that came after the engines: YADE's process ends, with a message."""
    script = tmp_path / 'later.py'
    script.write_text(LATER)
    command = [sys.executable, sys.yade_argv[0], '-n', '-x', str(script)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT, cwd=tmp_path, env={**os.environ, 'OMP_NUM_THREADS': '1'})
    assert 'it went on' not in done.stdout
    assert 'an ElastoplasticMat that yields needs Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys' in done.stdout + done.stderr


def test_a_contact_that_yields_cannot_be_given_another_stiffness():
    O.reset()
    material = ElastoplasticMat(**SOFT)
    O.materials.append(material)
    O.bodies.append(utils.sphere((0, 0, 0), SIZE, material=material))
    for change in (lambda: sq.scaleStiffness(2), lambda: setYoung(O.bodies[0], 1e9)):
        with pytest.raises(ValueError, match=r'body 0: its material yields \(yieldStress = 100000 Pa\)'):
            change()
    assert material.young == SOFT['young'] and len(O.materials) == 1


def test_an_impactor_keeps_the_law_of_its_material():
    material = ElastoplasticMat(**SOFT)
    elastic = ElastoplasticMat(**{**SOFT, 'yieldStress': math.inf})
    peaks = [sq.bareImpact(0.02, 2500, each, 1.0, 0.0).pulse.peak for each in (material, elastic)]
    assert peaks[0] < 0.7 * peaks[1]
