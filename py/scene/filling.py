"""Rain filling: particles of random orientation, laid out without overlap above the base, then left to fall."""
import math
import random

from yade import O
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import Sphere, Superquadric

from .. import checks
from . import container as containers, memory
from .bodies import ParticleShape

GAP, SIDEWAYS = 0.08, 2.0  # of rainFilling, by default
DEEP_FRACTION = 0.622  # packing fraction of poured beds of many layers, with the thickness as seen from above, ...
LAYER_FRACTION = 0.12  # ... and what it gains times d/H (d: diameter of equal volume): fitted to beds of spheres, cylinders and
                       # cubes of H = 0.8 to 9.5 cm. It only serves to choose a number, and is within 7 % there
DENSEST = 0.9          # no poured bed comes near it; a container asked to hold more is overfull without doubt


def randomOrientation(rng):
    """A rotation drawn uniformly from all rotations (Shoemake 1992). `rng`: random.Random."""
    u1, u2, u3 = rng.random(), 2 * math.pi * rng.random(), 2 * math.pi * rng.random()
    s, t = math.sqrt(1 - u1), math.sqrt(u1)
    return Quaternion(t * math.cos(u3), s * math.sin(u2), s * math.cos(u2), t * math.sin(u3))


def expectedFraction(thickness, volume):
    """Expected packing fraction of a poured bed of `thickness` [m] whose particles have the mean `volume` [m3]."""
    diameter = (6 * volume / math.pi) ** (1 / 3)
    return min(DEEP_FRACTION + LAYER_FRACTION * diameter / thickness, DENSEST)


def particleNumber(thickness, shape, container, solidFraction=None):
    """How many particles make a bed of `thickness` [m]: solidFraction * area * thickness / particle volume.

    :param shape: `ParticleShape`; :param container: `Container`
    :param solidFraction: solid volume over bed volume, in (0, 1); by default `expectedFraction`
    """
    thickness = checks.positive('thickness', thickness)
    solidFraction = (expectedFraction(thickness, shape.volume) if solidFraction is None else
                     checks.above('solidFraction', solidFraction, 0, 1))
    return max(1, round(solidFraction * containers.crossSection(container) * thickness / shape.volume))


def checkCapacity(shapes, container, solidFraction=DEEP_FRACTION):
    """ValueError if the particles, packed to `solidFraction`, need more than the container's volume."""
    needed = sum(shape.volume for shape in shapes) / solidFraction
    available = containers.crossSection(container) * container.height
    if needed > available:
        raise ValueError(f'number of particles = {len(shapes)}: overfull container; poured to a solid fraction of '
                         f'{solidFraction:g} they need {needed:.4g} m3, it holds {available:.4g} m3')


def rainFilling(shapes, container, material, seed, speed=0.5, solidFraction=DEEP_FRACTION, gap=GAP, sideways=SIDEWAYS):
    """Put one body per entry of `shapes` into the container, without overlap, moving down and at random sideways.

    The centres lie in horizontal layers on triangular grids, each turned and shifted at random, and every centre is
    jittered by no more than leaves the bounding spheres apart. The layers may reach above the rim:
    the container is then made higher, `containers.setHeight` restores it once the bed has settled. They begin at the base, so
    the container must be empty: one call per container, with all its particles.

    :param shapes: list of `ParticleShape`, one per particle
    :param container: `Container`
    :param material: the particles' material
    :param seed: the same seed gives the same bodies, bit for bit
    :param speed: initial downward speed [m/s]
    :param solidFraction: of the settled bed, for the check that it fits
    :param gap: clear distance between the particles' bounding spheres at the start, over their diameter
    :param sideways: largest horizontal speed over the downward one. Rain that falls straight makes a heap, as the bounding
        spheres keep it farther from the wall than the settled particles are.
    :returns: (ids of the particles, the container with its present height)
    :raises ValueError: before any body is added
    """
    _checkEmpty(container)
    shapes = list(shapes)
    if not shapes:
        raise ValueError('shapes = []: at least one particle is needed')
    for shape in shapes:
        if not isinstance(shape, ParticleShape):
            raise ValueError(f'shapes: {shape!r} is no ParticleShape; particleShape() makes them')
    seed, speed = checks.wholeNumber('seed', seed, 0), checks.notNegative('speed', speed)
    gap, sideways = checks.notNegative('gap', gap), checks.notNegative('sideways', sideways)
    checkCapacity(shapes, container, checks.above('solidFraction', solidFraction, 0, DENSEST))
    memory.check(len(shapes))
    rng = random.Random(seed)
    radius = max(shape.boundingRadius for shape in set(shapes))
    containers.checkFits(container, radius)
    centers = _centers(len(shapes), radius, gap, container, rng)
    bodies = [_falling(shape, center, material, speed, sideways, rng) for shape, center in zip(shapes, centers)]
    top = max(center[2] for center in centers) + radius
    return O.bodies.append(bodies), containers.setHeight(container, max(container.height, top))


def _checkEmpty(container):
    for body in O.bodies:
        x, y, z = body.state.pos
        if isinstance(body.shape, (Sphere, Superquadric)) and z > 0 and _inside(x, y, 0.0, container):
            raise ValueError(f'container: body {body.id} is in it already; fill it with all particles at once')


def _falling(shape, center, material, speed, sideways, rng):
    shade = 0.55 + 0.25 * rng.random()
    body = shape.body(Vector3(*center), randomOrientation(rng), material, color=(shade, 0.8 * shade, 0.5 * shade))
    heading, drift = 2 * math.pi * rng.random(), sideways * speed * math.sqrt(rng.random())
    body.state.vel = Vector3(drift * math.cos(heading), drift * math.sin(heading), -speed)
    return body


def _centers(number, radius, gap, container, rng):
    """`number` points [m] above the base, farther than 2 `radius` from each other and `radius` from the walls."""
    jitter = min(gap * radius, _halfWidth(container) - radius)
    spacing, margin = 2 * (radius + jitter), radius + jitter
    centers, z = [], margin
    while len(centers) < number:
        layer = _layer(spacing, margin, container, rng)
        rng.shuffle(layer)
        for x, y in layer[:number - len(centers)]:
            dx, dy, dz = _inBall(jitter, rng)
            centers.append((x + dx, y + dy, z + dz))
        z += spacing
    return centers


def _layer(spacing, margin, container, rng):
    """Points of a triangular grid, turned at random, at least `margin` [m] inside the container's side walls.
    The grid has one of its points at a random place inside, so that no layer is empty."""
    angle = 2 * math.pi * rng.random()
    cosine, sine = math.cos(angle), math.sin(angle)
    x0, y0 = _randomPlace(margin, container, rng)
    reach = math.ceil(4 * _outerWidth(container) / spacing)
    points = []
    for i in range(-reach, reach + 1):
        for j in range(-reach, reach + 1):
            u, v = spacing * (i + 0.5 * j), spacing * math.sqrt(0.75) * j
            x, y = x0 + cosine * u - sine * v, y0 + sine * u + cosine * v
            if (i == 0 and j == 0) or _inside(x, y, margin, container):
                points.append((x, y))
    return points


def _inside(x, y, margin, container):
    if container.radius is not None:
        return math.hypot(x, y) <= container.radius - margin
    return abs(x) <= container.width / 2 - margin and abs(y) <= container.depth / 2 - margin


def _randomPlace(margin, container, rng):
    if container.radius is not None:
        distance = (container.radius - margin) * math.sqrt(rng.random())
        angle = 2 * math.pi * rng.random()
        return distance * math.cos(angle), distance * math.sin(angle)
    return tuple((size / 2 - margin) * (2 * rng.random() - 1) for size in (container.width, container.depth))


def _halfWidth(container):
    return container.radius if container.radius is not None else min(container.width, container.depth) / 2


def _outerWidth(container):
    return container.radius if container.radius is not None else math.hypot(container.width, container.depth) / 2


def _inBall(radius, rng):
    """A vector drawn uniformly from the ball."""
    while True:
        point = [radius * (2 * rng.random() - 1) for _ in range(3)]
        if sum(x * x for x in point) <= radius * radius:
            return point
