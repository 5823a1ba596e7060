"""The impact: a sphere falls on the bed, the force on the base is recorded, and its pulse is measured."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from yade import O, utils
from yade.minieigenHP import Vector3

from ... import checks
from ...pictures.snapshotrecorder import SnapshotRecorder
from ...scene.container import Container
from ...scene.engines import criticalTimeStep, superquadricEngines
from ...scene.stepping import Stepper
from .fall import CLEARANCE, speedAt, surfaceSpeed
from .pulse import Pulse, pulse

QUIET_THRESHOLD = 0.05       # of the peak: the impact is over when the force has stayed below
QUIET_TIME = 4e-3            # s for which it must have stayed below
CHECK_STEPS = 100            # time steps between two looks whether it is over


class BareImpact(NamedTuple):
    """Impact without a bed: its `Pulse`, and the force on the base [N] at the times [s]."""

    pulse: Pulse
    times: list[float]
    forces: list[float]


def addImpactor(diameter: float, density: float, material: Any, speed: float, dropHeight: float, surface: float, obstacles: Iterable[int],
                gravity: float = 9.81, place: tuple[float, float] = (0.0, 0.0)) -> int:
    """Put the impactor, a YADE sphere, into the scene above a place of the base, on its way down.

    It has `speed` [m/s] at `dropHeight` [m] above the `surface` [m]. The free fall is not simulated: the sphere
    starts just above the highest obstacle below it, with the speed that it has there.

    :param diameter: [m]; :param density: [kg/m3]
    :param material: `CurvatureMat` in O.materials whose other parameters it takes
    :param obstacles: ids of the particles; only those beneath the sphere count
    :param gravity: downward [m/s2]
    :param place: x and y of its centre [m]
    :returns: its id
    :raises ValueError: a bad value, or it would not get as high as the highest obstacle; nothing has been added then
    """
    radius = checks.positive('impactor diameter', diameter) / 2
    density, gravity = checks.positive('impactor density', density), checks.positive('gravity', gravity)
    speed, dropHeight = checks.notNegative('speed', speed), checks.notNegative('dropHeight', dropHeight)
    surface, place = checks.finite('surface', surface), checks.pair('place', place)
    bottom = max([surface] + [top for top in map(_topBeneath(radius, place), obstacles) if top is not None]) + CLEARANCE
    startSpeed = speedAt(bottom - surface, speed, dropHeight, gravity)
    own = type(material)(**{**material.dict(), 'id': -1, 'label': '', 'density': density})
    O.materials.append(own)
    body = utils.sphere((*place, bottom + radius), radius, material=own, color=(0.8, 0.2, 0.15))
    body.state.vel = Vector3(0, 0, -startSpeed)
    return int(O.bodies.append(body))


def _topBeneath(radius: float, place: tuple[float, float]) -> Callable[[int], float | None]:
    """Function that gives the upper end [m] of a particle's bounding sphere, None if it is out of the way."""
    def top(bodyId: int) -> float | None:
        body = O.bodies[bodyId]
        reach = getattr(body.shape, 'radius', None) or body.shape.boundingRadius()
        x, y, z = body.state.pos
        return z + reach if math.hypot(x - place[0], y - place[1]) < radius + reach else None
    return top


def supportForce(ids: Iterable[int]) -> float:
    """Vertical force of the particles on the bodies `ids` in the last step, down positive [N]."""
    force: float = -sum(O.forces.f(i)[2] for i in ids)
    return force


class Recorder:
    """Time series of an impact; `sample` goes after every step (as `afterStep` of `Stepper.run`).

    Columns: time [s] from the start of the record; baseForce, wallForce: vertical force of the particles on base and side
    walls, down positive [N]; impactorForce: vertical contact force on the impactor, up positive [N]; impactorHeight: its
    lowest point above the base [m]; impactorVelocity: up positive [m/s]. Forces and height belong to the same
    moment, the velocity to half a time step later (YADE integrates by leap-frog).
    """

    COLUMNS = ('time', 'baseForce', 'wallForce', 'impactorForce', 'impactorHeight', 'impactorVelocity')

    def __init__(self, container: Container, impactorId: int, startTime: float | None = None, rows: Iterable[Iterable[float]] = ()) -> None:
        self.container, self.impactorId = container, impactorId
        self.startTime: float = O.time if startTime is None else startTime
        self.rows = [tuple(row) for row in rows]

    def sample(self) -> None:
        impactor = O.bodies[self.impactorId]
        height = impactor.state.pos[2] - impactor.state.vel[2] * O.dt - impactor.shape.radius
        self.rows.append((O.time - O.dt - self.startTime, supportForce([self.container.baseId]),
                          supportForce(self.container.sideIds), -supportForce([self.impactorId]), height,
                          impactor.state.vel[2]))

    def column(self, name: str) -> list[float]:
        index = self.COLUMNS.index(name)
        return [row[index] for row in self.rows]


class EndOfImpact:
    """Whether the impact is over: the impactor has touched, and since the peak the force on the base (less the static
    one) has stayed within QUIET_THRESHOLD of the peak for QUIET_TIME."""

    def __init__(self, recorder: Recorder, staticForce: float) -> None:
        self.recorder, self.staticForce = recorder, staticForce

    def check(self) -> bool:
        peak, loudest = 0.0, None
        for row in self.recorder.rows:
            extra = row[1] - self.staticForce
            peak = max(peak, extra)
        if not any(row[3] > 0 for row in self.recorder.rows):
            return False
        for row in reversed(self.recorder.rows):
            if abs(row[1] - self.staticForce) > QUIET_THRESHOLD * peak:
                loudest = row[0]
                break
        return loudest is not None and self.recorder.rows[-1][0] - loudest > QUIET_TIME


def recordImpact(stepper: Stepper, recorder: Recorder, staticForce: float, maxTime: float, film: SnapshotRecorder | None = None) -> bool:
    """Step and record until the impact is over, or for `maxTime` [s] at most; a `film` looks on. Returns whether it was over."""
    end = EndOfImpact(recorder, staticForce)

    def sample() -> None:
        recorder.sample()
        if film is not None:
            film.sample()
    while True:
        stepper.run(CHECK_STEPS, sample)
        if end.check():
            return True
        if O.time - recorder.startTime >= maxTime:
            return False


def bareImpact(diameter: float, density: float, material: Any, speed: float, dropHeight: float, gravity: float = 9.81,
               baseYoung: float | None = None) -> BareImpact:
    """The same impact on the bare base, for P0: done in YADE's other scene, so that the present one is not touched.

    :param diameter: of the impactor [m]; :param density: its own [kg/m3]
    :param material: `CurvatureMat` of base and impactor
    :param speed: [m/s] that it has `dropHeight` above the base; :param dropHeight: [m]; :param gravity: downward [m/s2]
    :param baseYoung: Young's modulus of the base [Pa], instead of the material's
    :returns: `BareImpact`
    :raises ValueError: it would not get off the base, or have no speed there
    """
    if surfaceSpeed(speed, dropHeight, gravity) == 0:
        raise ValueError(f'speed = {speed!r}: with dropHeight = {dropHeight!r} the impactor reaches the base without speed')
    parameters = {**material.dict(), 'id': -1, 'label': ''}
    O.switchScene()
    try:
        O.resetThisScene()
        own = type(material)(**parameters)
        O.materials.append(own)
        ground = own if baseYoung is None else type(material)(**{**parameters, 'young': checks.positive('baseYoung', baseYoung)})
        base = O.bodies.append(utils.wall(0.0, 2, sense=1, material=ground))
        impactor = addImpactor(diameter, density, own, speed, dropHeight, 0.0, (), gravity)
        O.engines = superquadricEngines(gravity=(0, 0, -gravity))
        O.dt = 0.005 * criticalTimeStep()  # its contact lasts about 200 such steps
        recorder = Recorder(Container(base, (), None, None, None, 0.0), impactor)
        recordImpact(Stepper(stream=None), recorder, 0.0, maxTime=0.1)
        times, forces = recorder.column('time'), recorder.column('baseForce')
        return BareImpact(pulse(times, forces, 0.0), times, forces)
    finally:
        O.resetThisScene()
        O.switchScene()
