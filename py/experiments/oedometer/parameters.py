"""The parameters of an oedometer test: one declaration for command line, checks, studies and summary.

The defaults are a rockfill of 20 to 40 mm (the sizes of Zhao & Chi, J. Northeastern Univ. Nat. Sci. 44(3), 408-414 (2023)); the paper's
specimen is not known (docs/notation.md). Young's modulus is softened (docs/oedometer.md).
"""
from __future__ import annotations

import math
import random
from dataclasses import dataclass

from ... import checks
from ...runs.parameters import between, count, oneOf, optional, parameter, redeclared, within
from ...scene.expectedbed import DEEP_FRACTION
from ...scene.shapes import ParticleShape
from ..bed import Bed
from ..material import Material
from ..particles import Particles
from ..renamedparameters import RENAMED as OLD_NAMES

TEST = 'test'  # scope of what is done to the bed
BOX, CYLINDER = CONTAINERS = ('box', 'cylinder')
MODES = ('cube', 'balls4', 'balls18', 'none')
FOR_SPHERES_ONLY = ('balls4', 'balls18')
CRITERIA = ('force', 'octahedral')
LOOSE_FRACTION = 0.5  # no bed that was rained in is looser: for the container's height


@dataclass(frozen=True, kw_only=True)
class Specimen(Bed, Material, Particles):
    """What is compressed, and in what."""

    TITLE = 'specimen'

    density: float = redeclared(2700.0)
    young: float = redeclared(2e9)
    poisson: float = redeclared(0.25)
    friction: float = redeclared(0.5, help='coefficient of sliding friction between particles')
    rollingFriction: float = redeclared(0.01)

    particles: int = parameter(1500, count(1), 'number of particles')
    smallestDiameter: float = parameter(0.02, checks.positive, 'sizes (diameters of the spheres of the particles\' volumes) are uniformly '
                                        'distributed by number, from this one ...', 'm')
    largestDiameter: float = parameter(0.04, checks.positive, '... to this one', 'm')
    container: str = parameter(BOX, oneOf(CONTAINERS), 'box (of square section) or cylinder')
    containerWidth: float = parameter(0.36, checks.positive, 'inner width of the box, or diameter of the cylinder', 'm')
    wallFriction: float = parameter(0.0, checks.notNegative, 'coefficient of sliding friction with container and plate')
    seatingStress: float = parameter(1e4, checks.positive, 'axial stress under which the plate is put on; strain counts from there', 'Pa')

    def check(self) -> None:
        super().check()
        if self.smallestDiameter > self.largestDiameter:
            raise ValueError(f'smallestDiameter = {self.smallestDiameter!r}: above largestDiameter = {self.largestDiameter!r}')
        largest = self.largestShape.boundingRadius
        if self.containerWidth < 2 * largest:
            raise ValueError(f'containerWidth = {self.containerWidth!r}: the container is smaller than a particle (bounding diameter '
                             f'{2 * largest:g} m)')

    @property
    def largestShape(self) -> ParticleShape:
        return self.shapeOf(self.largestDiameter / 2)

    def drawnShapes(self) -> list[ParticleShape]:
        """The shapes of all particles: uniformly distributed sizes."""
        rng = random.Random(f'sizes {self.seed}')  # another sequence than the one that places the particles
        low, high = self.smallestDiameter, self.largestDiameter
        return [self.shapeOf((low + (high - low) * rng.random()) / 2) for _ in range(self.particles)]

    def meanCube(self) -> float:
        """Mean of the cube of the particles' diameters [m3]; uniform distribution."""
        low, high = self.smallestDiameter, self.largestDiameter
        return (low + high) * (low * low + high * high) / 4

    def section(self) -> float:
        """Inner cross section of the container [m2]."""
        return self.containerWidth ** 2 * (1 if self.container == BOX else math.pi / 4)

    def containerHeight(self) -> float:
        """Height [m] that holds the settled bed in any case."""
        solid = self.particles * math.pi / 6 * self.meanCube()
        return solid / (LOOSE_FRACTION * self.section()) * DEEP_FRACTION / LOOSE_FRACTION + 2 * self.largestShape.boundingRadius

    def timeStepOf(self, size: float) -> float:
        """Time step [s] for particles of `size` (diameter of the sphere of the same volume) [m]."""
        return self.timeStepFraction * self.criticalTimeStep(size / 2)

    def bedTimeStep(self) -> float:
        """Time step [s] before anything breaks."""
        return self.timeStepOf(2 * min(self.shapeOf(self.smallestDiameter / 2).extents))


@dataclass(frozen=True, kw_only=True)
class OedometerParameters(Specimen):
    """The specimen, how it breaks, and how it is compressed."""

    TITLE = 'test'
    RENAMED = OLD_NAMES['oedometer']

    mode: str = parameter('cube', oneOf(MODES), 'how particles break: ' + ', '.join(MODES), scope=TEST)
    criterion: str = parameter('octahedral', oneOf(CRITERIA), 'when: ' + ', '.join(CRITERIA), scope=TEST)
    characteristicStrength: float = parameter(6e6, checks.positive, 'that the part 1/e of the particles of referenceSize survive', 'Pa', TEST)
    referenceSize: float = parameter(0.03, checks.positive, 'size of particles to which it belongs', 'm', TEST)
    weibullModulus: float = parameter(3.0, checks.positive, 'of the strengths\' scatter; strength goes as size^(-3/modulus)', scope=TEST)
    smallestSize: float = parameter(0.01, checks.positive, 'particles below do not break', 'm', TEST)
    smallestFragment: float = parameter(1e-3, checks.notNegative, 'no fragment is smaller (no width of one, if it is not a sphere): such a '
                                        'cut is drawn again', 'm', TEST)
    cutExponent: float = parameter(2.0, checks.positive, 'p of the cube\'s cut: u^p, u uniform', scope=TEST)
    maxEvents: int = parameter(100, count(1), 'particles that break in one step, at most', scope=TEST)
    breakageSeed: int | None = parameter(None, optional(count(0)), 'seed of strengths, cuts and orientations of the fragments; default: the bed\'s',
                                         scope=TEST)
    inertialSize: float = parameter(0.01, checks.positive, 'fragments of a smaller width get the inertia with which their critical time step is that '
                                    'of this width', 'm', TEST)
    strainRate: float = parameter(1.0, checks.positive, 'largest axial strain rate', '1/s', TEST)
    inertialNumber: float = parameter(2e-3, checks.positive, 'the plate is slower where the inertial number would be above', scope=TEST)
    numericalDamping: float = parameter(0.3, within(0, 1, False), 'YADE\'s non-viscous damping (of NewtonIntegrator)', scope=TEST)
    maxStress: float = parameter(3e6, checks.positive, 'axial stress at which the test ends', 'Pa', TEST)
    maxStrain: float = parameter(0.3, between(0, 1), 'axial strain at which it ends', scope=TEST)
    maxParticles: int | None = parameter(None, optional(count(1)), 'number of particles at which it ends', scope=TEST)
    sampleStrain: float = parameter(5e-4, between(0, 1), 'strain between two records', scope=TEST)

    def check(self) -> None:
        super().check()
        if self.smallestFragment > self.smallestDiameter / 2:
            raise ValueError(f'smallestFragment = {self.smallestFragment!r}: above half of smallestDiameter = {self.smallestDiameter!r}; such '
                             f'particles cannot be cut into eight')
        if self.maxStress <= self.seatingStress:
            raise ValueError(f'maxStress = {self.maxStress!r}: not above seatingStress = {self.seatingStress!r}')
        if self.maxParticles is not None and self.maxParticles <= self.particles:
            raise ValueError(f'maxParticles = {self.maxParticles!r}: not above particles = {self.particles!r}')
        if self.mode in FOR_SPHERES_ONLY and not self.shapeOf(1.0).asSphere:
            raise ValueError(f'mode = {self.mode!r}: for spheres only; other shapes break by the mode cube')

    def breaks(self) -> bool:
        """Whether particles break at all."""
        return self.mode != 'none'

    def strength(self) -> dict[str, float]:
        """Attributes of the particles' BreakableMat that make them break."""
        return {name: getattr(self, name) for name in ('characteristicStrength', 'referenceSize', 'weibullModulus', 'smallestSize')}

    def seedOfBreakage(self) -> int:
        """Seed of strengths and cuts: unless it is given, another bed has other strengths."""
        return self.seed if self.breakageSeed is None else self.breakageSeed

    def testTimeStep(self) -> float:
        """Time step [s] of the test: fragments below inertialSize are as slow as those of that width."""
        smallest = self.bedTimeStep()
        return min(smallest, self.timeStepOf(self.inertialSize)) if self.breaks() else smallest
