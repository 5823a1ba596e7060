"""The scene of a bed that is about to be poured, and how many particles it takes."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from yade import O
from yade.wrapper import CurvatureMat

from ...scene.container import Container
from ...scene.engines import criticalTimeStep, superquadricEngines
from ...scene.expectedbed import DENSEST
from ...scene.filling import rainFilling
from ...scene.walls import cylinderContainer
from .parameters import PouredBed

MOST_POURS = 6      # of a bed whose thickness is not the one aimed at, before the best one is taken
SOFT_SHARE = 0.8    # of thicknessTolerance is what the soft bed may be off; the rest is for what it swells by when it gets stiff
DENSE = 0.99 * DENSEST  # only a bed that would not fit if it packed as densely is refused


def rain(p: PouredBed, number: int) -> tuple[Sequence[int], Container]:
    """Drop YADE's present scene and make the container with so many soft particles on their way down, engines and time step.

    :returns: (ids of the particles, `Container`), as from `rainFilling`
    """
    O.reset()
    material = CurvatureMat(**{**p.attributes(), 'young': p.young / p.pouringSoftening}, label='particles')
    O.materials.append(material)
    container = cylinderContainer(p.containerDiameter / 2, p.containerHeight, material, p.meanShape.boundingRadius)
    # That the bed fits has been checked with the fraction that is expected (`PouredBed.check`). A bed that is poured again because
    # that was wrong must not be refused for it.
    ids, filled = rainFilling(p.drawnShapes(number, p.seed), container, material, p.seed, p.rainSpeed, DENSE, p.rainGap, p.rainSideways)
    O.engines = superquadricEngines(gravity=(0, 0, -p.gravity))
    O.dt = p.timeStepFraction * criticalTimeStep()
    return ids, filled


def nextCount(pours: Sequence[Mapping[str, Any]], thickness: float, tolerance: float) -> int | None:
    """How many particles to pour after the `pours` so far, a list of {'number', 'thickness' [m]}; None if the last one is the bed.

    That is so when its thickness is the one aimed at within SOFT_SHARE of the relative `tolerance`. When there is no new number to try,
    or after MOST_POURS, the best pour is repeated: the same number gives the same bed.
    """
    def error(pour: Mapping[str, Any]) -> float:
        return abs(pour['thickness'] / thickness - 1)

    last, best = pours[-1], min(pours, key=error)
    if error(last) <= SOFT_SHARE * tolerance:
        return None
    better = max(1, round(last['number'] * thickness / last['thickness']))
    if len(pours) < MOST_POURS and better not in [pour['number'] for pour in pours]:
        return better
    return None if best['number'] == last['number'] else int(best['number'])
