"""The kinds of experiment that studies know, and the quantities of all of them."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..experiments.damper.study import DAMPERS
from ..experiments.impact.study import IMPACTS
from ..experiments.oedometer.study import OEDOMETERS

if TYPE_CHECKING:
    from ..experiments.experiment import Experiment

EXPERIMENTS = {experiment.name: experiment for experiment in (IMPACTS, DAMPERS, OEDOMETERS)}
# {column: `quantities.Quantity`}: a column of this name has the same in all experiments.
QUANTITIES = {name: quantity for experiment in EXPERIMENTS.values() for name, quantity in experiment.quantities().items()}


def experimentOf(plan: Mapping[str, Any]) -> Experiment:
    """The `Experiment` of a plan, or of a checked study."""
    return EXPERIMENTS[plan['experiment']]
