"""Study files: read a YAML file and check all of it before anything is planned or run.

What a file may hold is told in docs/study.md. Messages name the place in the file, as in `groups.thickness.x = []: must not be empty`.
"""
from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .. import checks
from ..files import yamlfile
from .experiments import EXPERIMENTS
from .figures import checkFigure
from .findings import checkFinding

if TYPE_CHECKING:
    from ..experiments.experiment import Experiment
    from ..typealiases import PathLike

STUDY_KEYS = ('title', 'experiment', 'base', 'seeds', 'places', 'groups', 'validations')
GROUP_KEYS = ('title', 'base', 'x', 'variants', 'xLabel', 'series', 'seeds', 'places', 'figures', 'findings')
NAME = re.compile(r'[A-Za-z0-9][A-Za-z0-9_-]*')  # of a group: files are named after it


def read(path: PathLike) -> dict[str, Any]:
    """The checked content of the study file `path`, see `checkedStudy`.

    :raises ValueError: the file cannot be read, is no YAML, or asks for something that cannot be
    """
    return checkedStudy(yamlfile.read('study file', path))


def checkedStudy(content: Any) -> dict[str, Any]:
    """Check the content of a study file; the study with all optional entries filled in and numbers as numbers.

    :param content: dict, as read from the file
    :returns: dict with title, experiment (its name), base, seeds, validations and groups; each group with all of GROUP_KEYS (x or variants is
        None) and its name
    :raises ValueError: naming the place and what is wrong there
    """
    study = _keys('study file', content, STUDY_KEYS, ('title', 'groups'))
    experiment = EXPERIMENTS[checks.oneOf('experiment', study.get('experiment', 'impact'), tuple(EXPERIMENTS))]
    _checkPlaces(experiment, 'places', study)
    seeds, places = checkedSeeds('seeds', study.get('seeds', [1])), _place('places', study.get('places', 1))
    groups = _mapping('groups', study['groups'])
    result: dict[str, Any] = {'title': _text('title', study['title']), 'experiment': experiment.name,
              'base': _parameters(experiment, 'base', study.get('base', {})), 'seeds': seeds,
              'validations': _validations(experiment, study.get('validations', {})),
              'groups': [_group(experiment, name, group, seeds, places) for name, group in groups.items()]}
    _checkFigureNames(result['groups'])
    return result


def checkedSeeds(place: str, values: Any) -> list[int]:
    """`values` as a list of different whole numbers."""
    seeds = [checks.wholeNumber(place, _number(place, seed), 0) for seed in _list(place, values)]
    return _different(place, seeds)


def _checkPlaces(experiment: Experiment, key: str, content: Any) -> None:
    if 'places' in content and experiment.places is None:
        raise ValueError(f'{key} = {content["places"]!r}: a bed of the experiment {experiment.name} has no places')


def _place(key: str, value: Any) -> int:
    """On how many places of a bed the impactor falls."""
    return checks.wholeNumber(key, _number(key, value), 1)


def _places(key: str, value: Any, count: int) -> list[int]:
    """The same for each of `count` x, from one number or one for each."""
    if not isinstance(value, list):
        return [_place(key, value)] * count
    if len(value) != count:
        raise ValueError(f'{key} = {value!r}: must be one number, or one for each of the {count} x')
    return [_place(key, one) for one in value]


def _validations(experiment: Experiment, content: Any) -> dict[str, Any]:
    flags = _keys('validations', content, tuple(experiment.validations))
    for name, flag in flags.items():
        if not isinstance(flag, bool):
            raise ValueError(f'validations.{name} = {flag!r}: must be true or false')
    return flags


def _group(experiment: Experiment, name: str, content: Any, seeds: Sequence[int], places: int) -> dict[str, Any]:
    place = f'groups.{_name("groups", name)}'
    group = _keys(place, content, GROUP_KEYS)
    _checkPlaces(experiment, f'{place}.places', group)
    if ('x' in group) == ('variants' in group):
        raise ValueError(f'{place}: needs either x or variants')
    result: dict[str, Any] = {'name': name, 'title': _text(f'{place}.title', group.get('title', name)),
              'base': _parameters(experiment, f'{place}.base', group.get('base', {})), 'x': None, 'variants': None,
              'seeds': checkedSeeds(f'{place}.seeds', group['seeds']) if 'seeds' in group else seeds}
    if 'x' in group:
        result['x'] = xName, _ = _x(experiment, f'{place}.x', group['x'])
    else:
        xName = 'variant'
        result['variants'] = {_text(f'{place}.variants', key): _parameters(experiment, f'{place}.variants.{key}', values)
                              for key, values in _mapping(f'{place}.variants', group['variants']).items()}
    result['xLabel'] = _text(f'{place}.xLabel', group['xLabel']) if 'xLabel' in group else None
    result['places'] = _places(f'{place}.places', group.get('places', places), len(result['variants'] or result['x'][1]))
    result['series'] = _seriesOf(experiment, place, group, xName)
    shape = {'experiment': experiment, 'series': list(result['series']), 'xName': xName, 'values': list(result['variants'] or result['x'][1])}
    figures = _mapping(f'{place}.figures', group.get('figures', {}), mayBeEmpty=True)
    result['figures'] = {key: _accepted(f'{place}.figures.{key}', checkFigure, key, figure, shape) for key, figure in figures.items()}
    findings = _list(f'{place}.findings', group.get('findings', []), mayBeEmpty=True)
    result['findings'] = [_accepted(f'{place}.findings[{i}]', _checkedFinding, finding, shape) for i, finding in enumerate(findings)]
    return result


def _checkFigureNames(groups: Sequence[dict[str, Any]]) -> None:
    """All figures are files in one folder."""
    owner: dict[str, str] = {}
    for group in groups:
        for name in group['figures']:
            if owner.setdefault(name, group['name']) != group['name']:
                raise ValueError(f'groups.{group["name"]}.figures.{name}: groups.{owner[name]} has a figure of that name')


def _x(experiment: Experiment, place: str, content: Any) -> tuple[str, list[Any]]:
    """(name, values) of the entry `x`: one name and its list of numbers."""
    if len(_mapping(place, content)) != 1:
        raise ValueError(f'{place} = {content!r}: must have one name, with the list of its values')
    name, values = next(iter(content.items()))
    name, = experiment.parameters.byPresentNames({_text(place, name): None})
    if name == 'seed':
        raise ValueError(f'{place} = {content!r}: seeds are given by seeds')
    known = experiment.defaults()
    if name in known and not isinstance(known[name], (int, float, type(None))) or name == 'shape':
        raise ValueError(f'{place} = {content!r}: {name} is no number; use series or variants')
    return name, _different(place, [_number(f'{place}.{name}', value) for value in _list(f'{place}.{name}', values)])


def _seriesOf(experiment: Experiment, place: str, group: Mapping[str, Any], xName: str) -> dict[str, Any]:
    """{name: (parameters, names of the parameters that take x)} of the group's series."""
    if 'series' not in group and 'variants' not in group and xName not in experiment.defaults():
        raise ValueError(f'{place}.x: {xName} is no parameter; series that say what they vary are needed')
    content = _mapping(f'{place}.series', group.get('series', {'': {}}))
    return {_text(f'{place}.series', name, mayBeEmpty='series' not in group):
            _oneSeries(experiment, f'{place}.series.{name}', one, xName, 'x' in group) for name, one in content.items()}


def _oneSeries(experiment: Experiment, place: str, content: Any, xName: str, hasX: bool) -> tuple[dict[str, Any], list[str]]:
    one = dict(_mapping(place, content, mayBeEmpty=True))
    vary = one.pop('vary', None)
    parameters = _parameters(experiment, place, one)
    if not hasX:
        if vary is not None:
            raise ValueError(f'{place}.vary = {vary!r}: a group of variants has no x to vary')
        return parameters, []
    if vary is None:
        if xName not in experiment.defaults():
            raise ValueError(f'{place}: {xName} is no parameter; vary must say which parameters take its values')
        vary = [xName]
    names = _different(f'{place}.vary', [_text(f'{place}.vary', name) for name in _list(f'{place}.vary', vary)])
    vary = list(_parameters(experiment, f'{place}.vary', dict.fromkeys(names)))
    for name in vary:
        if name in parameters:
            raise ValueError(f'{place}.{name} = {parameters[name]!r}: {name} takes the values of x')
    return parameters, vary


def _checkedFinding(content: Any, group: Mapping[str, Any]) -> dict[str, Any]:
    """A finding that can be tested, and with the sentence to quote in the results."""
    finding = checkFinding(content, group)
    _text('paper', finding.get('paper'))
    return finding


def _accepted(place: str, check: Callable[..., dict[str, Any]], *arguments: Any) -> dict[str, Any]:
    """What `check(*arguments)` returns; its complaints with the place in front."""
    try:
        return check(*arguments)
    except ValueError as error:
        raise ValueError(f'{place}: {error}') from None


def _parameters(experiment: Experiment, place: str, content: Any) -> dict[str, Any]:
    """`content` by present names if all its keys are parameters; their values are checked together with the others', point by point."""
    content = _accepted(place, experiment.parameters.byPresentNames, _mapping(place, content, mayBeEmpty=True))
    for name, value in content.items():
        if name == 'seed':
            raise ValueError(f'{place}.seed = {value!r}: seeds are given by seeds, so that every point has the same')
        if name not in experiment.defaults():
            raise ValueError(f'{place}.{name} = {value!r}: there is no such parameter')
    return content


def _keys(place: str, content: Any, allowed: Sequence[str], needed: Sequence[str] = ()) -> dict[str, Any]:
    for key in _mapping(place, content, mayBeEmpty=not needed):
        if key not in allowed:
            raise ValueError(f'{place}: {key!r} is unknown; possible are {", ".join(allowed)}')
    for key in needed:
        if key not in content:
            raise ValueError(f'{place}: {key} is missing')
    return content


def _mapping(place: str, content: Any, mayBeEmpty: bool = False) -> dict[str, Any]:
    if not isinstance(content, dict):
        raise ValueError(f'{place} = {content!r}: must be a mapping of names to values')
    if not content and not mayBeEmpty:
        raise ValueError(f'{place} = {content!r}: must not be empty')
    return content


def _list(place: str, content: Any, mayBeEmpty: bool = False) -> list[Any]:
    if not isinstance(content, list):
        raise ValueError(f'{place} = {content!r}: must be a list')
    if not content and not mayBeEmpty:
        raise ValueError(f'{place} = {content!r}: must not be empty')
    return content


def _different(place: str, values: list[Any]) -> list[Any]:
    for value in values:
        if values.count(value) > 1:
            raise ValueError(f'{place} = {values!r}: {value!r} is repeated')
    return values


def _number(place: str, value: Any) -> float:
    """`value` as a float, or int where it is one; YAML's true and false are none."""
    number = checks.finite(place, value)
    return value if isinstance(value, int) else number


def _text(place: str, value: Any, mayBeEmpty: bool = False) -> str:
    if not isinstance(value, str) or not (value or mayBeEmpty):
        raise ValueError(f'{place} = {value!r}: must be a text')
    return value


def _name(place: str, value: Any) -> str:
    if not isinstance(value, str) or not NAME.fullmatch(value):
        raise ValueError(f'{place} = {value!r}: must be made of letters, digits, - and _, files are named after it')
    return value
