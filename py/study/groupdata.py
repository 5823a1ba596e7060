"""The finished runs of one group of a plan, as findings and figures want them."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy
import pandas

from ..experiments.quantities import allNumbers, xAxisLabel


class GroupData:
    """A group's points joined with the table of results; beds of which not all runs of a point are finished are left out.

    name, title, xName, xLabel: of the group; series: names as planned; planned: number of points planned; runs: DataFrame,
    one row per finished point, with the columns series, x, seed and those of the table.
    """

    def __init__(self, group: Mapping[str, Any], table: pandas.DataFrame) -> None:
        points = pandas.DataFrame(group['points'], columns=['series', 'x', 'seed', 'run'])
        self.name, self.title, self.xName = group['name'], group.get('title') or group['name'], group['xName']
        self.xLabel, self.series, self.planned = xAxisLabel(group), list(group['series']), len(points)
        self.plannedValues = _ordered(points['x'])
        self.numeric = allNumbers(self.plannedValues)
        self.runs = _complete(points.merge(table.drop(columns='seed'), on='run', how='left'))

    @property
    def values(self) -> list[Any]:
        """The x of the finished runs: numbers in rising order, names in the plan's."""
        present = set(self.runs['x'])
        return [value for value in self.plannedValues if value in present]

    def rows(self, series: str, x: Any) -> pandas.DataFrame:
        """The finished runs of a point, a DataFrame."""
        return self.runs[numpy.array([s == series and value == x for s, value in zip(self.runs['series'], self.runs['x'])], dtype=bool)]

    def sample(self, y: str, series: str, x: Any) -> pandas.Series:
        """Values of the quantity `y` of a point, a Series over its beds: means over the places that were hit on a bed, for these
        are no more independent than the bed is. Runs that have none are left out."""
        rows = self.rows(series, x)
        return rows[y].astype(float).groupby(rows['bed'], sort=False).mean().dropna()

    def samples(self, y: str, series: str, finding: Mapping[str, Any]) -> dict[Any, pandas.Series]:
        """{x: values of `y`} of a series, for the x from `from` to `upTo` of a finding where there are any."""
        samples = {x: self.sample(y, series, x) for x in self.plannedIn(finding)}
        return {x: sample for x, sample in samples.items() if len(sample)}

    def plannedIn(self, finding: Mapping[str, Any]) -> list[Any]:
        """The planned x from `from` to `upTo` of a finding."""
        low, high = finding.get('from'), finding.get('upTo')
        return [x for x in self.plannedValues if (low is None or x >= low) and (high is None or x <= high)]


def _complete(runs: pandas.DataFrame) -> pandas.DataFrame:
    """Those of the planned `runs` whose bed has all its runs of the point: means over some of them only would not compare."""
    finished = runs['bed'].notna().groupby([runs['series'], runs['x'], runs['seed']]).transform('all')
    return runs[finished.astype(bool)].reset_index(drop=True)


def _ordered(column: pandas.Series) -> list[Any]:
    values = list(dict.fromkeys(column))
    return sorted(values) if allNumbers(values) else values
