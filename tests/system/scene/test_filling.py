"""Shapes of equal volume, and the rain filling: no overlap at the start, seeded, refused when it does not fit."""
import math
import random

import pytest
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.experiments.impact.pouring import nextCount
from yade.superquadric.scene import memory

MATERIAL = dict(young=1e7, poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1,
                tangentialDamping=0.1, rollingFriction=0.002)
FAMILY = [('sphere', 1.0), ('ellipsoid', 1.5), ('cylinder', 1.0), ('cylinder', 3.0), ('cube', 1.0), ('block', 0.4)]


@pytest.fixture
def material():
    O.reset()
    result = CurvatureMat(**MATERIAL)
    O.materials.append(result)
    return result


def fill(material, shape, number, seed=3, radius=0.05, height=0.3):
    container = sq.cylinderContainer(radius, height, material)
    return sq.rainFilling([shape] * number, container, material, seed)


def poses(ids):
    states = [O.bodies[i].state for i in ids]
    return [tuple(s.pos) + tuple(s.ori) for s in states]


def test_halfSizeOfTheStudysCube():
    # 4.115 mm: shared parameters of the study, from the Beta function.
    assert sq.equalVolumeExtents(5e-3, 8, 8) == pytest.approx((4.1146e-3,) * 3, rel=1e-4)


@pytest.mark.parametrize('name, aspect', FAMILY)
def test_allShapesHaveTheSameMass(material, name, aspect):
    shape = sq.particleShape(name, 5e-3, aspect)
    body = shape.body(Vector3.Zero, sq.randomOrientation(random.Random(1)), material)
    assert body.state.mass == pytest.approx(2500 * 4 / 3 * math.pi * 5e-3 ** 3, rel=1e-12)
    assert shape.extents[2] / shape.extents[0] == pytest.approx(aspect)


def test_asphericalFollowsTheInertia(material):
    assert not sq.superquadric((0, 0, 0), (1e-3,) * 3, 8, 8, material).aspherical
    assert sq.superquadric((0, 0, 0), (1e-3, 1e-3, 2e-3), 8, 8, material).aspherical


@pytest.mark.parametrize('name, aspect', FAMILY)
def test_noOverlapAtTheStart(material, name, aspect):
    shape = sq.particleShape(name, 5e-3, aspect)
    ids, container = fill(material, shape, 120)
    centers = [O.bodies[i].state.pos for i in ids]
    nearest = min((p - q).norm() for k, p in enumerate(centers) for q in centers[:k])
    assert nearest > 2 * shape.boundingRadius
    assert max(math.hypot(p[0], p[1]) for p in centers) <= container.radius - shape.boundingRadius
    assert min(p[2] for p in centers) > shape.boundingRadius
    assert max(p[2] for p in centers) + shape.boundingRadius <= container.height * (1 + 1e-12)
    velocities = [O.bodies[i].state.vel for i in ids]
    assert all(v[2] == -0.5 and math.hypot(v[0], v[1]) <= 1.0 for v in velocities)


def test_sameSeedSameBedAnotherSeedAnother(material):
    shape = sq.particleShape('cube')
    beds = []
    for seed in (7, 7, 8):
        O.reset()
        O.materials.append(material)
        beds.append(poses(fill(material, shape, 80, seed)[0]))
    assert beds[0] == beds[1]
    assert beds[0] != beds[2]


def test_orientationsAreUniform():
    """The images of each axis have mean 0 and covariance 1/3, within four standard errors."""
    rng, number = random.Random(5), 4000
    for axis in (Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)):
        images = [sq.randomOrientation(rng) * axis for _ in range(number)]
        for k in range(3):
            mean = sum(v[k] for v in images) / number
            square = sum(v[k] ** 2 for v in images) / number
            assert abs(mean) < 4 * math.sqrt(1 / 3 / number)
            assert abs(square - 1 / 3) < 4 * math.sqrt(4 / 45 / number)


def test_rainAboveTheRimRaisesTheContainerForTheTime(material):
    ids, container = fill(material, sq.particleShape('cube'), 500, height=0.12)
    assert container.height > 0.12
    side = O.bodies[container.sideIds[0]]
    assert side.shape.height == container.height and side.state.pos[2] == container.height / 2
    sq.setHeight(container, 0.1)
    assert side.shape.height == pytest.approx(0.1) and side.state.pos[2] == pytest.approx(0.05)


def test_overfullContainerIsRefusedBeforeAnyBodyIsAdded(material):
    container = sq.cylinderContainer(0.05, 0.1, material)
    before = len(O.bodies)
    with pytest.raises(ValueError, match=r'number of particles = 5000: overfull'):
        sq.rainFilling([sq.particleShape('cube')] * 5000, container, material, seed=1)
    assert len(O.bodies) == before


def test_boxFilling(material):
    container = sq.boxContainer(0.08, 0.05, 0.2, material)
    shape = sq.particleShape('cube')
    ids, _ = sq.rainFilling([shape] * 60, container, material, seed=2)
    for i in ids:
        x, y, _ = O.bodies[i].state.pos
        assert abs(x) <= 0.04 - shape.boundingRadius and abs(y) <= 0.025 - shape.boundingRadius


def test_measuresOfAKnownBed(material):
    """Cubes that tile a box: thickness and packing fraction follow from the sizes alone."""
    container = sq.boxContainer(0.04, 0.04, 0.1, material)
    half = 5e-3
    ids = O.bodies.append([sq.superquadric((x, y, z), (half,) * 3, 20, 20, material)
                           for x in (-15e-3, -5e-3, 5e-3, 15e-3) for y in (-15e-3, -5e-3, 5e-3, 15e-3)
                           for z in (5e-3, 15e-3)])
    bed = sq.measureBed(sq.Snapshot.ofBodies(ids), container, voxel=2.5e-4)
    solid = sum(O.bodies[i].state.mass for i in ids) / 2500
    assert bed['thickness'] == pytest.approx(0.02, rel=0.04)  # rounded edges take a little off the mean level
    assert bed['packingFraction'] == pytest.approx(solid / (0.04 ** 2 * bed['thickness']), rel=1e-9)


def pours(*numbersAndThicknesses):
    return [{'number': number, 'thickness': thickness} for number, thickness in numbersAndThicknesses]


def test_nextNumberOfParticlesToPour():
    assert nextCount(pours((100, 0.0102)), 0.01, 0.03) is None
    assert nextCount(pours((100, 0.0125)), 0.01, 0.03) == 80
    assert nextCount(pours((100, 0.0125), (80, 0.0098)), 0.01, 0.03) is None


def test_bestPourIsRepeatedWhenNoNumberIsLeft():
    """80 and 84 ask for each other; 80 is nearer."""
    turns = pours((80, 0.0095), (84, 0.0106))
    assert nextCount(turns[:1], 0.01, 0.03) == 84 and round(84 * 0.01 / 0.0106) == 79
    six = turns + pours((79, 0.0088), (90, 0.013), (69, 0.0075), (92, 0.0135))
    assert nextCount(six, 0.01, 0.03) == 80
    assert nextCount(six + turns[:1], 0.01, 0.03) is None
    assert nextCount(pours((80, 0.0096), (84, 0.0105)), 0.01, 0.03) == 80 == round(84 * 0.01 / 0.0105)


def test_limitsOfAllControlGroupsCount(tmp_path, monkeypatch):
    """Those of the process's own and of all above it; the page cache is no loss."""
    job = tmp_path / 'slurm' / 'job'
    job.mkdir(parents=True)
    (tmp_path / 'cgroup').write_text('4:memory:/other\n0::/slurm/job\n')
    monkeypatch.setattr(memory, 'GROUPS', tmp_path)
    monkeypatch.setattr(memory, 'OWN', tmp_path / 'cgroup')
    monkeypatch.setattr(memory, 'MEMORY', tmp_path / 'nothing')
    assert memory.available() == math.inf

    def limit(group, most, used):
        for name, text in (('memory.max', most), ('memory.current', used), ('memory.stat', 'anon 5000\ninactive_file 300\nactive_file 40')):
            (group / name).write_text(f'{text}\n')

    limit(job, 'max', 7000)
    assert memory.available() == math.inf
    limit(job.parent, 10000, 9000)
    assert memory.available() == 1340
    limit(job, 8000, 7500)
    assert memory.available() == 840
    (tmp_path / 'meminfo').write_text('MemTotal: 9 kB\nMemAvailable:  0 kB\n')
    monkeypatch.setattr(memory, 'MEMORY', tmp_path / 'meminfo')
    assert memory.available() == 0


def test_moreThanTheMemoryHoldsIsRefused(material, monkeypatch):
    assert memory.available() > 1e6
    monkeypatch.setattr(memory, 'available', lambda: 200 * memory.BYTES_A_PARTICLE)
    container = sq.cylinderContainer(0.05, 0.3, material)
    before = len(O.bodies)
    with pytest.raises(ValueError, match='number of particles = 201: .* are available'):
        sq.rainFilling([sq.particleShape('cube', 2e-3)] * 201, container, material, seed=1)
    assert len(O.bodies) == before
    assert len(sq.rainFilling([sq.particleShape('cube', 2e-3)] * 200, container, material, seed=1)[0]) == 200
