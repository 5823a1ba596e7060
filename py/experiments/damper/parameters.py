"""The parameters of a particle damper: one declaration for command line, checks, studies and summary.

The defaults are the system of Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39(8), 1211-1216 (2018). Its table of contact parameters
is not known (docs/notation.md): tangential and rolling damping, rolling friction and the width of the size distribution are choices. Of its
material E = 70 GPa, nu = 0.33 and 2700 kg/m3 are known; the shipped aluminium alloy comes near.
"""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ... import checks
from ...materials.shipped import materialAt, properties
from ...runs.parameters import between, count, oneOf, optional, parameter, redeclared, within
from ...scene.contactlaws import CONTACT_LAWS, CURVATURE
from ...scene.expectedbed import DEEP_FRACTION
from ...scene.restitution import collisionDuration
from ..bed import Bed
from ..material import Material
from ..particles import NORMAL, SizedParticles
from ..renamedparameters import RENAMED as OLD_NAMES

DRIVE = 'drive'  # scope of what is done to the box; all else belongs to what the box holds
STARTS = ('steady', 'rest')
OF_THE_MATERIAL = ('density', 'young', 'poisson')  # parameters that the material gives unless they are given themselves


@dataclass(frozen=True, kw_only=True)
class Filling(Bed, Material, SizedParticles):
    """What the box holds."""

    TITLE = 'filling'

    radius: float = redeclared(1e-3)
    radiusSpread: float = redeclared(0.01)
    radiusDistribution: str = redeclared(NORMAL)
    density: float = redeclared(None, check=optional(checks.positive), help='density of the particles, instead of the material\'s')
    young: float = redeclared(None, check=optional(checks.positive), help='Young\'s modulus of particles and box, instead of the material\'s')
    poisson: float = redeclared(None, check=optional(between(-1, 0.5)), help='Poisson\'s ratio of the same, instead of the material\'s')
    maxSettlingTime: float = redeclared(0.15)
    timeStepFraction: float = redeclared(0.3, scope=DRIVE)

    particles: int = parameter(2000, count(0), 'number of particles')
    totalParticleMass: float | None = parameter(None, optional(checks.positive), 'mass of all particles together, instead of what their density '
                                                'gives', 'kg')
    law: str = parameter(CONTACT_LAWS[1], oneOf(CONTACT_LAWS), 'contact law: ' + ', '.join(CONTACT_LAWS))
    material: str = parameter('aluminium-2024-T351', materialAt, 'of particles and box: a shipped material, or a material file')
    rollingDamping: float = parameter(0.3, checks.notNegative, 'damping of rolling as a part of the critical one (elastoplastic law)')
    softening: float = parameter(1.0, within(1, 1e4), 'Young\'s modulus is divided by this in the whole run, for longer time steps')
    boxWidth: float = parameter(0.042, checks.positive, 'inner size of the box along x', 'm')
    boxDepth: float = parameter(0.042, checks.positive, 'the same along y', 'm')
    boxHeight: float = parameter(0.024, checks.positive, 'the same along z', 'm')

    @classmethod
    def completed(cls, values: dict[str, Any]) -> dict[str, Any]:
        known = properties(values['material'])
        return {**values, **{name: known[name] for name in OF_THE_MATERIAL if values[name] is None}}

    def check(self) -> None:
        super().check()
        self._checkYield()
        self._checkRoom()

    def _checkYield(self) -> None:
        young, yieldStress = self.young / self.softening, self.yieldStress()
        if self.law != CURVATURE and yieldStress >= young:
            raise ValueError(f'young = {self.young!r}: with softening = {self.softening:g} it is {young:g} Pa, not above the yield stress of '
                             f'{self.material!r}, then {yieldStress:g} Pa')

    def _checkRoom(self) -> None:
        """The settled particles have to leave room below the lid."""
        largest = self.largestBoundingRadius
        for name, size in (('boxWidth', self.boxWidth), ('boxDepth', self.boxDepth), ('boxHeight', self.boxHeight)):
            if size < 2 * largest:
                raise ValueError(f'{name} = {size!r}: the box is smaller than a particle (bounding diameter {2 * largest:g} m)')
        if self.filling() > DEEP_FRACTION:
            raise ValueError(f'particles = {self.particles!r}: overfull box; they fill {self.filling():.3g} of it, and pack to '
                             f'{DEEP_FRACTION:g} at most')

    def filling(self) -> float:
        """Volume of the particles, with the mean size, over that of the box [-]."""
        return self.particles * self.meanShape.volume / (self.boxWidth * self.boxDepth * self.boxHeight)

    def particleDensity(self) -> float:
        """Density of the particles [kg/m3]; with totalParticleMass the one that gives it with the mean size."""
        if self.totalParticleMass is None or self.particles == 0:
            return self.density
        return self.totalParticleMass / (self.particles * self.meanShape.volume)

    def particlesMass(self) -> float:
        """Mass of the particles with the mean size [kg]."""
        return self.particles * self.particleDensity() * self.meanShape.volume

    def attributes(self) -> dict[str, float]:
        """Keyword arguments of the material that both laws have."""
        return {**super().attributes(), 'young': self.young / self.softening, 'density': self.particleDensity()}

    def yieldStress(self) -> float:
        """Of the softened material [Pa].

        Softening divides the yield stress by its power 4/5: the speed at which a collision begins to yield is as
        sigma_y^(5/2)/(E^2 density^(1/2)) (Johnson 1985, section 11.5), and with it the restitution at any speed, stays.
        """
        return properties(self.material)['yieldStress'] * self.softening ** -0.8


@dataclass(frozen=True, kw_only=True)
class DamperParameters(Filling):
    """The filling, the box on its spring, and the force that drives it."""

    TITLE = 'drive'
    RENAMED = OLD_NAMES['damper']

    boxMass: float = parameter(0.3, checks.positive, 'mass of the box', 'kg', DRIVE)
    stiffness: float = parameter(9720.0, checks.notNegative, 'of the spring', 'N/m', DRIVE)
    dashpot: float = parameter(0.0, checks.notNegative, 'viscous damping of the box itself', 'N s/m', DRIVE)
    axis: str = parameter('z', oneOf(('x', 'y', 'z')), 'along which the box moves: z is along gravity', scope=DRIVE)
    forceAmplitude: float = parameter(9.72, checks.positive, 'of the driving force', 'N', DRIVE)
    frequency: float = parameter(25.5, checks.positive, 'of the driving force', 'Hz', DRIVE)
    start: str = parameter('steady', oneOf(STARTS), 'how the box begins: \'steady\', on the response of the empty box (that of the box with the '
                           'particles frozen to it where these are not thrown); \'rest\', from which it takes the free vibration long to die out',
                           scope=DRIVE)
    transientTime: float = parameter(1.0, checks.notNegative, 'of the drive before the measurement, rounded up to whole periods', 's', DRIVE)
    periods: int = parameter(30, count(2), 'of the drive that are measured', scope=DRIVE)
    samples: int = parameter(200, count(20), 'records of the motion per period', scope=DRIVE)
    stepsPerCollision: float = parameter(20.0, checks.positive, 'time steps in an elastic collision of two of the smallest particles', scope=DRIVE)
    collisionSpeed: float = parameter(1.0, checks.positive, 'their speed of approach', 'm/s', DRIVE)

    def transientPeriods(self) -> int:
        """Periods of the drive before the measurement."""
        return math.ceil(self.transientTime * self.frequency)

    def collisionTime(self) -> float:
        """Duration [s] of an elastic collision of two of the smallest particles at collisionSpeed."""
        radius, material = self.smallestHalfSize, self.attributes()
        mass = 4 / 3 * math.pi * material['density'] * radius ** 3
        modulus = material['young'] / (2 * (1 - material['poisson'] ** 2))
        return collisionDuration(mass / 2, radius / 2, modulus, self.collisionSpeed)

    def smallestCriticalStep(self) -> float:
        """Critical (Rayleigh) time step [s] of the smallest particle."""
        return self.criticalTimeStep(self.smallestHalfSize)

    def stepsPerSample(self) -> int:
        """Time steps between two records: as many as keep the time step below both bounds while a period has a whole number of records."""
        longest = min(self.collisionTime() / self.stepsPerCollision, self.timeStepFraction * self.smallestCriticalStep())
        return math.ceil(1 / (self.frequency * self.samples * longest))

    def stepsPerPeriod(self) -> int:
        return self.samples * self.stepsPerSample()

    def timeStep(self) -> float:
        """Time step of the drive [s]."""
        return 1 / (self.frequency * self.samples * self.stepsPerSample())

    def startOfTheBox(self) -> tuple[float, float]:
        """Displacement [m] and velocity [m/s] of the box when the force begins.

        'steady': those of Im(A exp(i omega t)) at t = 0, with the closed form A = F/(k - M omega^2 + i c omega), cut at the height of the box. M
        is the box alone, or with the particles where then its acceleration stays below gravity, so that they are not thrown.
        """
        omega = 2 * math.pi * self.frequency
        if self.start == 'rest':
            return 0.0, 0.0
        for mass in (self.boxMass + self.particlesMass(), self.boxMass):
            ratio = complex(self.stiffness - mass * omega ** 2, self.dashpot * omega)
            size = self.forceAmplitude / max(abs(ratio), self.forceAmplitude / self.boxHeight)
            if size * omega ** 2 < self.gravity:
                break
        amplitude = size * (ratio.conjugate() / abs(ratio) if ratio else -1j)
        return amplitude.imag, amplitude.real * omega

    def naturalFrequency(self, addedMass: float = 0.0) -> float:
        """Of the box on its spring with an `addedMass` [kg] frozen to it [Hz]."""
        return math.sqrt(self.stiffness / (self.boxMass + addedMass)) / (2 * math.pi)
