"""Figures and page of a study, from synthetic runs."""
import json
import math
import os
import subprocess
import sys

import numpy
import pandas
import plainpackage
import pytest
import syntheticstudy
from matplotlib.image import imread
from project import LIMIT, PROJECT, SUPPORT
from scipy import stats

from yade.superquadric.experiments.impact.curves import meanCurve, readRecord
from yade.superquadric.experiments.impact.study import IMPACTS
from yade.superquadric.experiments.quantities import counted
from yade.superquadric.study.experiments import EXPERIMENTS, QUANTITIES
from yade.superquadric.study.figures import _differenceText, checkFigure, drawFigure
from yade.superquadric.study.groupdata import GroupData
from yade.superquadric.study.page import drawStudy

GROUP = {'experiment': IMPACTS, 'series': ['sphere', 'cube'], 'xName': 'thickness', 'values': [0.008, 0.025]}
VARIANTS = {'experiment': IMPACTS, 'series': [''], 'xName': 'variant', 'values': ['as it is', 'softer']}


def synthetic():
    thickness = syntheticstudy.group(
        'thickness', lambda s, x: (1200 if s == 'cube' else 1000) * (0.025 / x), [0.008, 0.025, 0.07], ['sphere', 'cube'], [1, 2, 3],
        figures={'curves': {'kind': 'curves'}, 'byThickness': {'kind': 'curves', 'panels': 'x', 'x': [0.008]},
                 'peak': {'kind': 'trend', 'y': ['peak', 'C0']}},
        findings=[{'paper': 'P falls with H', 'test': 'falls', 'y': 'peak'}, {'test': 'above', 'y': 'peak', 'series': ['cube', 'sphere']}])
    choices = syntheticstudy.group('choices', lambda s, x: 1000 if x == 'as it is' else 700, ['as it is', 'softer'], [''], [1, 2, 3],
                                   xName='variant', figures={'variants': {'kind': 'variants', 'y': ['peak']}})
    return syntheticstudy.study(thickness, choices)


@pytest.fixture(scope='module')
def drawn(tmp_path_factory):
    """The folder of a study that the command has drawn."""
    folder = tmp_path_factory.mktemp('study')
    syntheticstudy.write(*synthetic(), folder)
    draw(folder)
    return folder


def draw(folder, expected=0):
    done = subprocess.run([sys.executable, SUPPORT / 'plainpackage.py', PROJECT / 'scripts' / 'study' / 'draw.py', '--plan', folder / 'plan.json',
                           '--table', folder / 'results.csv', '--records', folder / 'impacts', '--output', folder / 'figures'],
                          capture_output=True, text=True, timeout=LIMIT, env=plainpackage.environment())
    assert done.returncode == expected, done.stderr
    return done


def coloured(path):
    """Size of a picture, and share of its pixels that are neither white nor grey: empty axes have none."""
    pixels = imread(path)[..., :3]
    return pixels.shape[:2], (numpy.ptp(pixels, axis=2) > 0.15).mean()


@pytest.mark.slow
def test_picturesShowSomething(drawn):
    assert sorted(os.listdir(drawn / 'figures')) == ['byThickness.png', 'curves.png', 'findings.json', 'findings.md', 'peak.png', 'variants.png']
    for name in ('byThickness', 'curves', 'peak', 'variants'):
        (height, width), share = coloured(drawn / 'figures' / f'{name}.png')
        assert width >= 800 and height >= 250 and 0.001 < share < 0.5, (name, width, height, share)


@pytest.mark.slow
def test_pageHoldsFiguresPointsAndFindings(drawn):
    page = (drawn / 'figures' / 'findings.md').read_text()
    assert page.startswith('# Synthetic\n') and '24 of 24 runs on 24 beds; 18.0 CPU hours; yade 2025.2' in page
    for name in ('byThickness', 'curves', 'peak', 'variants'):
        assert f'![{name}]({name}.png)' in page
    assert '| P falls with H | Thickness | **supported** | 18 |' in page
    assert '- above: peak force: **supported** (18 runs).' in page
    table = pandas.read_csv(drawn / 'results.csv')
    cubes = table[table['run'].str.startswith('thickness-cube-0.008-')]['peak'] / 1000
    middle, reach = numpy.log(cubes).mean(), 4.302653 * numpy.log(cubes).std() / math.sqrt(3)   # Student's t, two degrees of freedom
    low, mean, high = (f'{math.exp(value):.2f}' for value in (middle - reach, middle, middle + reach))
    assert f'| cube | 0.008 | 3 | {mean} [{low}, {high}] | 0.6' in page


@pytest.mark.slow
def test_findingsForMachines(drawn):
    content = json.loads((drawn / 'figures' / 'findings.json').read_text())
    assert (content['runs'], content['plannedRuns'], content['cpuHours']) == (24, 24, pytest.approx(18))
    first = content['findings'][0]
    assert (first['group'], first['paper'], first['verdict'], first['runs']) == ('thickness', 'P falls with H', 'supported', 18)
    assert first['parts'][0]['numbers']['change']['ratio'] == pytest.approx(0.008 / 0.07, rel=0.15)
    assert [figure['runs'] for group in content['groups'] for figure in group['figures']] == [18, 6, 18, 6]


@pytest.mark.slow
def test_sameStudySamePage(drawn):
    page, picture = ((drawn / 'figures' / name).read_bytes() for name in ('findings.md', 'peak.png'))
    draw(drawn)
    assert page == (drawn / 'figures' / 'findings.md').read_bytes() and picture == (drawn / 'figures' / 'peak.png').read_bytes()


@pytest.mark.slow
def test_unfinishedStudies(tmp_path):
    plan, table = synthetic()
    syntheticstudy.writeRecords(table, tmp_path / 'impacts')
    part = table[table['run'].str.contains('cube-0.0|cube-0.025-s1|sphere-0.008-s1')]
    content = drawStudy(plan, part, tmp_path / 'impacts', tmp_path / 'part')
    assert content['runs'] == len(part) == 10 and content['groups'][1]['figures'][0] == {
        'name': 'variants', 'kind': 'variants', 'runs': 0, 'file': None}
    assert [finding['verdict'] for finding in content['findings']] == ['undecided', 'undecided']
    assert 'variants: no runs yet.' in (tmp_path / 'part' / 'findings.md').read_text()
    content = drawStudy(plan, pandas.DataFrame(columns=table.columns), tmp_path / 'impacts', tmp_path / 'none')
    assert content['runs'] == 0 and sorted(os.listdir(tmp_path / 'none')) == ['findings.json', 'findings.md']


@pytest.mark.slow
def test_oneSeed(tmp_path):
    plan, table = synthetic()
    table = table[table['seed'] == 1]
    syntheticstudy.writeRecords(table, tmp_path / 'impacts')
    content = drawStudy(plan, table, tmp_path / 'impacts', tmp_path)
    assert all(coloured(tmp_path / figure['file'])[1] > 0.0003 for group in content['groups'] for figure in group['figures'])
    assert json.loads((tmp_path / 'findings.json').read_text())['groups'][0]['points'][0]['peak']['low'] is None


@pytest.mark.slow
def test_concernsAreTold(tmp_path):
    plan, table = synthetic()
    for group in plan['groups']:
        group['figures'] = {}
    table.loc[table.index[:2], 'over'] = False
    table.loc[table.index[0], 'atRest'] = False
    table.loc[table.index[:3], 'H'] *= [1.04, 1.02, 0.96]
    table.loc[table.index[3], ['H', 'particles']] = [1.0, 50]   # of a number of particles that was asked for
    drawStudy(plan, table, tmp_path, tmp_path)
    page = (tmp_path / 'findings.md').read_text()
    for concern in ('impacts on beds that were not at rest: 1', 'beds thicker or thinner than thicknessTolerance allows: 2',
                    'impacts that were not over when the record ended: 2'):
        assert f'**Mind:** {concern}' in page


def test_curvesStartAtTheFirstTouch(tmp_path):
    _, table = synthetic()
    table = table[:3]
    syntheticstudy.writeRecords(table, tmp_path)
    records = [readRecord(tmp_path / run / 'force.csv', 12.0) for run in table['run']]
    for (time, force), peak, duration in zip(records, table['peak'], table['duration']):
        assert time[0] == pytest.approx(-3e-4) and force.max() == pytest.approx(peak, rel=1e-3)
        assert time[force.argmax()] == pytest.approx(0.65 * duration, abs=2e-5)
    times = numpy.array([1e-3, 1.5e-3])
    values = numpy.array([numpy.interp(times, *record) for record in records])
    mean, half = meanCurve(records, times)
    assert mean == pytest.approx(values.mean(axis=0))
    assert half == pytest.approx(4.302653 * values.std(axis=0, ddof=1) / math.sqrt(3), rel=1e-5)
    assert numpy.isnan(meanCurve(records[:2], times)[1]).all() and numpy.isnan(meanCurve(records, [1.0])[0]).all()


def test_unusableRecords(tmp_path):
    path = tmp_path / 'force.csv'
    path.write_text('time,baseForce\n0,1\n')
    with pytest.raises(ValueError, match='force.csv: columns are missing: impactorForce'):
        readRecord(path, 0)
    path.write_text('time,baseForce,impactorForce\n0,1,0\n1,1,0\n')
    with pytest.raises(ValueError, match='force.csv: the impactor never touches'):
        readRecord(path, 0)


@pytest.mark.slow
def test_commandNamesWhatIsWrong(drawn, tmp_path):
    plan, table = synthetic()
    plan['groups'][1]['figures'] = {'peak': {'kind': 'variants', 'y': ['C0']}}
    syntheticstudy.write(plan, table, tmp_path)
    assert "figure = 'peak': two groups have a figure of this name" in draw(tmp_path, expected=2).stderr
    assert not os.path.exists(tmp_path / 'figures')
    (tmp_path / 'results.csv').unlink()
    assert 'results.csv' in draw(tmp_path, expected=2).stderr


@pytest.mark.parametrize('name, spec, message', [
    ('a/b', {'kind': 'curves'}, "figure = 'a/b': must be made of letters"),
    ('a', ['curves'], 'a figure needs a kind'),
    ('a', {'kind': 'pie'}, "kind = 'pie': must be one of curves, trend, variants"),
    ('a', {'kind': 'curves', 'y': ['peak']}, r"y = \['peak'\]: figures of kind curves know only"),
    ('a', {'kind': 'trend'}, 'y = None: must be a list'),
    ('a', {'kind': 'trend', 'y': 'peak'}, "y = 'peak': must be a list"),
    ('a', {'kind': 'trend', 'y': ['colour']}, "y = 'colour': must be one of peak, "),
    ('a', {'kind': 'trend', 'y': ['peak', 'peak']}, "'peak' is repeated"),
    ('a', {'kind': 'curves', 'panels': 'seed'}, "panels = 'seed': must be one of series, x"),
    ('a', {'kind': 'curves', 'x': [0.1]}, 'x = 0.1: must be one of 0.008, 0.025'),
    ('a', {'kind': 'curves', 'series': ['ball']}, "series = 'ball': must be one of sphere, cube")])
def test_badFigures(name, spec, message):
    with pytest.raises(ValueError, match=message):
        checkFigure(name, spec, GROUP)


def test_oneIsNotMany():
    assert [counted(number) for number in (0, 1, 18)] == ['0 runs', '1 run', '18 runs'] and counted(1, 'bed') == '1 bed'


@pytest.mark.parametrize('name', tuple(EXPERIMENTS))
def test_columnsAreDeclaredOnceAndMeanTheSameInAllExperiments(name):
    columns, quantities = EXPERIMENTS[name].columns(), EXPERIMENTS[name].quantities()
    assert len(columns) == len(set(columns)) and set(quantities) < set(columns)
    assert quantities == {column: QUANTITIES[column] for column in quantities}


def test_differenceToTheFirstVariantIsPaired():
    """On the same beds, which differ by 30 %: the scatter of the beds is not in the difference."""
    group, rows = syntheticstudy.group('g', lambda s, x: 1000 if x == 'as it is' else 1100, ['as it is', 'softer'], [''], [1, 2, 3],
                                       xName='variant', bedScatter=0.3, scatter=0.001)
    data = GroupData(group, syntheticstudy.study((group, rows))[1])
    first, other = (numpy.log(data.sample('peak', '', x)) for x in data.values)
    interval = stats.ttest_rel(other, first).confidence_interval(0.95)
    text = _differenceText(data, 'peak', '', 'as it is', 'softer')
    low, middle, high = (f'{100 * math.expm1(value):+.1f}' for value in (interval.low, (other - first).mean(), interval.high))
    assert text == f'{middle} % [{low}, {high}]'


def test_trendNeedsAnAxis():
    with pytest.raises(ValueError, match="kind = 'trend': x must be numbers for it, variant has"):
        checkFigure('a', {'kind': 'trend', 'y': ['peak']}, VARIANTS)
    assert checkFigure('a', {'kind': 'variants', 'y': ['peak']}, VARIANTS) == {'kind': 'variants', 'y': ['peak']}


def test_figureOfSomeX(tmp_path):
    plan, table = synthetic()
    data = GroupData(plan['groups'][0], table)
    assert drawFigure(tmp_path / 'a.png', {'kind': 'trend', 'y': ['C0'], 'x': [0.008, 0.07], 'series': ['cube']}, data, tmp_path, IMPACTS) == 6
    assert os.listdir(tmp_path) == ['a.png']
