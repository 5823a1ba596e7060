"""Faces on faces and edges on edges: the contact point and the force follow a slow motion without a jump.

Continuous means: half the step, half the largest change. Besides, no step may move the point or the force by more than the motion accounts
for. Bodies are carried by hand, one engine step per place; forces are those of the law, without friction and damping.
"""
import math

import pytest
from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

import yade.superquadric as sq

HALF = 5e-3  # half size of the cubes [m]
OVERLAP = 1e-3 * HALF  # of the faces or edges when they lie flat on each other [m]
STILL = 1e-12  # a time step in which nothing moves [s]
X, Y, Z = Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)
ROUNDING = 1e-9  # of the point in half sizes, of the force relative to its largest


def turn(axis, angle):
    return Quaternion(axis.normalized(), angle)


FLAT = Quaternion.Identity
TILTS = {'flat': FLAT, 'tilted a little': turn(X + 2 * Y, 1e-4), 'tilted': turn(X + 2 * Y, 1e-2), 'turned in the plane': turn(Z, 0.3)}
EDGE_DOWN = turn(Y, math.pi / 4)  # a cube with an edge along y below and above


class Carried:
    """A cube carried over a floor with the exponent n: a wall, a fixed cube with a face up, or one with an edge up."""

    def __init__(self, floor, n):
        O.reset()
        material = CurvatureMat(young=1e9, poisson=0.2, density=2500)
        self.posture = EDGE_DOWN if floor == 'edge' else FLAT
        self.cube = sq.superquadric(10 * HALF * Z, (HALF,) * 3, n, n, material=material, fixed=True)
        self.reach = self.cube.shape.support(self.posture.conjugate() * Z)  # from the centre down [m]
        if floor == 'wall':
            base = utils.wall(0, axis=2, material=material)
        else:
            base = sq.superquadric(-self.reach * Z, (HALF,) * 3, n, n, material=material, orientation=self.posture, fixed=True)
        O.bodies.append([base, self.cube])
        O.engines = sq.superquadricEngines(gravity=(0, 0, 0))
        O.dt = STILL

    def contactAt(self, shift, rotation):
        """Contact point [m], force on the cube [N] and tangent stiffness [N/m] with the cube shifted and turned from where it rests
        flat in the middle."""
        self.cube.state.pos = shift + (self.reach - OVERLAP) * Z
        self.cube.state.ori = rotation * self.posture
        O.step()
        contact = O.interactions[0, 1]
        return Vector3(contact.geom.contactPoint), Vector3(O.forces.f(1)), contact.phys.kn


class Path:
    """Largest changes from one place to the next on a way through `steps` steps, from `motion(0)` to `motion(1)`."""

    def __init__(self, floor, n, motion, steps):
        cube = Carried(floor, n)
        contacts = [cube.contactAt(*motion(i / steps)) for i in range(steps + 1)]
        changes = [(after[0] - before[0], after[1] - before[1]) for before, after in zip(contacts, contacts[1:])]
        self.pointJump = max(point.norm() for point, _ in changes)
        self.forceJump = max(force.norm() for _, force in changes)
        self.force = max(force.norm() for _, force, _ in contacts)
        self.stiffness = max(stiffness for _, _, stiffness in contacts)


def checkContinuous(floor, n, motion, steps, travel, pointTravel):
    """Compare `steps` with twice as many.

    :param travel: of the cube's fastest surface point on the whole way [m]
    :param pointTravel: of the contact point, if it moved at its greatest speed all the way [m]
    """
    coarse, fine = Path(floor, n, motion, steps), Path(floor, n, motion, 2 * steps)
    # 2 %: the overlap, which sets the speed of the point, changes a little on the way.
    for path, parts in (coarse, steps), (fine, 2 * steps):
        assert path.pointJump <= 1.02 * pointTravel / parts + ROUNDING * HALF
        # As if all of the motion were approach.
        assert path.forceJump <= path.stiffness * travel / parts
    # Halves, with a tenth for how the changes per way differ along it: what jumps would not shrink at all.
    assert fine.pointJump <= 0.55 * coarse.pointJump + ROUNDING * HALF
    assert fine.forceJump <= 0.55 * coarse.forceJump + ROUNDING * coarse.force


@pytest.mark.parametrize('n', (8, 20))
@pytest.mark.parametrize('tilt', TILTS)
@pytest.mark.parametrize('floor', ('wall', 'cube'))
def test_a_sliding_face_carries_its_contact_along(floor, tilt, n):
    way = Vector3(HALF, 0.2 * HALF, 0)

    # On a wall the contact goes with the cube; between cubes it lies between where either would carry it.
    checkContinuous(floor, n, lambda s: ((s - 0.5) * way, TILTS[tilt]), 200, way.norm(), way.norm())


def swing(floor, angle):
    """Travel [m] of the contact point when a flat face turns by `angle` as if it stayed flat on the floor all the while: pkg/geometry/Tolerances.hpp,
    `centring`: by a^2/(2 d) on a plane, a^2/(4 d) between equal cubes."""
    return angle * HALF ** 2 / ((2 if floor == 'wall' else 4) * OVERLAP)


def farthest(angle):
    """Travel [m] of the corners."""
    return angle * math.sqrt(3) * HALF


@pytest.mark.parametrize('n', (8, 20))
@pytest.mark.parametrize('axis', (Y, X + 0.3 * Y, X + Y), ids=('about an edge', 'askew', 'about a diagonal'))
@pytest.mark.parametrize('floor', ('wall', 'cube'))
def test_a_face_that_turns_through_flat_moves_its_contact_over_the_face(floor, axis, n):
    place, angle = Vector3(0.1 * HALF, 0.05 * HALF, 0), 2e-2
    checkContinuous(floor, n, lambda s: (place, turn(axis, (s - 0.5) * angle)), 400, farthest(angle), swing(floor, angle))


@pytest.mark.parametrize('n', (8, 20))
@pytest.mark.parametrize('steps', (39, 40))  # 40 and 80 pass through exactly flat, 39 does not
@pytest.mark.parametrize('angle', (2e-4, 2e-6, 2e-9, 2e-12))
@pytest.mark.parametrize('floor', ('wall', 'cube'))
def test_nothing_happens_at_flat_itself(floor, angle, steps, n):
    place = 0.1 * HALF * X
    checkContinuous(floor, n, lambda s: (place, turn(X + 0.3 * Y, (s - 0.5) * angle)), steps, farthest(angle), swing(floor, angle))


@pytest.mark.parametrize('n', (8, 20))
def test_parallel_edges_that_slide_along_each_other(n):
    checkContinuous('edge', n, lambda s: ((s - 0.5) * HALF * Y, FLAT), 200, HALF, HALF)


@pytest.mark.parametrize('n', (8, 20))
def test_parallel_edges_that_slide_over_each_other(n):
    way = 0.02 * HALF  # rounded as they are, they part beyond
    checkContinuous('edge', n, lambda s: (0.2 * HALF * Y + (s - 0.5) * way * X, FLAT), 200, way, way)


@pytest.mark.parametrize('n', (8, 20))
def test_parallel_edges_that_rock(n):
    angle = 2e-2
    checkContinuous('edge', n, lambda s: (0.2 * HALF * Y, turn(X, (s - 0.5) * angle)), 400, farthest(angle), swing('edge', angle))


@pytest.mark.parametrize('n', (8, 20))
def test_parallel_edges_that_come_to_cross(n):
    """One cube is shifted by s = 0.2 half sizes along the edges. While these are parallel the contact is in the middle of both cubes, s/2 from each
    centre; when they cross at an angle w, it goes to the crossing, below the centre of the cube that turns.

    For cylinders of radius R, which lose d by (w y)^2/(4 R) a way y from the crossing, the objective of pkg/detection/PairProblem.hpp is
    smallest at y = (s/2)/(1 + w^2/(8 R d/a^2)): its steepest change is 3 sqrt(3)/8 (s/2)/sqrt(8 R d/a^2).
    """
    shift, angle = 0.2 * HALF, 2e-2
    edgeRadius = math.sqrt(2) * 2 ** (-1 / n) / (n - 1) * HALF  # of |x/a|^n + |z/a|^n = 1 on its diagonal
    speed = 3 * math.sqrt(3) / 8 * shift / 2 / math.sqrt(8 * edgeRadius * OVERLAP / HALF ** 2)
    checkContinuous('edge', n, lambda s: (shift * Y, turn(Z, (s - 0.5) * angle)), 400, farthest(angle), speed * angle)
