"""What a study repeats: one kind of experiment, as the rest of this package needs to know it."""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .particles import Particles
from .quantities import THREADS, Quantity

Summary = Mapping[str, Any]

IDS = ('run', 'bed', 'seed')


@dataclass(frozen=True)
class Column:
    """A measured column of the table of results, declared once: where its value is, and how readers see it.

    :param source: place in summary.json, such as 'impact.peak', or a function of the summary
    :param quantity: None for what figures and findings cannot ask for
    :param mayBeMissing: whether the value, or a part on the way to it, may be null
    """

    name: str
    source: str | Callable[[Summary], Any]
    quantity: Quantity | None = None
    mayBeMissing: bool = False

    def of(self, summary: Summary) -> Any:
        """The value in a summary.

        :raises KeyError, TypeError: the summary is not like that; :raises ValueError: null that must not be
        """
        value = self.source(summary) if callable(self.source) else self._at(summary, self.source.split('.'))
        if value is None and not self.mayBeMissing:
            raise ValueError(f'{self.name} is null')
        return value

    def _at(self, content: Any, keys: Sequence[str]) -> Any:
        for key in keys:
            if content is None and self.mayBeMissing:
                return None
            content = content[key]
        return content


# Of every summary: what it was computed with.
PROVENANCE = (Column('threads', 'threads', THREADS), Column('versionYade', 'versions.yade'), Column('versionPlugin', 'versions.yade-superquadric'),
              Column('versionPython', 'versions.python'), Column('versionNumpy', 'versions.numpy'))


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
    measured: tuple[Column, ...]  # columns of the table beside the parameters
    runSeconds: str           # the column that holds the wall time of a run [s]; that of a bed that is a job is in bedSeconds
    shown: tuple[str, ...]    # columns of the page's table of points, the first one with its interval
    concerns: Callable[[Any], list[str]]  # (finished rows of the table) -> sentences on what should make the reader doubt
    validations: dict[str, str]  # name in a study file: picture that a script of that name draws into figures/
    # kind of figure, beside those that all studies have: function (data, series, values, panels, records) -> figure
    drawings: dict[str, Callable[..., Any]]

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
        return (*IDS, *self.given(), *(column.name for column in self.measured))

    def quantities(self) -> dict[str, Quantity]:
        """{column: quantity} of those that figures and findings may ask for."""
        return {column.name: column.quantity for column in self.measured if column.quantity is not None}

    def checkedQuantity(self, name: str, value: Any) -> str:
        """`value` if it is the column of a quantity."""
        known = self.quantities()
        if not isinstance(value, str) or value not in known:
            raise ValueError(f'{name} = {value!r}: must be one of {", ".join(known)}')
        return value
