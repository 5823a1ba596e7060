"""What an oedometer test records: stresses on plate, base and side walls over the strain, and what the particles do meanwhile."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from yade import O, utils
from yade.wrapper import BreakageEngine

from ... import checks
from ...scene.container import Container
from ...scene.engines import engine

if TYPE_CHECKING:
    from .run import OedometerRun, OedometerState

COLUMNS = ('time', 'strain', 'plateStress', 'baseStress', 'lateralStress', 'voidRatio', 'particles', 'events', 'strainRate', 'inertialNumber',
           'unbalancedForce')


class Averages:
    """Mean forces [N] on plate and base over the steps of one record. The sums are kept in the run's `state`, so that an interrupted
    portion of steps is taken up again."""

    def __init__(self, state: OedometerState) -> None:
        self.state, self.plate, self.base = state, state.plate, state.container['baseId']
        self.sums = state.sums = state.sums or {'plate': 0.0, 'base': 0.0, 'steps': 0}

    def add(self) -> None:
        """After a step."""
        self.sums['plate'] += O.forces.f(self.plate)[2]
        self.sums['base'] -= O.forces.f(self.base)[2]
        self.sums['steps'] += 1

    def take(self) -> dict[str, float]:
        """{'plate': ..., 'base': ...}: means, compression positive [N]; the next portion begins."""
        self.state.sums = None
        return {name: self.sums[name] / self.sums['steps'] for name in ('plate', 'base')}


def strain(run: OedometerRun) -> float:
    """Axial strain [-]: what the plate has come down since it sat, over the bed's height then."""
    return float(1 - run.plate.state.pos[2] / run.state.height)


def row(run: OedometerRun, forces: Mapping[str, float], rate: float) -> dict[str, Any]:
    """The record of the portion that has just been run, a dict by COLUMNS; lateral stress and unbalanced force of its last step.

    The inertial number is rate d sqrt(density/stress) with the largest particle's size d and the axial stress on the plate.
    """
    p, height = run.parameters, run.plate.state.pos[2]
    plate = forces['plate'] / run.area
    return {'time': O.time - run.state.startTime, 'strain': strain(run), 'plateStress': plate, 'baseStress': forces['base'] / run.area,
            'lateralStress': lateralForce(run.container) / lateralArea(run, height), 'voidRatio': run.area * height / run.state.solid - 1,
            'particles': particleNumber(run), 'events': eventNumber(), 'strainRate': rate,
            'inertialNumber': rate * p.largestDiameter * math.sqrt(p.density / max(plate, p.seatingStress)),
            'unbalancedForce': utils.unbalancedForce()}


def lateralForce(container: Container) -> float:
    """Sum of the normal forces on the side walls [N]: on a cylinder they have no resultant. In any order of the contacts the same number."""
    contacts = [contact for wall in container.sideIds for contact in O.bodies[wall].intrs() if contact.isReal]
    return math.fsum(contact.phys.normalForce.norm() for contact in contacts)


def lateralArea(run: OedometerRun, height: float) -> float:
    """Of the side walls up to the plate at `height` [m], [m2]."""
    width = run.parameters.containerWidth
    return checks.positive('height', height) * (math.pi * width if run.container.radius is not None else 4 * width)


def particleNumber(run: OedometerRun) -> int:
    """Particles there are."""
    return run.state.particles + sum(number - 1 for number in _childNumbers())


def eventNumber() -> int:
    """Particles that have broken so far."""
    return len(_childNumbers())


def _childNumbers() -> Sequence[int]:
    """Of the fragments of every event so far; none where nothing can break."""
    return engine(BreakageEngine).childNumbers if any(isinstance(candidate, BreakageEngine) for candidate in O.engines) else ()
