"""The kinds of experiment that studies know."""
from .dampers import DAMPERS
from .impacts import IMPACTS

EXPERIMENTS = {experiment.name: experiment for experiment in (IMPACTS, DAMPERS)}


def experimentOf(plan):
    """The `Experiment` of a plan, or of a checked study."""
    return EXPERIMENTS[plan['experiment']]
