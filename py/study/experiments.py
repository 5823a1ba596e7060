"""The kinds of experiment that studies know."""
from .impacts import IMPACTS

EXPERIMENTS = {experiment.name: experiment for experiment in (IMPACTS,)}


def experimentOf(plan):
    """The `Experiment` of a plan, or of a checked study."""
    return EXPERIMENTS[plan['experiment']]
