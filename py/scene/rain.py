"""Where the rain of a filling begins: points in horizontal layers on triangular grids, each turned and shifted at random."""
from __future__ import annotations

import math
import random
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .container import Container

GAP, SIDEWAYS = 0.08, 2.0  # of filling.rainFilling, by default


def rainCentres(number: int, radius: float, gap: float, container: Container, rng: random.Random) -> list[tuple[float, float, float]]:
    """`number` points [m] above the base, farther than 2 `radius` from each other and `radius` from the walls."""
    jitter = min(gap * radius, _halfWidth(container) - radius)
    spacing, margin = 2 * (radius + jitter), radius + jitter
    centers: list[tuple[float, float, float]] = []
    z = margin
    while len(centers) < number:
        layer = _layer(spacing, margin, container, rng)
        rng.shuffle(layer)
        for x, y in layer[:number - len(centers)]:
            dx, dy, dz = _inBall(jitter, rng)
            centers.append((x + dx, y + dy, z + dz))
        z += spacing
    return centers


def _layer(spacing: float, margin: float, container: Container, rng: random.Random) -> list[tuple[float, float]]:
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
            if (i == 0 and j == 0) or isInside(x, y, margin, container):
                points.append((x, y))
    return points


def isInside(x: float, y: float, margin: float, container: Container) -> bool:
    """Whether the point is at least `margin` [m] from the side walls, on their inner side."""
    if container.radius is not None:
        return math.hypot(x, y) <= container.radius - margin
    width, depth = container.sides
    return abs(x) <= width / 2 - margin and abs(y) <= depth / 2 - margin


def _randomPlace(margin: float, container: Container, rng: random.Random) -> tuple[float, float]:
    if container.radius is not None:
        distance = (container.radius - margin) * math.sqrt(rng.random())
        angle = 2 * math.pi * rng.random()
        return distance * math.cos(angle), distance * math.sin(angle)
    x, y = ((size / 2 - margin) * (2 * rng.random() - 1) for size in container.sides)
    return x, y


def _halfWidth(container: Container) -> float:
    return container.radius if container.radius is not None else min(container.sides) / 2


def _outerWidth(container: Container) -> float:
    return container.radius if container.radius is not None else math.hypot(*container.sides) / 2


def _inBall(radius: float, rng: random.Random) -> list[float]:
    """A vector drawn uniformly from the ball."""
    while True:
        point = [radius * (2 * rng.random() - 1) for _ in range(3)]
        if sum(x * x for x in point) <= radius * radius:
            return point
