"""Parameters of the material of particles and walls."""
from __future__ import annotations

import math
from dataclasses import dataclass

from .. import checks
from ..runs.parameters import Parameters, between, optional, parameter, within
from ..scene.restitution import normalDampingFor
from ..scene.timestep import rayleighTimeStep


@dataclass(frozen=True, kw_only=True)
class Material(Parameters):
    """What the contact law of Wang & Ji (2018), and in its elastic range that of Li et al. (2018), asks of a material."""

    TITLE = 'material'

    density: float = parameter(2500.0, checks.positive, 'density of the particles', 'kg/m3')
    young: float = parameter(1e9, checks.positive, 'Young\'s modulus of the particles and of all that they touch', 'Pa')
    poisson: float = parameter(0.2, between(-1, 0.5), 'Poisson\'s ratio of the same')
    friction: float = parameter(0.5, checks.notNegative, 'coefficient of sliding friction')
    restitution: float | None = parameter(0.5, optional(checks.finite), 'coefficient of restitution of the viscous normal force, from which '
                                          'normalDamping follows')
    normalDamping: float | None = parameter(None, optional(within(0, 1, False)), 'coefficient Cn of the viscous normal force (Wang & Ji 2018), '
                                            'instead of restitution', insteadOf='restitution')
    tangentialDamping: float | None = parameter(None, optional(checks.notNegative), 'coefficient Ct of the viscous tangential force; where '
                                                'none is given it is Cn')
    rollingFriction: float = parameter(0.002, checks.notNegative, 'coefficient mu_r of rolling friction (Wang & Ji 2018)')

    def check(self) -> None:
        super().check()
        if self.restitution is not None and self.normalDamping is not None:
            raise ValueError(f'normalDamping = {self.normalDamping!r}: follows from restitution = {self.restitution!r}; only one can be given')
        self.normalDampingCoefficient()

    def normalDampingCoefficient(self) -> float:
        """Cn [-], as given or as it follows from the restitution."""
        if self.normalDamping is not None:
            return self.normalDamping
        if self.restitution is None:
            raise ValueError('restitution = None: must be given, or else normalDamping')
        return normalDampingFor(self.restitution)

    def attributes(self) -> dict[str, float]:
        """Keyword arguments of YADE's `CurvatureMat`."""
        normal = self.normalDampingCoefficient()
        return {'young': self.young, 'poisson': self.poisson, 'density': self.density, 'frictionAngle': math.atan(self.friction),
                'normalDamping': normal, 'tangentialDamping': normal if self.tangentialDamping is None else self.tangentialDamping,
                'rollingFriction': self.rollingFriction}

    def criticalTimeStep(self, halfSize: float) -> float:
        """Critical (Rayleigh) time step [s] of a particle of this smallest half size [m]."""
        attributes = self.attributes()
        return rayleighTimeStep(halfSize, attributes['young'], attributes['poisson'], attributes['density'])
