"""The table of a study: one row a finished run, from the runs' summaries."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import pandas

from ..files import results
from .experiments import experimentOf

if TYPE_CHECKING:
    from ..experiments.experiment import Experiment
    from ..typealiases import PathLike

SUMMARY = 'summary.json'


def summaryPath(plan: Mapping[str, Any], folder: PathLike, run: str) -> str:
    """Where the run `run` of the plan of a study in `folder` has its summary."""
    return os.path.join(folder, plan['folder'], run, SUMMARY)


def finishedRuns(plan: Mapping[str, Any], folder: PathLike) -> list[str]:
    """Ids of the runs that have a summary, in the plan's order."""
    return [run for run in plan['runs'] if os.path.exists(summaryPath(plan, folder, run))]


def tableOf(plan: Mapping[str, Any], folder: PathLike) -> pandas.DataFrame:
    """The table of the plan's finished runs, in the plan's order, as a pandas DataFrame with the columns of its experiment.

    :param folder: of the study, with a folder for each run
    :raises ValueError: a summary that is damaged or belongs to other parameters; names the file
    """
    rows = [rowOf(plan, run, readSummary(plan, folder, run)) for run in finishedRuns(plan, folder)]
    return pandas.DataFrame(rows, columns=list(experimentOf(plan).columns()))


def readSummary(plan: Mapping[str, Any], folder: PathLike, run: str) -> dict[str, Any]:
    """The complete summary of the run `run`, if it is one of a run with its parameters.

    :raises ValueError: it holds something else; naming the file
    :raises OSError: it cannot be read, which says nothing about what it holds
    """
    path, parameters = summaryPath(plan, folder, run), plan['runs'][run]['parameters']
    try:
        summary = results.readJson(path)
        _measured(experimentOf(plan), summary)
        given = summary['parameters']
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f'{path}: damaged ({type(error).__name__}: {error})') from None
    different = sorted(name for name in {*given, *parameters} if given.get(name) != parameters.get(name))
    if different:
        name = different[0]
        raise ValueError(f'{path}: belongs to other parameters, {name} = {given.get(name)!r} instead of {parameters.get(name)!r}')
    return summary


def rowOf(plan: Mapping[str, Any], run: str, summary: Mapping[str, Any]) -> dict[str, Any]:
    """{column: value} of one run: its id, what the plan says of it, its summary."""
    experiment, parameters = experimentOf(plan), plan['runs'][run]['parameters']
    return {'run': run, 'bed': plan['runs'][run]['bed'], 'seed': parameters['seed'],
            **{name: parameters[name] for name in experiment.given()}, **_measured(experiment, summary)}


def write(table: pandas.DataFrame, path: PathLike) -> None:
    """Write the table as CSV; numbers keep all their digits. The file takes its name when it is complete."""
    with results.Replacing(path) as file:
        table.to_csv(file, index=False, lineterminator='\n')


def _measured(experiment: Experiment, summary: Mapping[str, Any]) -> dict[str, Any]:
    """{column: value} of what the summary holds; KeyError or ValueError where it does not hold all of it."""
    return {column.name: column.of(summary) for column in experiment.measured}
