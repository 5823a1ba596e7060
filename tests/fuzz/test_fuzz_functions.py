"""The functions of the package under any arguments: a right answer, or a ValueError or TypeError before the scene is changed."""
import math
import random

from fuzzing import anything, exponent, fuzz, number, ratio, refused, size, vector
from hypothesis import strategies as st
from yade import O
from yade.wrapper import CurvatureMat, ElastoplasticMat

import yade.superquadric as sq
from yade.superquadric.scene import restitution, settling

SEVERAL = st.integers(0, 255)  # bits: which arguments are replaced by good ones


def scene():
    """A cylinder with two particles in it. Returns the material and the container."""
    O.reset()
    material = CurvatureMat(young=1e8, poisson=0.2, density=2500, frictionAngle=0.4)
    O.materials.append(material)
    container = sq.cylinderContainer(0.05, 0.1, material)
    for z in (5e-3, 0.02):
        O.bodies.append(sq.superquadric((0, 0, z), (5e-3,) * 3, 8, 8, material))
    return material, container


def condition():
    """What nobody may change who refuses his arguments."""
    return len(O.bodies), len(O.materials), [material.dict() for material in O.materials], O.dt, O.iter, len(O.engines)


def mixed(given, good, keep):
    """`given` with the entries whose bit is set in `keep` replaced by those of `good`."""
    return {name: good[name] if name in good and keep >> bit & 1 else value for bit, (name, value) in enumerate(given.items())}


def unchanged(call, *names, also=()):
    before = condition()
    answer, no = refused(call, *names, also=also)
    if no:
        assert condition() == before
    return answer, no


@fuzz(weight=2, radius=anything, height=anything, largest=st.one_of(st.just(0), anything), box=st.booleans())
def test_containers(radius, height, largest, box):
    material, _ = scene()
    if box:
        container, no = unchanged(lambda: sq.boxContainer(radius, height, radius, material, largest), 'width', 'depth', 'height', 'largestParticle')
    else:
        container, no = unchanged(lambda: sq.cylinderContainer(radius, height, material, largest), 'radius', 'height', 'largestParticle')
    if not no:
        assert math.isfinite(container.height) and len(O.bodies) == 4 + (5 if box else 2)


@fuzz(material=anything)
def test_containersOfAnyMaterial(material):
    """YADE looks the material up, by number or label, and says in its own way that there is none."""
    scene()
    unchanged(lambda: sq.cylinderContainer(0.1, 0.1, material), also=(IndexError, KeyError, OverflowError, RuntimeError))


@fuzz(weight=2, gravity=vector, verletDist=anything, damping=anything,
      law=st.one_of(st.sampled_from(('curvature', 'elastoplastic')), anything), keep=SEVERAL)
def test_engines(gravity, verletDist, damping, law, keep):
    scene()
    given = {'gravity': gravity, 'verletDist': verletDist, 'damping': damping, 'law': law}
    given = mixed(given, {'gravity': (0, 0, -9.81), 'verletDist': 1e-3, 'damping': 0.1, 'law': None}, keep)
    engines, no = unchanged(lambda: sq.superquadricEngines(**given), *given)
    if not no:
        assert all(map(math.isfinite, engines[-1].gravity)) and 0 <= engines[-1].damping < 1


@fuzz(dt=anything)
def test_timeSteps(dt):
    scene()
    answer, no = unchanged(lambda: sq.checkTimeStep(dt), 'dt')
    assert no or 0 < answer <= sq.criticalTimeStep()


@fuzz(weight=2, thickness=anything, solidFraction=st.one_of(st.none(), anything), radius=size, aspect=ratio, n=exponent)
def test_particleNumbers(thickness, solidFraction, radius, aspect, n):
    _, container = scene()
    shape = sq.particleShape('block', radius, aspect, n, n)
    answer, no = unchanged(lambda: sq.particleNumber(thickness, shape, container, solidFraction), 'thickness', 'solidFraction')
    assert no or (isinstance(answer, int) and answer >= 1)


@fuzz(weight=2,
      shapes=st.one_of(st.lists(st.builds(lambda r, a: sq.particleShape('block', r, a), st.floats(1e-3, 2e-2), ratio), max_size=6), anything),
      seed=anything, speed=anything, solidFraction=anything, gap=anything, sideways=anything, keep=SEVERAL)
def test_rain(shapes, seed, speed, solidFraction, gap, sideways, keep):
    material, _ = scene()
    O.bodies.erase(2), O.bodies.erase(3)
    container = sq.boxContainer(0.08, 0.06, 0.5, material)
    given = {'seed': seed, 'speed': speed, 'solidFraction': solidFraction, 'gap': gap, 'sideways': sideways}
    given = mixed(given, {'seed': 3, 'speed': 0.5, 'solidFraction': 0.5, 'gap': 0.1, 'sideways': 1}, keep)
    filled, no = unchanged(lambda: sq.rainFilling(shapes, container, material, **given), *given, 'shapes', 'container', 'number of particles')
    if no:
        return
    ids, _ = filled
    assert len(ids) == len(shapes)
    for i in ids:
        assert all(map(math.isfinite, (*O.bodies[i].state.pos, *O.bodies[i].state.vel)))
        reach = O.bodies[i].shape.boundingRadius()
        assert O.bodies[i].state.pos[2] >= reach * (1 - 1e-9) and abs(O.bodies[i].state.pos[0]) <= 0.04 - reach * (1 - 1e-9)


IMPACT = {'diameter': 0.02, 'density': 3000, 'speed': 5, 'dropHeight': 0.3, 'surface': 0.03, 'gravity': 9.81, 'place': (0, 0)}


@fuzz(weight=2, values=st.fixed_dictionaries(dict.fromkeys(IMPACT, anything)), keep=SEVERAL,
      obstacles=st.one_of(st.just([2, 3]), st.just([]), anything))
def test_impactors(values, keep, obstacles):
    material, _ = scene()
    given = mixed(values, IMPACT, keep)
    impactor, no = unchanged(lambda: sq.addImpactor(material=material, obstacles=obstacles, **given), *given, 'obstacles', also=IndexError)
    if not no:
        assert all(map(math.isfinite, (*O.bodies[impactor].state.pos, *O.bodies[impactor].state.vel, O.bodies[impactor].state.mass)))


@fuzz(weight=0.5, name=st.sampled_from(('diameter', 'density', 'speed', 'dropHeight', 'gravity', 'baseYoung')),
      value=st.sampled_from((math.nan, math.inf, -math.inf, -1.0, 1e60, 10 ** 400, 'x', [], {}, True, 1j, b'1')))
def test_bareImpacts(name, value):
    """Values that are refused only: an impact of a grain of dust takes as many time steps as it has to."""
    material, _ = scene()
    O.engines = sq.superquadricEngines()
    given = {**{key: IMPACT[key] for key in ('diameter', 'density', 'speed', 'dropHeight', 'gravity')}, 'baseYoung': None, name: value}
    assert unchanged(lambda: sq.bareImpact(material=material, **given), name, 'height')[1]


@fuzz(weight=2, times=st.lists(number, max_size=8), forces=st.lists(number, max_size=8), static=number)
def test_pulses(times, forces, static):
    measured, no = refused(lambda: sq.pulse(times, forces, static), 'times', 'forces', 'staticForce')
    if not no:
        assert measured.start <= measured.peakTime <= measured.end and measured.peak > 0


KEYS = ('name', 'young', 'poisson', 'density', 'yieldStress', 'hardening', 'source', 'other')
HARDENING = ('referenceRadius', 'm0', 'm1', 'm2', 'exponent', 'smallestRatio', 'largestRatio', 'other')
GOOD = {'young': 7e10, 'poisson': 0.3, 'density': 2700, 'yieldStress': 3e8, 'name': 'm',
        'hardening': {'referenceRadius': 1e-3, 'm0': 2.6, 'm1': 0.1, 'm2': 0.0, 'exponent': 1.5}}


@fuzz(weight=2, change=st.dictionaries(st.sampled_from(KEYS), anything, max_size=2),
      inner=st.dictionaries(st.sampled_from(HARDENING), anything, max_size=2),
      missing=st.sampled_from((*KEYS, None, None)),
      others=st.dictionaries(st.sampled_from(('frictionAngle', 'label', 'density', 'nothing')), anything, max_size=1))
def test_materials(change, inner, missing, others):
    given = {**GOOD, 'hardening': {**GOOD['hardening'], **inner}, **change}
    given.pop(missing, None)
    names = [*GOOD, *given, *HARDENING, *others, str(missing), 'material', 'Radius', 'Ratio']
    material, no = refused(lambda: sq.elastoplasticMat(given, **others), *names, also=OverflowError)
    assert no or isinstance(material, ElastoplasticMat) and 0 < material.young < math.inf


@fuzz(material=anything)
def test_materialsByName(material):
    refused(lambda: sq.elastoplasticMat(material), 'material', 'is missing', 'hardening', 'there is no')


@fuzz(weight=2, value=anything)
def test_restitution(value):
    damping, no = refused(lambda: sq.normalDampingFor(value), 'restitution')
    assert no or (0 <= damping < 1 and abs(restitution.restitutionOf(damping) - float(value)) < 1e-9)


@fuzz(quiet=anything, support=anything, ids=st.one_of(st.just([2, 3]), anything), supports=st.one_of(st.just([0, 1]), anything))
def test_restCriteria(quiet, support, ids, supports):
    scene()
    O.engines = sq.superquadricEngines()
    O.dt = 1e-7
    O.step()
    criterion, no = unchanged(lambda: sq.RestCriterion(ids, supports, quiet, support), 'quiet', 'support', 'ids', also=IndexError)
    if not no:
        refused(criterion.check, 'ids', 'support', also=IndexError)


@fuzz(factor=anything, young=anything)
def test_stiffnesses(factor, young):
    scene()
    O.engines = sq.superquadricEngines()
    unchanged(lambda: sq.scaleStiffness(factor), 'factor', 'young')
    unchanged(lambda: settling.setYoung(O.bodies[0], young), 'young')
    assert all(0 < material.young < math.inf for material in O.materials)


@fuzz(weight=0.5, voxel=st.one_of(st.none(), anything), ids=st.one_of(st.just([2, 3]), anything), height=anything)
def test_beds(voxel, ids, height):
    _, container = scene()
    unchanged(lambda: sq.setHeight(container, height), 'height')
    bed, no = unchanged(lambda: sq.measureBed(sq.Snapshot.ofBodies(ids), container, voxel), 'voxel', 'snapshot', 'ids', also=IndexError)
    if not no:
        assert 0 <= bed['thickness'] < math.inf


@fuzz(steps=anything, seed=st.integers(0, 9))
def test_steppersAndOrientations(steps, seed):
    scene()
    O.engines = sq.superquadricEngines()
    O.dt = 1e-9
    few = steps if not isinstance(steps, (int, float)) or not 50 < steps < 1e60 else 3
    before = O.iter
    _, no = refused(lambda: sq.Stepper(stream=None).run(few), 'steps')
    assert O.iter - before == (0 if no else int(float(few)))
    assert abs(sq.randomOrientation(random.Random(seed)).norm() - 1) < 1e-14
