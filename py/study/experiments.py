"""The kinds of experiment that studies know."""
from ..experiments.damper.study import DAMPERS
from ..experiments.impact.study import IMPACTS
from ..experiments.oedometer.study import OEDOMETERS

EXPERIMENTS = {experiment.name: experiment for experiment in (IMPACTS, DAMPERS, OEDOMETERS)}


def experimentOf(plan):
    """The `Experiment` of a plan, or of a checked study."""
    return EXPERIMENTS[plan['experiment']]
