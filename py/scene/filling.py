"""Rain filling: particles of random orientation, laid out without overlap above the base, then left to fall."""
from __future__ import annotations

import math
import random
from collections.abc import Iterable
from typing import Any

from yade import O
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import Body, Sphere, Superquadric

from .. import checks
from . import memory
from .container import Container, checkFits
from .expectedbed import DEEP_FRACTION, DENSEST, checkCapacity
from .rain import GAP, SIDEWAYS, isInside, rainCentres
from .shapes import ParticleShape
from .walls import setHeight


def randomOrientation(rng: random.Random) -> Quaternion:
    """A rotation drawn uniformly from all rotations (Shoemake 1992). `rng`: random.Random."""
    u1, u2, u3 = rng.random(), 2 * math.pi * rng.random(), 2 * math.pi * rng.random()
    s, t = math.sqrt(1 - u1), math.sqrt(u1)
    return Quaternion(t * math.cos(u3), s * math.sin(u2), s * math.cos(u2), t * math.sin(u3))


def rainFilling(shapes: Iterable[ParticleShape], container: Container, material: Any, seed: int, speed: float = 0.5,
                solidFraction: float = DEEP_FRACTION, gap: float = GAP, sideways: float = SIDEWAYS) -> tuple[list[int], Container]:
    """Put one body per entry of `shapes` into the container, without overlap, moving down and at random sideways.

    The centres lie in horizontal layers on triangular grids, each turned and shifted at random, and every centre is
    jittered by no more than leaves the bounding spheres apart. The layers may reach above the rim:
    the container is then made higher, `walls.setHeight` restores it once the bed has settled. They begin at the base, so
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
    checkFits(container, radius)
    centers = rainCentres(len(shapes), radius, gap, container, rng)
    bodies = [_falling(shape, center, material, speed, sideways, rng) for shape, center in zip(shapes, centers)]
    top = max(center[2] for center in centers) + radius
    return O.bodies.append(bodies), setHeight(container, max(container.height, top))


def _checkEmpty(container: Container) -> None:
    for body in O.bodies:
        x, y, z = body.state.pos
        if isinstance(body.shape, (Sphere, Superquadric)) and z > 0 and isInside(x, y, 0.0, container):
            raise ValueError(f'container: body {body.id} is in it already; fill it with all particles at once')


def _falling(shape: ParticleShape, center: tuple[float, float, float], material: Any, speed: float, sideways: float, rng: random.Random) -> Body:
    shade = 0.55 + 0.25 * rng.random()
    body = shape.body(Vector3(*center), randomOrientation(rng), material, color=(shade, 0.8 * shade, 0.5 * shade))
    heading, drift = 2 * math.pi * rng.random(), sideways * speed * math.sqrt(rng.random())
    body.state.vel = Vector3(drift * math.cos(heading), drift * math.sin(heading), -speed)
    return body
