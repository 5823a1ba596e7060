"""What a study repeats: one kind of experiment, as the rest of this package needs to know it."""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .particles import Particles

IDS = ('run', 'bed', 'seed')
# Of every summary: what it was computed with.
PROVENANCE = {'threads': ('threads',), 'versionYade': ('versions', 'yade'), 'versionPlugin': ('versions', 'yade-superquadric'),
              'versionPython': ('versions', 'python'), 'versionNumpy': ('versions', 'numpy')}


@dataclass(frozen=True)
class Experiment:
    """A kind of experiment: a bed of particles is made from a seed, then used by one or more runs.

    Both are jobs of `script`, which is called with `--parameters FILE --output FOLDER` and `--bedOnly` for a bed, or `--bed FOLDER` for a run; it
    writes bed.json, or summary.json, last of all. Where beds are no jobs of their own a run makes its bed itself, and `--bed` is not given.
    """

    name: str                 # in study files and plans
    script: str               # of scripts/
    folder: str               # of the study's folder: where the runs are; also what they are called
    parameters: type[Particles]
    bedJobs: bool             # whether beds are jobs of their own
    particleCount: Callable[[Any], int]  # (parameters) -> number of particles, for limits of memory and time
    costs: Callable[[int], tuple[float, float]]  # (particles) -> computing times of a bed and of a run on it, in any unit
    # (parameters, number) -> parameters by which so many runs on one bed differ, the first one {}; None: one run only
    places: Callable[[Any, int], Sequence[Mapping[str, Any]]] | None
    measured: dict            # column of the table: where its value is in summary.json
    derived: dict             # column of the table: function of the summary that gives its value
    mayBeMissing: tuple       # columns that may be null in a summary
    runSeconds: str           # the column that holds the wall time of a run [s]; that of a bed that is a job is in bedSeconds
    shown: tuple              # columns of the page's table of points, the first one with its interval
    concerns: Callable        # (finished rows of the table) -> sentences on what should make the reader doubt
    validations: dict         # name in a study file: picture that a script of that name draws into figures/
    drawings: dict            # kind of figure, beside those that all studies have: function (data, series, values, panels, records) -> figure

    def planned(self, values: Mapping[str, Any]) -> Particles:
        """Complete parameters from `values`, in the one form that equal beds have in common.

        :raises ValueError: they cannot be
        """
        return self.parameters.checked(values).standard()

    def defaults(self) -> dict[str, Any]:
        """{name: default} of all parameters."""
        return self.parameters.defaults()

    def given(self) -> tuple[str, ...]:
        """The columns that hold parameters, as asked for."""
        return tuple(name for name in self.parameters.declarations() if name != 'seed')

    def columns(self) -> tuple[str, ...]:
        """All columns of the table of results."""
        return (*IDS, *self.given(), *self.measured, *self.derived)
