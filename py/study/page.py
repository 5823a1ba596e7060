"""The page of a study: figures, a table of the points, findings with their verdicts. All of it comes from plan and table."""
from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..experiments.quantities import axisLabel, counted, isNumber, plain, xText
from ..files import results
from ..statistics.samples import typicalValue
from .experiments import QUANTITIES, experimentOf
from .figures import drawFigure
from .findings import judge
from .groupdata import GroupData

if TYPE_CHECKING:
    import pandas

    from ..experiments.experiment import Experiment
    from ..typealiases import PathLike

VERSIONS = {'versionYade': 'yade', 'versionPlugin': 'yade-superquadric', 'versionPython': 'python', 'versionNumpy': 'numpy'}
METHOD = """\
Intervals in brackets are two-sided 95 % intervals from the scatter between beds (one bed per seed); a single run has no interval. Points in
figures and tables are geometric means over the beds if all values are positive (for force curves: arithmetic means). Figures have bands and bars
from three runs on. Trends are tested by Jonckheere and Terpstra's test. Differences are given with Welch's t interval of the mean logarithms, so
that changes are ratios; for points on the same beds it is Student's interval of the differences bed by bed; for a point with a single run on its
own bed, the scatter common to all points of the finding is used. "No difference" is tested against a stated margin. A finding is supported or
contradicted if its test, or that of the opposite, is significant at 5 % (two-sided); otherwise it is undecided. It cannot be proved that nothing
changes beyond some x: such a finding is supported if the 95 % interval of that x contains the stated one and ends before the largest x, so the
width of the interval matters. A finding is as strong as its weakest part. The runs of a finding are the values of beds; if a bed was hit in
several places, their mean."""


def drawStudy(plan: Mapping[str, Any], table: pandas.DataFrame, records: PathLike, output: PathLike) -> dict[str, Any]:
    """Write the figures (PNG), findings.json, and at last findings.md into the folder `output`.

    :param plan: dict as in plan.json; :param table: DataFrame, one row per finished run
    :param records: folder with a folder for each run, which holds its record
    :returns: dict as in findings.json
    :raises ValueError: two figures have the same name, a record cannot be used
    """
    _checkNames(plan)
    os.makedirs(output, exist_ok=True)
    experiment, groups = experimentOf(plan), [GroupData(group, table) for group in plan['groups']]
    content = {'title': plan['title'], 'shown': experiment.shown, **_header(experiment, plan, table),
               'findings': [judged for group, data in zip(plan['groups'], groups) for judged in _findings(group, data)],
               'groups': [_group(experiment, group, data, records, output) for group, data in zip(plan['groups'], groups)]}
    results.writeJson(os.path.join(output, 'findings.json'), _clean(content))
    with results.Replacing(os.path.join(output, 'findings.md')) as file:
        file.write('\n'.join(_page(content)) + '\n')
    return content


def _checkNames(plan: Mapping[str, Any]) -> None:
    names = [name for group in plan['groups'] for name in group.get('figures') or {}]
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f'figure = {name!r}: two groups have a figure of this name')


def _header(experiment: Experiment, plan: Mapping[str, Any], table: pandas.DataFrame) -> dict[str, Any]:
    """What all of the study's runs took, and what computed them."""
    done = table[table['run'].isin(plan['runs'])]
    return {'runs': len(done), 'plannedRuns': len(plan['runs']), 'beds': int(done['bed'].nunique()),
            'cpuHours': _cpuHours(experiment, done),
            'versions': {name: sorted(set(done[column].astype(str))) for column, name in VERSIONS.items()},
            'concerns': [*experiment.concerns(done), *_uncertified(done)]}


def _uncertified(done: pandas.DataFrame) -> list[str]:
    """A sentence on the runs with contact solutions of which nothing is proved, if there are any."""
    number = int((done['uncertified'] > 0).sum())
    return [f'{counted(number)} with contact solutions that have no certificate'] if number else []


def _cpuHours(experiment: Experiment, done: pandas.DataFrame) -> float:
    """Time of all runs and of each bed once, times the threads."""
    seconds = (done[experiment.runSeconds] * done['threads']).sum()
    if experiment.bedJobs:
        beds = done.drop_duplicates('bed')
        seconds += (beds['bedSeconds'] * beds['threads']).sum()
    return float(seconds) / 3600


def _group(experiment: Experiment, group: Mapping[str, Any], data: GroupData, records: PathLike, output: PathLike) -> dict[str, Any]:
    figures = []
    for name, spec in (group.get('figures') or {}).items():
        used = drawFigure(os.path.join(output, name + '.png'), spec, data, records, experiment)
        figures.append({'name': name, 'kind': spec['kind'], 'runs': used, 'file': f'{name}.png' if used else None})
    return {'name': data.name, 'title': data.title, 'xName': data.xName, 'runs': len(data.runs), 'plannedRuns': data.planned,
            'figures': figures, 'points': _points(data, experiment.shown)}


def _findings(group: Mapping[str, Any], data: GroupData) -> Iterator[dict[str, Any]]:
    for finding in group.get('findings') or []:
        paper = finding.get('paper') or f'{finding["test"]}: {QUANTITIES[finding["y"]].name}'
        yield {'group': data.name, **judge(finding, data), 'paper': paper}


def _points(data: GroupData, shown: Sequence[str]) -> list[dict[str, Any]]:
    """For each finished point: series, x, beds, and of each of the columns `shown` mean, low, high in SI units."""
    points = []
    for name in data.series:
        for x in data.values:
            number = data.rows(name, x)['bed'].nunique()
            if number:
                point = {'series': name, 'x': x, 'beds': number}
                for y in shown:
                    sample = data.sample(y, name, x)
                    point[y] = typicalValue(sample)._asdict() if len(sample) else None
                points.append(point)
    return points


def _page(content: Any) -> list[str]:
    """The page's lines."""
    lines = [f'# {content["title"]}', '', _headline(content), '', METHOD, '']
    lines += [f'**Mind:** {concern}.' for concern in content['concerns']] + [''] * bool(content['concerns'])
    lines += _overview(content)
    for group in content['groups']:
        lines += [f'## {group["title"]}', '', f'{group["runs"]} of {counted(group["plannedRuns"])}.', '']
        for figure in group['figures']:
            lines += _figureLines(figure)
        lines += _tableLines(group, content['shown']) + _findingLines(content, group)
    return lines


def _headline(content: Any) -> str:
    versions = ', '.join(f'{name} {" and ".join(values)}' for name, values in content['versions'].items() if values)
    return (f'{content["runs"]} of {counted(content["plannedRuns"])} on {counted(content["beds"], "bed")}; {plain(content["cpuHours"])} CPU hours'
            + (f'; {versions}.' if versions else '.'))


def _overview(content: Any) -> list[str]:
    if not content['findings']:
        return []
    titles = {group['name']: group['title'] for group in content['groups']}
    rows = [f'| {_escaped(finding["paper"])} | {_escaped(titles[finding["group"]])} | **{finding["verdict"]}** | {finding["runs"]} |'
            for finding in content['findings']]
    return ['| finding | in | verdict | runs |', '| --- | --- | --- | --- |', *rows, '']


def _figureLines(figure: Mapping[str, Any]) -> list[str]:
    if not figure['runs']:
        return [f'{figure["name"]}: no runs yet.', '']
    return [f'![{figure["name"]}]({figure["file"]})', '', f'*{figure["name"]}: {counted(figure["runs"])}.*', '']


def _tableLines(group: Mapping[str, Any], shown: Sequence[str]) -> list[str]:
    if not group['points']:
        return []
    heads = [group['xName'], 'beds'] + [axisLabel(QUANTITIES[y]).replace('$', '').replace('_', '') for y in shown]
    named = any(point['series'] for point in group['points'])
    heads = ['series'] * named + heads
    lines = ['| ' + ' | '.join(heads) + ' |', '|' + ' --- |' * len(heads)]
    for point in group['points']:
        cells = [point['series']] * named + [xText(point['x']), str(point['beds'])] + [_cell(y, point[y], y == shown[0]) for y in shown]
        lines.append('| ' + ' | '.join(map(_escaped, cells)) + ' |')
    return lines + ['']


def _cell(y: str, estimate: Any, withInterval: bool) -> str:
    if estimate is None:
        return '-'
    factor = QUANTITIES[y].factor
    mean = plain(factor * estimate['mean'])
    if not withInterval or math.isnan(estimate['low']):
        return mean
    return f'{mean} [{plain(factor * estimate["low"])}, {plain(factor * estimate["high"])}]'


def _findingLines(content: Any, group: Mapping[str, Any]) -> list[str]:
    lines = []
    for finding in content['findings']:
        if finding['group'] == group['name']:
            lines.append(f'- {finding["paper"]}: **{finding["verdict"]}** ({counted(finding["runs"])}). {finding["summary"]}'.rstrip())
            lines += [f'  - {part["name"]}: {part["text"]}' if part['name'] else f'  - {part["text"]}' for part in finding['parts']]
    return lines + [''] * bool(lines)


def _escaped(text: str) -> str:
    return text.replace('|', '\\|')


def _clean(value: Any) -> Any:
    """The same with plain numbers, and None for nan, as JSON wants it."""
    if isinstance(value, dict):
        return {key: _clean(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_clean(item) for item in value]
    if hasattr(value, 'item'):
        value = value.item()
    return None if isinstance(value, float) and not isNumber(value) else value
