"""From a study file to the plan of its runs: every bed and every run on it once, whichever groups ask for them."""
from __future__ import annotations

import dataclasses
import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..files.results import writeJson
from ..runs.parameters import BED
from .experiments import EXPERIMENTS
from .studyfile import checkedSeeds

if TYPE_CHECKING:
    from ..experiments.experiment import Experiment
    from ..typealiases import PathLike

PLAN = 'plan.json'


def planOf(study: Mapping[str, Any], seeds: Sequence[int] | None = None) -> dict[str, Any]:
    """The plan of a checked `study` (see `studyfile.checkedStudy`), a dict for JSON.

    `runs` and `beds` hold complete parameters by their ids; ids are made of the parameters, so the same parameters give the same id in
    every study. `groups` hold the points of the figures, each with the run it takes its numbers from.

    :param seeds: instead of all seeds of the study
    :raises ValueError: a bad parameter, with the group, series and x where it stands
    """
    experiment = EXPERIMENTS[study['experiment']]
    plan = {'title': study['title'], 'experiment': experiment.name, 'script': experiment.script, 'folder': experiment.folder,
            'bedJobs': experiment.bedJobs,
            'validations': [picture for name, picture in experiment.validations.items() if study['validations'].get(name)],
            'runs': {}, 'beds': {}, 'groups': []}
    seeds = None if seeds is None else checkedSeeds('seeds', list(seeds))
    for group in study['groups']:
        points = [point for series in group['series'] for (x, values), places in zip(_xPoints(group, series), group['places'])
                  for point in _runsOf(plan, experiment, study['base'], group, series, x, values, places, seeds or group['seeds'])]
        plan['groups'].append({'name': group['name'], 'title': group['title'], 'xName': _xName(group), 'xLabel': group['xLabel'],
                               'series': list(group['series']), 'figures': group['figures'], 'findings': group['findings'],
                               'points': points})
    return plan


def write(plan: Mapping[str, Any], folder: PathLike) -> None:
    """Write the `plan` and the parameters of its beds and runs into the `folder`.

    A file that holds the same already is left alone: what was made from it stays up to date.
    """
    contents = {PLAN: plan}
    for kind, jobs in (('beds', plan['beds'] if plan['bedJobs'] else {}), (plan['folder'], plan['runs'])):
        contents.update({os.path.join(kind, name, 'parameters.json'): job['parameters'] for name, job in jobs.items()})
    for name, content in contents.items():
        path = os.path.join(folder, name)
        if not _holds(path, content):
            os.makedirs(os.path.dirname(path), exist_ok=True)
            writeJson(path, content)


def _holds(path: PathLike, content: Any) -> bool:
    try:
        with open(path, encoding='utf-8') as file:
            return file.read() == json.dumps(content, indent=2) + '\n'
    except (OSError, UnicodeDecodeError):
        return False


def _xName(group: Mapping[str, Any]) -> str:
    return group['x'][0] if group['variants'] is None else 'variant'


def _xPoints(group: Mapping[str, Any], series: str) -> Iterable[Any]:
    """(x, parameters that it sets) of all points of one series."""
    if group['variants'] is not None:
        return group['variants'].items()
    return [(x, dict.fromkeys(group['series'][series][1], x)) for x in group['x'][1]]


def _runsOf(plan: Mapping[str, Any], experiment: Experiment, base: Mapping[str, Any], group: Mapping[str, Any], series: str, x: float,
            values: Mapping[str, Any], number: int, seeds: Sequence[int]) -> Iterator[Any]:
    """Add the runs of one point to the plan; yield its points, one a seed and one of `number` places."""
    try:
        parameters = experiment.planned({**base, **group['base'], **group['series'][series][0], **values})
        places = [parameters.changed(place) for place in (experiment.places(parameters, number) if experiment.places else [{}])]
    except ValueError as error:
        inSeries = f'series {series!r}, ' if series else ''
        raise ValueError(f'groups.{group["name"]}, {inSeries}{_xName(group)} = {x!r}: {error}') from None
    for seed in seeds:
        for index, placed in enumerate(places):
            run = _addRun(plan, experiment, _ofSeed(placed, seed))
            yield {'series': series, 'x': x, 'seed': seed, 'place': index, 'run': run}


def _ofSeed(parameters: Any, seed: int) -> Any:
    return dataclasses.replace(parameters, seed=seed)


def _addRun(plan: Mapping[str, Any], experiment: Experiment, parameters: Any) -> str:
    """Add run and bed of the `parameters` unless they are there already; return the run's id."""
    poured, complete = parameters.part(BED), parameters.asDict()
    bed = f'{parameters.shape}-{_hash({**poured, "seed": None}, 10)}-s{parameters.seed}'
    run = f'{bed}-{_hash({name: value for name, value in complete.items() if name not in poured}, 6)}'
    particles = experiment.particleCount(parameters)
    bedCost, runCost = experiment.costs(particles)
    plan['beds'].setdefault(bed, {'parameters': {**experiment.defaults(), **poured}, 'particles': particles, 'cost': bedCost})
    plan['runs'].setdefault(run, {'bed': bed, 'parameters': complete, 'cost': runCost})
    return run


def _hash(content: Any, digits: int) -> str:
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:digits]
