"""Study files and their plans: what is refused and how it is said, which beds and runs points share, what is written."""
import copy
import json
import os

import pytest
import yaml
from project import PROJECT

from yade.superquadric.experiments.impact.parameters import ImpactParameters
from yade.superquadric.experiments.quantities import xAxisLabel
from yade.superquadric.runs.parameters import BED
from yade.superquadric.study import plan as plans
from yade.superquadric.study import studyfile

GROUP = {'x': {'thickness': [0.01, 0.02]}, 'series': {'ball': {'shape': 'sphere'}, 'die': {'shape': 'cube'}},
         'figures': {'forces': {'kind': 'curves'}, 'peaks': {'kind': 'trend', 'y': ['peak']}},
         'findings': [{'paper': 'P falls', 'test': 'falls', 'y': 'peak'}]}
STUDY = {'title': 'Test', 'base': {'containerDiameter': 0.1}, 'seeds': [1, 2], 'groups': {'layers': GROUP}}


def changed(path, value):
    """STUDY with `value` at the place `path`, such as 'groups.layers.x'; None: without that entry."""
    study = copy.deepcopy(STUDY)
    *parents, last = path.split('.')
    place = study
    for key in parents:
        place = place[int(key) if isinstance(place, list) else key]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return study


def planOf(study, seeds=None):
    return plans.planOf(studyfile.checkedStudy(study), seeds)


@pytest.mark.parametrize('path, value, message', [
    ('title', None, 'study file: title is missing'),
    ('title', 5, r'title = 5: must be a text'),
    ('groups', None, 'study file: groups is missing'),
    ('groups', {}, r'groups = \{\}: must not be empty'),
    ('groups', [1], r'groups = \[1\]: must be a mapping'),
    ('group', {}, "study file: 'group' is unknown; possible are title, experiment, base, seeds"),
    ('seeds', [], r'seeds = \[\]: must not be empty'),
    ('seeds', 3, 'seeds = 3: must be a list'),
    ('seeds', [1, 2, 1], r'seeds = \[1, 2, 1\]: 1 is repeated'),
    ('seeds', [1, 1.5], 'seeds = 1.5: must be a whole number'),
    ('seeds', [-1], 'seeds = -1: must be a whole number of at least 0'),
    ('seeds', [True], 'seeds = True: must be a number'),
    ('base.thikness', 0.1, 'base.thikness = 0.1: there is no such parameter'),
    ('base.seed', 3, 'base.seed = 3: seeds are given by seeds'),
    ('base', 5, 'base = 5: must be a mapping'),
    ('validations', {'cylinder': True}, "validations: 'cylinder' is unknown"),
    ('validations', {'cylinderOnPlane': 'often'}, "validations.cylinderOnPlane = 'often': must be true or false"),
    ('groups.a b', GROUP, "groups = 'a b': must be made of letters"),
    ('groups.layers.colour', 'red', "groups.layers: 'colour' is unknown"),
    ('groups.layers.x', None, 'groups.layers: needs either x or variants'),
    ('groups.layers.variants', {'a': {}}, 'groups.layers: needs either x or variants'),
    ('groups.layers.x', {'thickness': [0.01], 'aspect': [1]}, 'groups.layers.x = .*: must have one name'),
    ('groups.layers.x', {'thickness': []}, r'groups.layers.x.thickness = \[\]: must not be empty'),
    ('groups.layers.x', {'thickness': 0.01}, 'groups.layers.x.thickness = 0.01: must be a list'),
    ('groups.layers.x', {'thickness': [0.01, 0.01]}, r'groups.layers.x = \[0.01, 0.01\]: 0.01 is repeated'),
    ('groups.layers.x', {'thickness': ['thin', 0.01]}, "groups.layers.x.thickness = 'thin': must be a number"),
    ('groups.layers.x', {'thickness': [0.01, 0.4]}, 'groups.layers, series .ball., thickness = 0.4: thickness = 0.4: overfull'),
    ('groups.layers.x', {'shape': ['cube', 'sphere']}, 'shape is no number; use series or variants'),
    ('groups.layers.x', {'n': [2, 3]}, 'groups.layers.series.ball: n is no parameter; vary must say'),
    ('groups.layers.x', {'seed': [2, 3]}, 'seeds are given by seeds'),
    ('groups.layers.series', {}, r'groups.layers.series = \{\}: must not be empty'),
    ('groups.layers.series', {2: {}}, 'groups.layers.series = 2: must be a text'),
    ('groups.layers.series.egg', {'shape': 'egg'}, "groups.layers, series 'egg', thickness = 0.01: shape = 'egg': must be one of"),
    ('groups.layers.series.odd', {'form': 'cube'}, "groups.layers.series.odd.form = 'cube': there is no such parameter"),
    ('groups.layers.series.odd', {'thickness': 0.1}, 'groups.layers.series.odd.thickness = 0.1: thickness takes the values of x'),
    ('groups.layers.series.odd', {'vary': ['m']}, 'groups.layers.series.odd.vary.m = None: there is no such parameter'),
    ('groups.layers.series.odd', {'vary': 'n1'}, "groups.layers.series.odd.vary = 'n1': must be a list"),
    ('groups.layers.series.odd', {'vary': []}, r'groups.layers.series.odd.vary = \[\]: must not be empty'),
    ('groups.layers.seeds', [3, 3], r'groups.layers.seeds = \[3, 3\]: 3 is repeated'),
    ('groups.layers.figures.a/b', {'kind': 'curves'}, 'groups.layers.figures.a/b: figure = .a/b.: must be made of letters'),
    ('groups.layers.figures.forces.kind', 'pie', "groups.layers.figures.forces: kind = 'pie': must be one of"),
    ('groups.layers.figures.peaks.y', ['volume'], "groups.layers.figures.peaks: y = 'volume': must be one of"),
    ('groups.layers.figures.forces.x', [0.03], 'groups.layers.figures.forces: x = 0.03: must be one of 0.01, 0.02'),
    ('groups.layers.findings.0.test', 'wins', r"groups.layers.findings\[0\]: test = 'wins': must be one of"),
    ('groups.layers.findings.0.y', 'colour', r"groups.layers.findings\[0\]: y = 'colour': must be one of"),
    ('groups.layers.findings.0.series', ['egg'], r"groups.layers.findings\[0\]: series = 'egg': must be one of ball, die"),
    ('groups.layers.findings.0.paper', None, r'groups.layers.findings\[0\]: paper = None: must be a text'),
    ('groups.layers.findings.0.hc', 0.07, r'groups.layers.findings\[0\]: hc = 0.07'),
    ('groups.layers.findings.0.y', ['peak'], r"groups.layers.findings\[0\]: y = \['peak'\]: must be one of"),
    ('groups.layers.figures.peaks.y', [['peak']], r"groups.layers.figures.peaks: y = \['peak'\]: must be one of"),
    ('groups.layers.series.odd', {'vary': [['n1']]}, r"groups.layers.series.odd.vary = \['n1'\]: must be a text"),
    ('groups.layers.x', {'thickness': [10 ** 400]}, 'groups.layers.x.thickness = 10*: must be finite'),
    ('seeds', [10 ** 400], 'seeds = 10*: must be finite'),
    ('base.speed', True, 'groups.layers, series .ball., thickness = 0.01: speed = True: must be a number'),
])
def test_badStudies(path, value, message):
    with pytest.raises(ValueError, match=message) as error:
        planOf(changed(path, value))
    assert '\n' not in str(error.value)


def test_findingsNumbersMayBeQuoted():
    """A text that is a number is one in the plan, as elsewhere: the finding is computed with it long after it was checked."""
    plan = planOf(changed('groups.layers.findings', [{'paper': 'p', 'test': 'noEffect', 'y': 'peak', 'from': '1e-2', 'margin': '0.2'}]))
    assert {key: plan['groups'][0]['findings'][0][key] for key in ('from', 'margin')} == {'from': 0.01, 'margin': 0.2}


def test_variantsHaveNoAxis():
    study = changed('groups.layers.x', None)
    study['groups']['layers']['variants'] = {'hard': {'young': 2e9}}
    with pytest.raises(ValueError, match=r'groups.layers.figures.peaks: kind = .trend.: x must be numbers'):
        planOf(study)
    study['groups']['layers'].update(figures={})
    with pytest.raises(ValueError, match=r'groups.layers.findings\[0\]: test = .falls.: x must be numbers'):
        planOf(study)


@pytest.mark.parametrize('text, message', [
    ('title: [', 'study file = .*study.yaml.: while parsing'),
    ('title: a\ntitle: b\ngroups: {}', 'study file = .*study.yaml.: title is given twice, line 1'),
    ('title: a\ngroups:\n  g: {x: {n1: [2]}, x: {n2: [2]}}', 'x is given twice, line 3'),
    ('- 1', r'study file = \[1\]: must be a mapping'), ('', 'study file = None: must be a mapping'), (b'\xff\xfe\xff', 'study.yaml')])
def test_badFiles(text, message, tmp_path):
    path = tmp_path / 'study.yaml'
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ValueError, match=message):
        studyfile.read(path)


def test_fileThatIsNotThere(tmp_path):
    with pytest.raises(ValueError, match='study file = .*none.yaml.: cannot be read .No such file'):
        studyfile.read(tmp_path / 'none.yaml')


def test_numbersWithoutAPoint(tmp_path):
    """YAML 1.1 takes 5e-3 for a text."""
    path = tmp_path / 'study.yaml'
    path.write_text(yaml.safe_dump(STUDY).replace('0.1', '1e-1'))
    assert studyfile.read(path)['base'] == {'containerDiameter': 0.1}


def test_planOfASmallStudy():
    plan = planOf(STUDY)
    assert len(plan['runs']) == len(plan['beds']) == 8
    group, = plan['groups']
    assert (group['name'], group['xName'], group['series']) == ('layers', 'thickness', ['ball', 'die'])
    assert xAxisLabel(group) == 'thickness $H$ [m]'   # as none is given
    assert [(p['series'], p['x'], p['seed']) for p in group['points']] == [
        (s, x, seed) for s in ('ball', 'die') for x in (0.01, 0.02) for seed in (1, 2)]
    for point in group['points']:
        run = plan['runs'][point['run']]
        expected = ImpactParameters.checked({'containerDiameter': 0.1, 'shape': {'ball': 'sphere', 'die': 'cube'}[point['series']],
                                             'thickness': point['x'], 'seed': point['seed']})
        assert run['parameters'] == expected.asDict()
        assert plan['beds'][run['bed']]['parameters'] == {**ImpactParameters.defaults(), **expected.part(BED)}
    assert json.loads(json.dumps(plan)) == plan


def test_idsDependOnParametersOnly():
    """Not on the place in the file, nor on the way a number is written."""
    runs = planOf(STUDY)['runs']
    other = copy.deepcopy(STUDY)
    del other['base']
    for series in other['groups']['layers']['series'].values():
        series['containerDiameter'] = '0.10'
    assert planOf(other)['runs'].keys() == runs.keys()
    assert not planOf(changed('base.friction', 0.3))['runs'].keys() & runs.keys()


def test_impactsShareABed():
    study = changed('groups.layers.x', {'speed': [2, 3, 5]})
    plan = planOf(study, seeds=[7])
    assert len(plan['runs']) == 6 and len(plan['beds']) == 2
    assert {bed['parameters']['speed'] for bed in plan['beds'].values()} == {ImpactParameters.defaults()['speed']}
    assert sorted(run['parameters']['speed'] for run in plan['runs'].values()) == [2, 2, 3, 3, 5, 5]


@pytest.mark.parametrize('one, other', [
    ({'shape': 'block'}, {'shape': 'cube'}),
    ({'shape': 'cube', 'n1': 8, 'n2': 8.0}, {'shape': 'cube'}),
    ({'shape': 'cylinder', 'n2': 8}, {'shape': 'cube'}),
    ({'shape': 'cylinder', 'n2': 8, 'aspect': 2}, {'shape': 'block', 'aspect': 2}),
    ({'shape': 'cube', 'n2': 2}, {'shape': 'cylinder'}),
    ({'shape': 'sphere', 'n1': 2, 'n2': 2}, {'shape': 'sphere'}),
    ({'shape': 'cube', 'n1': 2, 'n2': 2}, {'shape': 'ellipsoid'}),
    ({'shape': 'cylinder', 'n2': 5}, {'shape': 'cube', 'n2': 5}),
    ({'shape': 'ellipsoid', 'n1': 4, 'n2': 5, 'aspect': 3}, {'shape': 'block', 'n1': 4, 'n2': 5, 'aspect': 3})])
def test_equalParticlesAreOneBed(one, other):
    one, other = (ImpactParameters.checked(values).standard() for values in (one, other))
    assert one == other
    assert one.standard() == one == ImpactParameters.checked(one.asDict())


@pytest.mark.parametrize('one, other', [
    ({'shape': 'sphere'}, {'shape': 'ellipsoid'}),  # YADE's own, and a superquadric
    ({'shape': 'block', 'aspect': 2}, {'shape': 'cylinder', 'aspect': 2}), ({'n1': 4}, {'n2': 4})])
def test_differentParticlesAreNot(one, other):
    one, other = (ImpactParameters.checked(values).standard() for values in (one, other))
    assert one != other


def test_thePaper():
    """15, 13 and 16 points of 44; the cube, the cylinder of 2.5 cm and the block of c/a = 1 are in several figures, but poured once."""
    plan = plans.planOf(studyfile.read(PROJECT / 'scripts' / 'study' / 'paper.yaml'))
    runs = {group['name']: {p['run'] for p in group['points'] if p['seed'] == 1 and p['place'] == 0
                            and not (group['name'] == 'thickness' and p['x'] == 0.07)} for group in plan['groups']}
    assert {name: len(distinct) for name, distinct in runs.items()} == {'thickness': 15, 'sharpness': 13, 'aspect': 16, 'validation': 4}
    assert len(runs['thickness'] | runs['sharpness'] | runs['aspect']) == 44 - 2 - 2
    points = sum(len(group['points']) for group in plan['groups'])
    assert len(plan['beds']) < len(plan['runs']) < points


def test_placesOfABed():
    """The axis, as in the paper, and a ring of 1.5 diameters about it; fewer places are a part of more, so that they are shared."""
    study = {**STUDY, 'places': 3}
    plan = planOf(study)
    ring = [3 * 5e-3, -3 * 5e-3]
    for group in plan['groups']:
        assert len(group['points']) == 3 * len({(p['series'], p['x'], p['seed']) for p in group['points']})
        at = [(run['parameters']['impactorX'], run['parameters']['impactorY']) for run in (plan['runs'][p['run']] for p in group['points'][:3])]
        assert at == [(0, 0)] + [(x, 0) for x in ring]
    assert set(planOf(STUDY)['runs']) < set(plan['runs']) < set(planOf({**STUDY, 'places': 5})['runs'])
    assert set(plan['beds']) == set(planOf(STUDY)['beds'])


@pytest.mark.parametrize('places, message', [(0, 'places = 0'), (1.5, 'places = 1.5'), ('many', "places = 'many'"),
                                             ([1] * 9, r'groups.*must be one number, or one for each of')])
def test_badPlaces(places, message):
    name = next(iter(STUDY['groups']))
    with pytest.raises(ValueError, match=message):
        planOf({**STUDY, 'groups': {name: {**STUDY['groups'][name], 'places': places}}})


def test_placesMustBeInTheContainer():
    with pytest.raises(ValueError, match='impactorX = .*would meet the wall'):
        planOf({**STUDY, 'places': 2, 'base': {**STUDY.get('base', {}), 'impactorDiameter': 0.03, 'containerDiameter': 0.05}})


@pytest.mark.parametrize('name', ['paper', 'quick', 'sensitivity', 'example', 'damper'])
def test_theProjectsStudies(name):
    study = studyfile.read(PROJECT / 'scripts' / 'study' / f'{name}.yaml')
    plan = plans.planOf(study)
    assert plan['runs'] and all(point['run'] in plan['runs'] for group in plan['groups'] for point in group['points'])
    one = plans.planOf(study, ['5'])
    assert {run['parameters']['seed'] for run in one['runs'].values()} == {5}
    figures = [figure for group in plan['groups'] for figure in group['figures']]
    assert len(figures) == len(set(figures))


@pytest.mark.parametrize('seeds, message', [(['a'], "seeds = 'a'"), ([1, '1'], 'repeated'), (['1.5'], "seeds = '?1.5"), ([], 'empty')])
def test_badSeeds(seeds, message):
    with pytest.raises(ValueError, match=message):
        planOf(STUDY, seeds)


def test_writingAPlanTouchesOnlyWhatChanges(tmp_path):
    plan = planOf(STUDY)
    plans.write(plan, tmp_path)
    files = sorted(path for path in tmp_path.rglob('*') if path.is_file())
    assert len(files) == 1 + 8 + 8
    for path in files:
        os.utime(path, (1e9, 1e9))
    files[0].write_text('{')  # a damaged one is written again
    plans.write(plan, tmp_path)
    assert [path.stat().st_mtime == 1e9 for path in files] == [False] + 16 * [True]
    for run, job in plan['runs'].items():
        assert json.loads((tmp_path / 'impacts' / run / 'parameters.json').read_text()) == job['parameters']


def test_figuresOfTwoGroupsWithOneName():
    study = changed('groups.more', GROUP)
    with pytest.raises(ValueError, match='groups.more.figures.forces: groups.layers has a figure of that name'):
        planOf(study)


def test_oldNamesOfParametersAreRead():
    """In base, series, vary and x; the plan has the present ones."""
    study = changed('groups.layers.series.die', {'shape': 'cube', 'leverArms': False})
    study['groups']['layers']['x'] = {'softening': [10, 50]}
    with pytest.warns(FutureWarning, match='leverArms is called effectiveMassAtContact now'):
        plan = planOf(study)
    assert plan['groups'][0]['xName'] == 'pouringSoftening'
    assert {(run['parameters']['shape'], run['parameters']['effectiveMassAtContact'], run['parameters']['pouringSoftening'])
            for run in plan['runs'].values()} == {(shape, shape == 'sphere', value) for shape in ('sphere', 'cube') for value in (10, 50)}
    with pytest.raises(ValueError, match='base: leverArms = True: is called effectiveMassAtContact now, and that is given as well'):
        planOf(changed('base', {'leverArms': True, 'effectiveMassAtContact': True}))
