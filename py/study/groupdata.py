"""The finished runs of one group of a plan, as findings and figures want them."""
import pandas

from .quantities import allNumbers, xAxisLabel


class GroupData:
    """A group's points joined with the table of results; runs that are not finished are left out.

    name, title, xName, xLabel: of the group; series: names as planned; planned: number of points planned; runs: DataFrame,
    one row per finished point, with the columns series, x, seed and those of the table.
    """

    def __init__(self, group, table):
        points = pandas.DataFrame(group['points'], columns=['series', 'x', 'seed', 'run'])
        self.name, self.title, self.xName = group['name'], group.get('title') or group['name'], group['xName']
        self.xLabel, self.series, self.planned = xAxisLabel(group), list(group['series']), len(points)
        self.plannedValues = _ordered(points['x'])
        self.numeric = allNumbers(self.plannedValues)
        self.runs = points.merge(table.drop(columns='seed'), on='run', how='inner')

    @property
    def values(self):
        """The x of the finished runs: numbers in rising order, names in the plan's."""
        present = set(self.runs['x'])
        return [value for value in self.plannedValues if value in present]

    def rows(self, series, x):
        """The finished runs of a point, a DataFrame."""
        return self.runs[[s == series and value == x for s, value in zip(self.runs['series'], self.runs['x'])]]

    def sample(self, y, series, x):
        """Values of the quantity `y` of a point's runs, an array; runs that have none are left out."""
        return self.rows(series, x)[y].dropna().to_numpy(dtype=float)

    def samples(self, y, series, finding):
        """{x: values of `y`} of a series, for the x from `from` to `upTo` of a finding where there are any."""
        low, high = finding.get('from'), finding.get('upTo')
        inside = [x for x in self.values if (low is None or x >= low) and (high is None or x <= high)]
        samples = {x: self.sample(y, series, x) for x in inside}
        return {x: sample for x, sample in samples.items() if len(sample)}


def _ordered(column):
    values = list(dict.fromkeys(column))
    return sorted(values) if allNumbers(values) else values
