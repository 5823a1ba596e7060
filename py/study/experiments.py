"""The kinds of experiment that studies know."""
from .dampers import DAMPERS
from .impacts import IMPACTS
from .oedometers import OEDOMETERS

EXPERIMENTS = {experiment.name: experiment for experiment in (IMPACTS, DAMPERS, OEDOMETERS)}


def experimentOf(plan):
    """The `Experiment` of a plan, or of a checked study."""
    return EXPERIMENTS[plan['experiment']]
