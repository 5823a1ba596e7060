"""Parameters of the particles: their shape, and sizes about a mean radius."""
from __future__ import annotations

import dataclasses
import random
from dataclasses import dataclass
from typing import Self

from .. import checks
from ..runs.parameters import Parameters, oneOf, optional, parameter, within
from ..scene.shapes import BLOCK_EXPONENT, SHAPES, ParticleShape, particleShape

# Exponents that a shape has by its name, and the names: with aspect 1, and with any other.
NAMED = {(2.0, 2.0): ('ellipsoid', 'ellipsoid'), (BLOCK_EXPONENT, 2.0): ('cylinder', 'cylinder'), (BLOCK_EXPONENT, BLOCK_EXPONENT): ('cube', 'block')}
UNIFORM, NORMAL = DISTRIBUTIONS = ('uniform', 'normal')


@dataclass(frozen=True, kw_only=True)
class Particles(Parameters):
    """The shape that all particles have."""

    TITLE = 'particles'

    shape: str = parameter('sphere', oneOf(SHAPES), 'shape of the particles: ' + ', '.join(SHAPES))
    n1: float | None = parameter(None, optional(checks.exponent), 'exponent along z, instead of the shape\'s own')
    n2: float | None = parameter(None, optional(checks.exponent), 'exponent in the x-y plane, instead of the shape\'s own')
    aspect: float = parameter(1.0, checks.positive, 'c/a, for ellipsoid, cylinder and block')

    def check(self) -> None:
        super().check()
        self.shapeOf(1.0)

    def shapeOf(self, radius: float) -> ParticleShape:
        """Of a particle with the volume of a sphere of `radius` [m]."""
        return particleShape(self.shape, radius, self.aspect, self.n1, self.n2)

    def standard(self) -> Self:
        """The same with the shape in its one standard form, so that equal particles are the same bed.

        A shape is its exponents and its aspect: a cylinder with n2 = 8 is a cube or block, a cube with n1 = n2 = 2 an ellipsoid. Only
        the sphere stays one by name, as it is YADE's own.
        """
        shape = self.shapeOf(1.0)
        if shape.asSphere:
            return dataclasses.replace(self, n1=None, n2=None)
        exponents, regular = (shape.n1, shape.n2), self.aspect == 1
        if exponents in NAMED:
            return dataclasses.replace(self, shape=NAMED[exponents][0 if regular else 1], n1=None, n2=None)
        return dataclasses.replace(self, shape='cube' if regular else 'block', n1=shape.n1, n2=shape.n2)


@dataclass(frozen=True, kw_only=True)
class SizedParticles(Particles):
    """Particles whose sizes scatter about a mean."""

    TITLE = 'sizes of the particles'

    radius: float = parameter(5e-3, checks.positive, 'radius of the sphere that has the particle\'s volume; their mean where sizes differ', 'm')
    radiusSpread: float = parameter(0.0, within(0, 1, False), 'radii lie within (1 - spread, 1 + spread) times radius; 0: all are equal')
    radiusDistribution: str = parameter(UNIFORM, oneOf(DISTRIBUTIONS), 'how they are distributed there: uniform, or normal with a third of the '
                                        'spread as standard deviation, and cut')

    @property
    def meanShape(self) -> ParticleShape:
        """That of a particle with the mean radius."""
        return self.shapeOf(self.radius)

    @property
    def smallestHalfSize(self) -> float:
        """Of the smallest particle there may be [m]."""
        return (1 - self.radiusSpread) * min(self.meanShape.extents)

    @property
    def largestBoundingRadius(self) -> float:
        """Of the largest particle there may be [m]."""
        return (1 + self.radiusSpread) * self.meanShape.boundingRadius

    def drawnShapes(self, number: int, seed: int) -> list[ParticleShape]:
        """The shapes of `number` particles."""
        shape, spread = self.meanShape, self.radiusSpread
        if not spread:
            return [shape] * number
        rng = random.Random(f'sizes {seed}')  # another sequence than the one that places the particles
        draw = _uniform if self.radiusDistribution == UNIFORM else _cutNormal
        return [shape.scaled(1 + draw(rng, spread)) for _ in range(number)]


def _uniform(rng: random.Random, limit: float) -> float:
    return limit * (2 * rng.random() - 1)


def _cutNormal(rng: random.Random, limit: float) -> float:
    """Normally distributed with a standard deviation of `limit`/3, drawn again beyond `limit`."""
    while abs(value := rng.gauss(0, limit / 3)) > limit:
        pass
    return value
