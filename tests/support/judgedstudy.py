"""Findings judged on a synthetic study."""
import syntheticstudy

from yade.superquadric.experiments.impact.study import IMPACTS
from yade.superquadric.study.findings import checkFinding, judge
from yade.superquadric.study.groupdata import GroupData

SEEDS = (1, 2, 3)


def judged(finding, truth, x=(1, 2, 3, 4), series=('a',), seeds=SEEDS, missing=(), **options):
    """The verdict on a finding about peaks whose mean is truth(series, x); runs of the x or (series, x) in `missing` are not there."""
    group, rows = syntheticstudy.group('g', truth, x, series, seeds, **options)
    gone = {point['run'] for point in group['points'] if point['x'] in missing or (point['series'], point['x']) in missing}
    _, table = syntheticstudy.study((group, [row for row in rows if row['run'] not in gone]))
    finding = {'y': 'peak', **finding}
    checkFinding(finding, {'experiment': IMPACTS, 'series': list(series), 'xName': group['xName'], 'values': list(x)})
    return judge(finding, GroupData(group, table))


def verdicts(repetitions, *arguments, **options):
    found = [judged(*arguments, seed=seed, **options)['verdict'] for seed in range(repetitions)]
    return {verdict: found.count(verdict) / repetitions for verdict in ('supported', 'undecided', 'contradicted')}
