"""Rigid containers as plain numbers: the cylinder of the impact study, and a box. Both stand on the plane z = 0. `walls` makes their bodies."""
from __future__ import annotations

import math
from typing import NamedTuple

from .. import checks


class Container(NamedTuple):
    """A container in the scene.

    baseId: id of the base (a Wall at z = 0, forces on it are recorded), -1 of a container that is in no scene; sideIds: ids of the side wall(s);
    radius [m] of a cylinder (else None); width, depth [m] of a box along x, y (else None); height [m].
    """

    baseId: int
    sideIds: tuple[int, ...]
    radius: float | None
    width: float | None
    depth: float | None
    height: float

    @property
    def sides(self) -> tuple[float, float]:
        """(width, depth) of a box [m]."""
        assert self.width is not None and self.depth is not None, 'a cylinder has no sides'
        return self.width, self.depth


def crossSection(container: Container) -> float:
    """Inner area [m2]."""
    if container.radius is None:
        return math.prod(container.sides)
    return math.pi * container.radius ** 2


def checkFits(container: Container, largestParticle: float) -> None:
    """ValueError if a particle of bounding radius `largestParticle` [m] does not fit into the container."""
    if container.radius is not None:
        checkCylinder(container.radius, container.height, largestParticle)
    else:
        checkBox(*container.sides, container.height, largestParticle)


def checkBox(width: float, depth: float, height: float, largestParticle: float) -> tuple[float, float, float]:
    """The sizes as floats; ValueError if a particle of bounding radius `largestParticle` [m] does not fit into the box."""
    width, depth, height = (checks.positive(f'container {name}', size) for name, size in (('width', width), ('depth', depth), ('height', height)))
    largestParticle = checks.notNegative('largestParticle', largestParticle)
    for name, size in zip(('width', 'depth', 'height'), (width, depth, height)):
        if size < 2 * largestParticle:
            raise ValueError(f'container {name} = {size!r}: the container is smaller than a particle '
                             f'(bounding diameter {2 * largestParticle:g} m)')
    return width, depth, height


def checkCylinder(radius: float, height: float, largestParticle: float) -> tuple[float, float]:
    """Radius and height as floats; ValueError if a particle of bounding radius `largestParticle` [m] does not fit into the cylinder."""
    radius, height = checks.positive('container radius', radius), checks.positive('container height', height)
    largestParticle = checks.notNegative('largestParticle', largestParticle)
    if radius < largestParticle:
        raise ValueError(f'container radius = {radius!r}: the container is smaller than a particle '
                         f'(bounding radius {largestParticle:g} m)')
    if height < 2 * largestParticle:
        raise ValueError(f'container height = {height!r}: the container is smaller than a particle '
                         f'(bounding diameter {2 * largestParticle:g} m)')
    return radius, height
