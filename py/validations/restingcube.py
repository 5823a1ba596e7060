"""A cube dropped on a wall or on another cube, and how well it stays where it came to rest."""
from __future__ import annotations

import math
from typing import Any, NamedTuple

from yade import O, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat

from ..scene.bodies import superquadric
from ..scene.engines import checkTimeStep, criticalTimeStep, superquadricEngines

HALF = 5e-3  # half size of the cubes [m]
GRAVITY = 9.81  # [m/s2]
GAP = 0.01 * HALF  # it falls by [m]
TILT = Quaternion(Vector3(1, 2, 0).normalized(), 0.02)  # when it is let go
REST = 1e-10  # kinetic energy, in units of the weight times the overlap, below which it is said to be at rest
STUDY = dict(poisson=0.2, density=2500, frictionAngle=math.atan(0.4), normalDamping=0.1, tangentialDamping=0.1, rollingFriction=0.002)



class Drift(NamedTuple):
    """Largest distance [m] and rotation [rad] from where the watch began, and kinetic energy at its end [m g d]; None: it has lost the floor."""

    shift: float
    turn: float
    energy: float | None


class RestingCube:
    """A scene with a cube above the floor, about to fall.

    :param floor: 'wall', or 'cube' for another one that is fixed
    :param n: both exponents; :param young: [Pa]
    :param offset: horizontal distance of the centres, and as much as a sixth of it to the side, in half sizes
    :param slope: of the floor [-]; the scene keeps its axes and gravity leans over
    :param material: attributes of the CurvatureMat other than those of the paper's study
    """

    def __init__(self, floor: str, n: float = 8, young: float = 1e9, offset: float = 0.24, slope: float = 0.0, **material: Any) -> None:
        O.reset()
        stuff = CurvatureMat(**dict(STUDY, young=young, **material))
        self.cube = superquadric((0, 0, 0), (HALF,) * 3, n, n, material=stuff, orientation=TILT)
        reach = self.cube.shape.support(TILT.conjugate() * Vector3(0, 0, -1))
        self.cube.state.pos = Vector3(offset * HALF, offset / 6 * HALF, reach + GAP)
        if floor == 'wall':
            base = utils.wall(0, axis=2, material=stuff)
        else:
            base = superquadric((0, 0, -HALF), (HALF,) * 3, n, n, material=stuff, fixed=True)
        O.bodies.append([base, self.cube])
        down = Vector3(slope, 0, -1)
        O.engines = superquadricEngines(gravity=GRAVITY * down.normalized())
        O.dt = checkTimeStep(0.1 * criticalTimeStep())

    def overlap(self) -> float | None:
        """[m]; None without a contact."""
        touching = O.interactions.has(0, 1) and O.interactions[0, 1].isReal
        return O.interactions[0, 1].geom.penetrationDepth if touching else None

    def energy(self) -> float | None:
        """Kinetic energy over weight times overlap [-]; None without a contact."""
        state, overlap = self.cube.state, self.overlap()
        kinetic = (state.mass * state.vel.squaredNorm() + state.inertia[0] * state.angVel.squaredNorm()) / 2
        return None if overlap is None else kinetic / (state.mass * GRAVITY * overlap)

    def settle(self, most: int) -> int | None:
        """Step until it is at rest, by 5,000 at a time; the number of steps, None when `most` were not enough."""
        while O.iter < most:
            O.run(5000, wait=True)
            energy = self.energy()
            if energy is not None and energy < REST:
                return O.iter
        return None

    def watch(self, steps: int, looks: int = 10) -> Drift:
        """`Drift` over that many steps from now, looked at `looks` times."""
        state = self.cube.state
        place, orientation = Vector3(state.pos), Quaternion(state.ori)
        shift = turn = 0.0
        for _ in range(looks):
            O.run(steps // looks, wait=True)
            swung = orientation.conjugate() * state.ori
            shift = max(shift, (state.pos - place).norm())
            turn = max(turn, 2 * math.asin(min(1, Vector3(swung[0], swung[1], swung[2]).norm())))
        return Drift(shift, turn, self.energy())
