"""Solid in regions against Monte Carlo with the particles' own equation, in a bed with cut particles; bounds, limits and the voxels of measureBed."""
import math
import random

import numpy as np
import pytest
from yade import O
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq
from yade.superquadric.measure.bed import particleVolumes, voxelGrid
from yade.superquadric.measure.snapshot import gauge
from yade.superquadric.mesh import regions

RADIUS, HEIGHT, SIZE = 0.05, 0.06, 5e-3


def star(outer, inner, low, high):
    """A prism over a star of five points about the z axis, facing outward."""
    ring = [((inner if i % 2 else outer) * math.cos(math.pi * i / 5), (inner if i % 2 else outer) * math.sin(math.pi * i / 5)) for i in range(10)]
    points = [(x, y, z) for z in (low, high) for x, y in ring] + [(0, 0, low), (0, 0, high)]
    triangles = []
    for i in range(10):
        k = (i + 1) % 10
        triangles += [(i, k, 10 + k), (i, 10 + k, 10 + i), (k, i, 20), (10 + i, 10 + k, 21)]
    return sq.TriangleMesh(points, triangles, 'star')


def inStar(points, outer, inner, low, high):
    angle = np.abs((np.arctan2(points[:, 1], points[:, 0]) + math.pi / 5) % (2 * math.pi / 5) - math.pi / 5)
    radius = np.hypot(points[:, 0], points[:, 1])
    x, y = radius * np.cos(angle) - outer, radius * np.sin(angle)
    alongX, alongY = inner * math.cos(math.pi / 5) - outer, inner * math.sin(math.pi / 5)
    return (alongX * y - alongY * x >= 0) & (points[:, 2] >= low) & (points[:, 2] <= high)


@pytest.fixture(scope='module')
def bed():
    """300 particles of five shapes at random, in and across a cylinder."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500)
    rng = random.Random(8)
    shapes = [sq.particleShape('cube', SIZE), sq.particleShape('cylinder', SIZE, 1.5), sq.particleShape('ellipsoid', SIZE, 2.0),
              sq.particleShape('sphere', SIZE), sq.particleShape('block', SIZE, 0.5)]
    places = [Vector3(rng.uniform(-0.06, 0.06), rng.uniform(-0.06, 0.06), rng.uniform(-0.01, 0.07)) for _ in range(300)]
    bodies = [shapes[i % 5].body(place, sq.randomOrientation(rng), material) for i, place in enumerate(places)]
    return sq.Snapshot.ofBodies(O.bodies.append(bodies))


def monteCarlo(snapshot, inside, points=4000, seed=5):
    """Volume in the region and its standard error [m3], from points drawn in the box of each particle."""
    rng, volume, variance = np.random.default_rng(seed), 0.0, 0.0
    for i in range(len(snapshot)):
        half = snapshot.extents[i]
        local = half * rng.uniform(-1, 1, (points, 3))
        hits = np.sum((gauge(local, half, snapshot.exponents[i]) <= 1) & inside(local @ snapshot.rotations[i].T + snapshot.positions[i])) / points
        volume += 8 * half.prod() * hits
        variance += (8 * half.prod()) ** 2 * hits * (1 - hits) / points
    return volume, math.sqrt(variance)


STAR = (0.05, 0.025, 0.005, 0.05)
PLANES = (((1, 1, 0), 0.03), ((-1, 0.2, 0.5), 0.02))
CASES = {
    'box': (regions.Box((-0.03, -0.04, 0), (0.04, 0.03, 0.05)),
            lambda x: np.all((x >= (-0.03, -0.04, 0)) & (x <= (0.04, 0.03, 0.05)), axis=1)),
    'cylinder': (regions.Cylinder(RADIUS, (0, 0, 0), (0, 0, HEIGHT)),
                 lambda x: (np.hypot(x[:, 0], x[:, 1]) <= RADIUS) & (x[:, 2] >= 0) & (x[:, 2] <= HEIGHT)),
    'half spaces': (regions.HalfSpaces(PLANES, regions.Box((-0.05, -0.05, 0), (0.05, 0.05, 0.06))),
                    lambda x: np.all((np.abs(x[:, :2]) <= 0.05), axis=1) & (x[:, 2] >= 0) & (x[:, 2] <= 0.06)
                    & np.all([x @ np.array(n) / np.linalg.norm(n) <= d for n, d in PLANES], axis=0)),
    'mesh': (regions.Mesh(star(*STAR)), lambda x: inStar(x, *STAR)),
    'mesh up to a plane': (regions.HalfSpaces((((0.2, 0, 1), 0.03),), regions.Mesh(star(*STAR))),
                           lambda x: inStar(x, *STAR) & (x @ (0.2, 0, 1) <= 0.03 * math.hypot(0.2, 1)))}


@pytest.mark.parametrize('name', CASES)
def test_againstMonteCarlo(bed, name):
    region, inside = CASES[name]
    measured, (volume, error) = sq.solidVolume(bed, region), monteCarlo(bed, inside)
    assert measured.low <= measured.value <= measured.high
    assert measured.high - measured.low < 1e-2 * measured.value
    assert error < 3e-3 * volume
    assert measured.low - 3 * error <= volume <= measured.high + 3 * error


def test_theIntervalClosesWithTheAccuracy(bed):
    region = CASES['cylinder'][0]
    coarse, fine, finer = (sq.solidVolume(bed, region, accuracy) for accuracy in (3e-2, 5e-3, 1e-3))
    assert coarse.low <= fine.low <= finer.low <= finer.high <= fine.high <= coarse.high
    assert finer.high - finer.low < 2e-3 * finer.value


def test_tiltedCylinderInASphere():
    """A ball round a cylinder's middle: cap and body in closed form (a sphere with a cylindrical hole, napkin ring)."""
    O.reset()
    ball, hole = 0.02, 0.012
    snapshot = sq.Snapshot.ofBodies([O.bodies.append(sq.particleShape('sphere', ball).body(Vector3(1, 2, 3), sq.randomOrientation(random.Random(1)),
                                                                                          CurvatureMat()))])
    axis = 0.05 * np.array([1, 2, 2]) / 3
    cylinder = regions.Cylinder(hole, tuple(np.array([1, 2, 3]) - axis), tuple(np.array([1, 2, 3]) + axis))
    exact = 4 / 3 * math.pi * (ball ** 3 - (ball ** 2 - hole ** 2) ** 1.5)
    measured = sq.solidVolume(snapshot, cylinder, 1e-3)
    assert measured.low < exact < measured.high
    assert measured.value == pytest.approx(exact, rel=1e-3)


def test_wholeParticlesAreExact(bed):
    everything = regions.Box((-1, -1, -1), (1, 1, 1))
    measured = sq.solidVolume(bed, everything)
    assert measured == pytest.approx((particleVolumes(bed).sum(),) * 3, rel=1e-13)
    assert sq.packingFraction(bed, everything).value == pytest.approx(measured.value / 8)
    assert sq.solidVolume([], everything) == (0, 0, 0)
    assert sq.solidVolume([], CASES['cylinder'][0]) == (0, 0, 0)


def test_volumesOfRegions():
    assert regions.HalfSpaces((((1, 1, 1), 1 / math.sqrt(3)),), regions.Box((0, 0, 0), (1, 1, 1))).volume == pytest.approx(1 / 6)
    assert CASES['mesh'][0].volume == pytest.approx(5 * STAR[0] * STAR[1] * math.sin(math.pi / 5) * (STAR[3] - STAR[2]))
    upper = regions.HalfSpaces((((0, 0, -1), -0.02),), CASES['mesh'][0])
    assert upper.volume == pytest.approx(CASES['mesh'][0].volume * (STAR[3] - 0.02) / (STAR[3] - STAR[2]))
    surface = star(*STAR)
    assert regions.Mesh(sq.TriangleMesh(surface.points, surface.triangles[:, ::-1])).volume == pytest.approx(CASES['mesh'][0].volume)


def test_voxelsOfMeasureBed(bed):
    """The share of solid voxels, which measureBed counts in the inner part of a bed, is within the resolution of what clipping gives."""
    apart = sq.Snapshot(**{name: getattr(bed, name)[alone(bed)] for name in sq.Snapshot.ARRAYS})
    container = sq.Container(0, (), RADIUS, None, None, 0.1)
    filled, (x, y, z) = voxelGrid(apart, container, SIZE / 10)
    disc = np.hypot(*np.meshgrid(x, y, indexing='ij')) <= 0.03
    layers = (z > 0.01) & (z < 0.05)
    counted = filled[disc][:, layers].mean()
    low, high = z[layers][0] - SIZE / 20, z[layers][-1] + SIZE / 20
    clipped = sq.packingFraction(apart, regions.Cylinder(0.03, (0, 0, low), (0, 0, high)))
    assert clipped.high - clipped.low < 6e-3 * clipped.value
    assert counted == pytest.approx(clipped.value, rel=5e-3)


def alone(snapshot):
    """Which particles meet none of the others before them, by their bounding spheres: overlaps count once as voxels and twice as particles."""
    reach, kept = np.linalg.norm(snapshot.extents, axis=1), []
    for i, position in enumerate(snapshot.positions):
        if all(np.linalg.norm(position - snapshot.positions[k]) > reach[i] + reach[k] for k in kept):
            kept.append(i)
    return kept


@pytest.mark.parametrize('make, complaint', (
    (lambda: regions.Box((0, 0, 0), (1, -1, 1)), 'high = '), (lambda: regions.Cylinder(0, (0, 0, 0), (0, 0, 1)), 'radius = 0'),
    (lambda: regions.Cylinder(1, (0, 0, 1), (0, 0, 1)), 'top = '),
    (lambda: regions.HalfSpaces((((0, 0, 0), 1),), regions.Box((0, 0, 0), (1, 1, 1))), 'must not be zero'),
    (lambda: regions.HalfSpaces((), None), 'within = None'),
    (lambda: sq.packingFraction([], regions.HalfSpaces((((0, 0, 1), -1),), regions.Box((0, 0, 0), (1, 1, 1)))), 'region = .*: is empty'),
    (lambda: regions.Mesh(sq.TriangleMesh(star(*STAR).points, star(*STAR).triangles[1:], 'lid')), '^lid: 3 edges'),
    (lambda: sq.packingFraction([], regions.Box((0, 0, 0), (1, 1, 1)), accuracy=0), 'accuracy = 0')))
def test_badInput(make, complaint):
    with pytest.raises(ValueError, match=complaint):
        make()
