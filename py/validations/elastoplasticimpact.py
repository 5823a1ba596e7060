"""A sphere against a rigid wall under the elastoplastic law: the path of force over overlap, and restitution over speed."""
from __future__ import annotations

import math
import statistics
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import ElastoplasticMat

from .. import checks
from ..scene.engines import criticalTimeStep, superquadricEngines

STEPS = 500         # a collision, counted as the elastic one of the same speed lasts; restitution to 1e-4
LARGEST_STEP = 0.1  # of the critical time step
STUDENT = {2: 4.303, 3: 3.182, 4: 2.776, 5: 2.571, 6: 2.447, 7: 2.365, 8: 2.306}  # t of 95 % by degrees of freedom

# About aluminium; the numbers of the hardening are a plausible example, not a fit.
ALUMINIUM = dict(young=70e9, poisson=0.33, density=2700.0, frictionAngle=0.0, yieldStress=100e6, m0=2.6, exponent=2.0)


class YieldPoint(NamedTuple):
    """overlap dy [m] and force fy [N] at the onset of yield (Li, Gao, Zhang & Liu 2018), and the speed that just reaches it [m/s]."""

    overlap: float
    force: float
    speed: float


class PowerLaw(NamedTuple):
    """y = factor x^exponent; halfWidth: of the exponent's 95 % interval."""

    exponent: float
    halfWidth: float
    factor: float


def yieldPoint(material: Any, radius: float) -> YieldPoint:
    """`YieldPoint` of a sphere of `radius` [m] against a rigid wall, both of the `material`."""
    modulus = _modulus(material)
    slope = math.pi * 1.6 * material.yieldStress / (2 * modulus)
    overlap = slope ** 2 * radius
    force = 4 / 3 * modulus * math.sqrt(radius) * overlap ** 1.5
    return YieldPoint(overlap, force, math.sqrt(4 / 5 * force * overlap / _mass(material, radius)))


def pressedPath(properties: Mapping[str, Any], radius: float, turningPoints: Sequence[float], points: int = 100) -> list[list[tuple[float, float]]]:
    """Force [N] over overlap [m] of a sphere that is pressed into the wall to one overlap after the other.

    :param properties: attributes of the `ElastoplasticMat` of both; :param radius: [m]
    :param turningPoints: overlaps [m], not negative; the path starts at 0
    :param points: between two of them
    :returns: list of paths, one a turning point, each a list of (overlap, force)
    """
    sphere = _scene(properties, radius)
    O.engines = O.engines[:-1]  # moved by hand
    paths, overlap = [], 0.0
    for end in turningPoints:
        places = [overlap + (end - overlap) * i / points for i in range(points + 1)]
        paths.append([(place, _forceAt(sphere, radius, place)) for place in places])
        overlap = end
    return paths


def restitution(properties: Mapping[str, Any], radius: float, speed: float, steps: int = STEPS) -> float:
    """Speed after over speed before of a sphere that hits the wall.

    :param properties: attributes of the `ElastoplasticMat` of both; :param radius: [m]; :param speed: [m/s]
    :param steps: of the collision, counted as the elastic one lasts
    """
    speed = checks.positive('speed', speed)
    sphere = _scene(properties, radius)
    sphere.state.vel = Vector3(0, 0, -speed)
    # Johnson, section 11.4: Hertz's collision.
    duration = 2.87 * (sphere.state.mass ** 2 / (radius * _modulus(sphere.mat) ** 2 * speed)) ** 0.2
    O.dt = min(duration / checks.wholeNumber('steps', steps, 1), LARGEST_STEP * criticalTimeStep())
    touched = False
    while not touched or O.interactions.countReal():
        O.step()
        touched = touched or O.interactions.countReal() > 0
    return sphere.state.vel[2] / speed


def powerLaw(x: Sequence[float], y: Sequence[float]) -> PowerLaw:
    """`PowerLaw` through positive values by least squares of their logarithms; four to ten of them."""
    logs = [math.log(value) for value in x], [math.log(value) for value in y]
    slope, intercept = statistics.linear_regression(*logs)
    rest = sum((b - intercept - slope * a) ** 2 for a, b in zip(*logs)) / (len(x) - 2)
    spread = sum((a - statistics.mean(logs[0])) ** 2 for a in logs[0])
    return PowerLaw(slope, STUDENT[len(x) - 2] * math.sqrt(rest / spread), math.exp(intercept))


def limitExponent(hardeningExponent: float) -> float:
    """Exponent of the restitution over speed far above yield, (H - 3)/(H + 2): Johnson's -1/4 for H = 2.

    There f ~ a^H with a ~ d^(1/2). Loading takes the work v^2 ~ f d, unloading gives back f^2/a of it.
    """
    return (hardeningExponent - 3) / (hardeningExponent + 2)


def _modulus(material: Any) -> float:
    return material.young / (2 * (1 - material.poisson ** 2))


def _mass(material: Any, radius: float) -> float:
    return 4 / 3 * math.pi * radius ** 3 * material.density


def _scene(properties: Mapping[str, Any], radius: float) -> Any:
    """A new scene of a wall and a sphere that touches it; the sphere."""
    radius = checks.positive('radius', radius)
    material = ElastoplasticMat(**properties)
    O.reset()
    O.materials.append(material)
    O.bodies.append(utils.wall(0, 2, material=material))
    sphere = utils.sphere((0, 0, radius), radius, material=material)
    O.bodies.append(sphere)
    O.engines = superquadricEngines(gravity=(0, 0, 0), verletDist=0, law='elastoplastic')
    return sphere


def _forceAt(sphere: Any, radius: float, overlap: float) -> float:
    sphere.state.pos = Vector3(0, 0, radius - overlap)
    O.step()
    contacts = [interaction.phys for interaction in O.interactions]
    return contacts[0].normalForce[2] if contacts else 0.0
