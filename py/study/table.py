"""The table of a study: one row a finished run, from the runs' summaries."""
import os

import pandas

from .. import results
from .columns import COLUMNS, GIVEN, MAY_BE_MISSING, MEASURED

SUMMARY = 'summary.json'


def summaryPath(folder, run):
    """Where the run `run` of a study in `folder` has its summary."""
    return os.path.join(folder, 'impacts', run, SUMMARY)


def tableOf(plan, folder):
    """The table of the plan's finished runs, in the plan's order, as a pandas DataFrame with the columns `columns.COLUMNS`.

    :param folder: of the study, with the runs in impacts/
    :raises ValueError: a summary that is damaged or belongs to other parameters; names the file
    """
    runs = [run for run in plan['runs'] if os.path.exists(summaryPath(folder, run))]
    rows = [rowOf(run, plan['runs'][run], readSummary(summaryPath(folder, run), plan['runs'][run]['parameters'])) for run in runs]
    return pandas.DataFrame(rows, columns=list(COLUMNS))


def readSummary(path, parameters):
    """The complete summary in the file `path`, if it is one of a run with these `parameters`.

    :raises ValueError: it holds something else; naming the file
    :raises OSError: it cannot be read, which says nothing about what it holds
    """
    try:
        summary = results.readJson(path)
        _measured(summary)
        given = summary['parameters']
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f'{path}: damaged ({type(error).__name__}: {error})') from None
    different = sorted(name for name in {*given, *parameters} if given.get(name) != parameters.get(name))
    if different:
        name = different[0]
        raise ValueError(f'{path}: belongs to other parameters, {name} = {given.get(name)!r} instead of {parameters.get(name)!r}')
    return summary


def rowOf(run, job, summary):
    """{column: value} of one run: its id, its entry in the plan, its summary."""
    parameters = job['parameters']
    return {'run': run, 'bed': job['bed'], 'seed': parameters['seed'], **{name: parameters[name] for name in GIVEN}, **_measured(summary)}


def write(table, path):
    """Write the table as CSV; numbers keep all their digits. The file takes its name when it is complete."""
    with results.Replacing(path) as file:
        table.to_csv(file, index=False, lineterminator='\n')


def _measured(summary):
    """{column: value} of what the summary holds; KeyError or ValueError where it does not hold all of it."""
    row = {column: _at(summary, keys) for column, keys in MEASURED.items()}
    missing = [column for column, value in row.items() if value is None and column not in MAY_BE_MISSING]
    if missing:
        raise ValueError(f'{".".join(MEASURED[missing[0]])} is null')
    rest = summary['bed']['atRest']
    return {**row, 'pours': len(summary['bed']['pours']), 'atRest': bool(rest['soft'] and rest['true'])}


def _at(content, keys):
    for key in keys:
        content = content[key]
    return content
