"""A cylinder that hits a plane at an angle, against the rigid-body solution (validation 1 of the paper).

Wang & Ji, Acta Phys. Sin. 67, 094501 (2018), table 1 and eqs. (15), (16); original: Kodam et al., Chem. Eng. Sci. 65, 5852 (2010).
The angle is the one between the cylinder's axis and the plane's normal: at 0 it lands on its end, at 90 degrees on its side.
"""
from __future__ import annotations

import math
from typing import NamedTuple

from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

from ..scene.bodies import superquadric
from ..scene.engines import superquadricEngines

# Table 1 of the paper.
DIAMETER = 8e-3  # [m]
LENGTH = 5.3e-3  # [m]
MASS = 3.1e-4  # [kg]
INERTIA = 1.964e-9  # across the axis, the ideal cylinder's [kg m2]
YOUNG = 3.105e9  # [Pa]
POISSON = 0.35
NORMAL_DAMPING = 0.05
DENSITY = 1164.0  # [kg/m3]
TIME_STEP = 5e-7  # [s]
SPEED = 1.0  # before the impact [m/s]
RESTITUTION = 0.85


class Rebound(NamedTuple):
    """Motion after the impact: vertical velocity, upwards [m/s], and angular velocity [rad/s] that lifts the far side."""

    velocity: float
    spin: float


def closedForm(lever: float, mass: float, inertia: float, restitution: float = RESTITUTION) -> Rebound:
    """Rebound of a rigid body that a frictionless plane meets at the horizontal distance `lever` [m] from its centre.

    :param mass: [kg]; :param inertia: about the horizontal axis across the lever [kg m2]
    """
    spin = mass * SPEED * (1 + restitution) * lever / (inertia + mass * lever ** 2)
    # Equation (16) of Wang & Ji in the form that also holds for lever = 0: the contact point leaves at restitution times its speed.
    return Rebound(restitution * SPEED - spin * lever, spin)


def idealLever(angle: float) -> float:
    """Horizontal distance [m] from the centre to the sharp corner of the ideal cylinder that hits first, r cos(phi + theta)."""
    if angle in (0, 90):
        return 0.0
    r, phi = math.hypot(DIAMETER / 2, LENGTH / 2), math.atan2(LENGTH, DIAMETER)
    return r * math.cos(phi + math.radians(angle))


def impact(angle: float, n1: float = 8.0, damping: float = NORMAL_DAMPING) -> tuple[Rebound, Rebound]:
    """Let the cylinder of exponents (n1, 2) hit the plane at `angle` [degrees]; clears the scene.

    :returns: the measured Rebound, and the closed form's for the particle's real lever arm, mass and inertia. Flat on its end or
        side (0 and 90 degrees) the lever is zero by symmetry; computed there, it would be one of rounding.
    """
    O.reset()
    material = O.materials.append(CurvatureMat(young=YOUNG, poisson=POISSON, density=DENSITY, frictionAngle=0.0, normalDamping=damping))
    tilt = Quaternion(Vector3.UnitY, math.radians(angle))
    wall = O.bodies.append(utils.wall(0.0, axis=2, sense=1, material=material))
    body = superquadric((0, 0, 0), (DIAMETER / 2, DIAMETER / 2, LENGTH / 2), n1, 2.0, material, tilt)
    lowest = tilt * body.shape.supportPoint(tilt.conjugate() * Vector3(0, 0, -1))
    body.state.pos = Vector3(0, 0, -lowest[2] + SPEED * TIME_STEP)
    body.state.vel = Vector3(0, 0, -SPEED)
    particle = O.bodies.append(body)
    O.engines = superquadricEngines(gravity=(0, 0, 0))
    O.dt = TIME_STEP
    _runFirstContact(wall, particle)
    # A force at x = lever turns the body by -y for a positive lever: the far side goes up.
    measured = Rebound(body.state.vel[2], -body.state.angVel[1])
    lever = 0.0 if angle in (0, 90) else lowest[0]
    return measured, closedForm(lever, body.state.mass, body.state.inertia[1])


def _runFirstContact(wall: int, particle: int, limit: int = 20000) -> None:
    """Run until the first contact has come and gone: the paper takes the wall away then."""
    touched = False
    for _ in range(limit):
        O.step()
        touching = O.interactions.has(wall, particle) and O.interactions[wall, particle].isReal
        if touched and not touching:
            return
        touched = touched or touching
    raise RuntimeError(f'the cylinder was still {"in contact" if touched else "on its way"} after {limit} steps')
