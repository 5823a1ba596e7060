"""Parameter lists, study files and material files with anything in them: complete and right, or a ValueError."""
import copy
import json
import math
import os
import tempfile

import yaml
from fuzzing import anything, fuzz, number, refused
from hypothesis import strategies as st
from project import PROJECT

from yade.superquadric.experiments.damper.parameters import DamperParameters
from yade.superquadric.experiments.impact.parameters import ImpactParameters
from yade.superquadric.experiments.oedometer.parameters import OedometerParameters
from yade.superquadric.files import results, yamlfile
from yade.superquadric.materials import materialfile
from yade.superquadric.materials.shipped import FOLDER
from yade.superquadric.runs.parameters import fromFile
from yade.superquadric.study import plan as plans
from yade.superquadric.study import studyfile

KINDS = {'impact': ImpactParameters, 'damper': DamperParameters, 'oedometer': OedometerParameters}
plain = st.recursive(st.one_of(st.none(), st.booleans(), number, st.integers(), st.text(max_size=5),
                               st.sampled_from(('cube', 'sphere', 'peak', 'falls', 'trend'))),
                     lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=4), inner, max_size=3)), max_leaves=5)


def name(which):
    return st.sampled_from([*KINDS[which].declarations(), *KINDS[which].RENAMED])


values = st.sampled_from(tuple(KINDS)).flatmap(
    lambda which: st.tuples(st.just(which), st.dictionaries(name(which), st.one_of(anything, number), max_size=3)))


@fuzz(weight=10, which=values)
def test_parameters(which):
    """Accepted ones are numbers, stay as they are when they are checked again, and survive JSON; from a command line they are texts."""
    kind, given = KINDS[which[0]], which[1]
    parameters, no = refused(lambda: kind.checked(given))
    if no:
        assert isinstance(parameters, ValueError), f'{parameters!r}: the user is told nothing'
        return
    result = parameters.asDict()
    assert set(result) == set(kind.defaults())
    assert all(math.isfinite(value) for value in result.values() if isinstance(value, float))
    assert kind.checked(result) == kind.read(result) == parameters and result == json.loads(json.dumps(result))
    texts = {key: str(value) for key, value in result.items() if value is not None}
    assert kind.checked(texts) == parameters


@fuzz(weight=2, text=st.one_of(st.binary(max_size=60), plain.map(lambda value: json.dumps(value).encode()),
                                st.sampled_from((b'[' * 3000, b'{"a":' * 2000, b'1' * 5000))))
def test_parameterFiles(text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'parameters.json')
        with open(path, 'wb') as file:
            file.write(text)
        content, no = refused(lambda: fromFile(path), path)
        assert no or isinstance(content, dict)
        refused(lambda: results.readCsv(path), path)
        refused(lambda: yamlfile.read('study file', path), path)
        refused(lambda: studyfile.read(path))
        refused(lambda: materialfile.read(path), path)


def places(content, path=()):
    """The paths of all entries of nested dicts and lists."""
    inner = content.items() if isinstance(content, dict) else enumerate(content) if isinstance(content, list) else ()
    for key, value in inner:
        yield (*path, key)
        yield from places(value, (*path, key))


def changed(content, path, value, action):
    """A copy with the entry at `path` replaced, removed, or with another one beside it."""
    result = copy.deepcopy(content)
    place = result
    for key in path[:-1]:
        place = place[key]
    if action == 'remove':
        del place[path[-1]]
    elif action == 'add' and isinstance(place, dict):
        place[str(value)] = value
    else:
        place[path[-1]] = value
    return result


def shippedContents(folder, names=None):
    for file in sorted(os.listdir(folder)):
        if file.endswith('.yaml') and (names is None or file in names):
            yield yamlfile.read('file', os.path.join(folder, file))


STUDIES = list(shippedContents(PROJECT / 'scripts' / 'study', ('example.yaml', 'quick.yaml', 'damper.yaml')))
MATERIALS = list(shippedContents(FOLDER))
ACTIONS = st.sampled_from(('replace', 'replace', 'remove', 'add'))


def change(contents):
    return st.sampled_from(contents).flatmap(lambda content: st.tuples(st.just(content), st.sampled_from(list(places(content)))))


@fuzz(weight=2, at=change(STUDIES), value=plain, action=ACTIONS)
def test_studyFiles(at, value, action):
    study, no = refused(lambda: studyfile.checkedStudy(changed(*at, value, action)))
    if not no:
        plan, no = refused(lambda: plans.planOf(study))
        assert no or json.loads(json.dumps(plan)) == plan
    assert not no or isinstance(study if isinstance(study, Exception) else plan, ValueError)


@fuzz(weight=2, at=change(MATERIALS), value=plain, action=ACTIONS)
def test_materialFiles(at, value, action):
    content, no = refused(lambda: materialfile.checked(changed(*at, value, action)))
    assert not no or isinstance(content, ValueError)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'material.yaml')
        with open(path, 'w', encoding='utf-8') as file:
            yaml.safe_dump(changed(*at, value, action), file)
        assert refused(lambda: materialfile.read(path), path)[1] == no
