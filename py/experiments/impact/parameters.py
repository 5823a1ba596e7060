"""The parameters of an impact on a bed: one declaration for command line, batch table, checks, studies and summary.

The defaults are the case of Wang & Ji, Acta Phys. Sin. 67, 094501 (2018) that their Fig. 10 shows for cubes and H = 2.5 cm.
"""
from __future__ import annotations

import math
from dataclasses import dataclass

from ... import checks
from ...runs.parameters import between, count, optional, parameter, redeclared, within
from ...scene.contactlaws import EFFECTIVE_MASS_AT_CONTACT, OVERLAP_LIMIT
from ...scene.container import Container, checkCylinder
from ...scene.expectedbed import DEEP_FRACTION, DENSEST, particleNumber
from ...scene.rain import GAP, SIDEWAYS
from ...scene.settlingrules import QUIET
from ...scene.timestep import rayleighTimeStep
from ..bed import Bed
from ..material import Material
from ..particles import SizedParticles
from ..renamedparameters import RENAMED as OLD_NAMES
from .fall import CLEARANCE, speedAt, surfaceSpeed

IMPACT = 'impact'  # scope of what may differ from impact to impact on the same bed
CALIBRATED_DENSITY = 3003.0  # kg/m3: with it an impact on the bare base at 5.558 m/s peaks at the paper's P0 = 4.67 kN


@dataclass(frozen=True, kw_only=True)
class PouredBed(Bed, Material, SizedParticles):
    """What the bed is made from."""

    TITLE = 'pouring'

    shape: str = redeclared('cube')
    friction: float = redeclared(0.4)
    restitution: float | None = redeclared(None)
    normalDamping: float | None = redeclared(0.1)
    tangentialDamping: float | None = redeclared(0.1)
    maxSettlingTime: float = redeclared(3.0)
    timeStepFraction: float = redeclared(0.1)

    thickness: float = parameter(0.025, checks.positive, 'thickness H of the bed to aim at; the result is measured', 'm')
    particles: int | None = parameter(None, optional(count(1)), 'number of particles, instead of what thickness and solidFraction give')
    solidFraction: float | None = parameter(None, optional(between(0, DENSEST)), 'expected packing fraction of the bed, instead of an estimate from '
                                            'its thickness')
    thicknessTolerance: float = parameter(0.03, between(0, 1 + 1e-12), 'the bed is poured again with another number of particles until its '
                                          'thickness is within this part of the one aimed at; not where particles is given')
    containerDiameter: float = parameter(0.19, checks.positive, 'inner diameter of the rigid cylinder', 'm')
    containerHeight: float = parameter(0.3, checks.positive, 'height of the rigid cylinder', 'm')
    rainSpeed: float = parameter(0.5, checks.notNegative, 'initial downward speed of the particles', 'm/s')
    rainSideways: float = parameter(SIDEWAYS, checks.notNegative, 'largest horizontal speed of the rain over rainSpeed')
    rainGap: float = parameter(GAP, checks.notNegative, 'clear distance of the particles\' bounding spheres in the rain, over their diameter')
    pouringSoftening: float = parameter(100.0, within(1, 1e4), 'Young\'s modulus is divided by this while the bed is poured')
    restEnergy: float = parameter(QUIET, checks.positive, 'kinetic energy per particle over m g d below which the poured bed is at rest')

    def particleCount(self) -> int:
        """Number of particles that the parameters ask for."""
        if self.particles is not None:
            return self.particles
        container = Container(-1, (), self.containerDiameter / 2, None, None, self.containerHeight)
        return particleNumber(self.thickness, self.meanShape, container, self.solidFraction)

    def check(self) -> None:
        super().check()
        checkCylinder(self.containerDiameter / 2, self.containerHeight, self.largestBoundingRadius)
        number = self.particleCount()
        bed = number * self.meanShape.volume / (self.solidFraction or DEEP_FRACTION) / (math.pi / 4 * self.containerDiameter ** 2)
        if bed > self.containerHeight:
            name = 'thickness' if self.particles is None else 'particles'
            raise ValueError(f'{name} = {getattr(self, name)!r}: overfull container; {number} particles make a bed of '
                             f'{bed:.4g} m, containerHeight is {self.containerHeight!r} m')


@dataclass(frozen=True, kw_only=True)
class ImpactParameters(PouredBed):
    """The bed, and what falls on it."""

    TITLE = 'impact'
    RENAMED = OLD_NAMES['impact']

    impactorDiameter: float = parameter(0.05, checks.positive, 'diameter of the impactor, a sphere of the particles\' material', 'm', IMPACT)
    impactorDensity: float = parameter(CALIBRATED_DENSITY, checks.positive, 'its density; the default reproduces the paper\'s P0', 'kg/m3', IMPACT)
    speed: float = parameter(5.0, checks.notNegative, 'its downward speed V0 at dropHeight', 'm/s', IMPACT)
    dropHeight: float = parameter(0.3, checks.notNegative, 'height above the bed\'s surface at which it has that speed', 'm', IMPACT)
    impactorX: float = parameter(0.0, checks.finite, 'where it falls: distance from the container\'s axis along x', 'm', IMPACT)
    impactorY: float = parameter(0.0, checks.finite, 'the same along y', 'm', IMPACT)
    baseYoung: float | None = parameter(None, optional(checks.positive), 'Young\'s modulus of the base in the impact, instead of young', 'Pa', IMPACT)
    overlapLimit: float = parameter(OVERLAP_LIMIT, between(0, 1), 'bound of the curvatures in the impact, see '
                                    'Law2_ScGeom_CurvaturePhys_HertzMindlin', scope=IMPACT)
    effectiveMassAtContact: bool = parameter(EFFECTIVE_MASS_AT_CONTACT, checks.boolean, 'whether m* of the normal damping counts in the impact that '
                                             'a push beside the centre also turns the bodies, see there', scope=IMPACT)
    dt: float | None = parameter(None, optional(checks.positive), 'time step of the impact, instead of timeStepFraction', 's', IMPACT)
    maxImpactTime: float = parameter(0.05, checks.positive, 'simulated time after which the impact ends in any case', 's', IMPACT)

    def check(self) -> None:
        super().check()
        self._checkPlace()
        self._checkDrop()
        critical = self.criticalImpactStep()
        if self.dt is not None and self.dt > critical:
            raise ValueError(f'dt = {self.dt!r}: above the critical time step {critical:.4g} s')

    def _checkPlace(self) -> None:
        """The impactor has to fall into the container."""
        x, y, diameter, container = self.impactorX, self.impactorY, self.impactorDiameter, self.containerDiameter
        if diameter > container:
            raise ValueError(f'impactorDiameter = {diameter!r}: larger than the container ({container!r} m)')
        if math.hypot(x, y) + diameter / 2 > container / 2:
            name, value = ('impactorX', x) if abs(x) > abs(y) else ('impactorY', y)
            raise ValueError(f'{name} = {value!r}: the impactor ({diameter!r} m) would meet the wall of the container ({container!r} m)')

    def _checkDrop(self) -> None:
        """The impactor has to start above the particles: some stand out of the surface, by two of the largest at most."""
        if surfaceSpeed(self.speed, self.dropHeight, self.gravity) == 0:
            raise ValueError(f'speed = {self.speed!r}: with dropHeight = {self.dropHeight!r} the impactor reaches the bed without speed')
        speedAt(CLEARANCE + 4 * self.largestBoundingRadius, self.speed, self.dropHeight, self.gravity)

    def criticalImpactStep(self) -> float:
        """The smaller of the critical time steps [s] of the smallest particle and of the impactor, in the impact."""
        return min(self.criticalTimeStep(self.smallestHalfSize),
                   rayleighTimeStep(self.impactorDiameter / 2, self.young, self.poisson, self.impactorDensity))

    def impactTimeStep(self) -> float:
        """Time step [s] of the impact."""
        return self.timeStepFraction * self.criticalImpactStep() if self.dt is None else self.dt
