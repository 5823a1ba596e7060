"""From a study file to the plan of its runs: every bed and every impact once, whichever groups ask for them."""
import hashlib
import json
import math
import os

from ..bodies import BLOCK_EXPONENT, particleShape
from ..parameters import bedPart, checked, defaults, particleCount
from ..results import writeJson
from .studyfile import checkedSeeds

PLAN = 'plan.json'
RING = 3.0  # distance of the other places from the first, over the particles' radius: other particles take the blow there
# Exponents that a shape has by its name, and the names: with aspect 1, and with any other.
NAMED = {(2.0, 2.0): ('ellipsoid', 'ellipsoid'), (BLOCK_EXPONENT, 2.0): ('cylinder', 'cylinder'), (BLOCK_EXPONENT, BLOCK_EXPONENT): ('cube', 'block')}


def planOf(study, seeds=None):
    """The plan of a checked `study` (see `studyfile.checkedStudy`), a dict for JSON.

    `runs` and `beds` hold complete parameters by their ids; ids are made of the parameters, so the same parameters give the same id in
    every study. `groups` hold the points of the figures, each with the run it takes its numbers from.

    :param seeds: instead of all seeds of the study
    :raises ValueError: a bad parameter, with the group, series and x where it stands
    """
    plan = {'title': study['title'], 'validations': study['validations'], 'runs': {}, 'beds': {}, 'groups': []}
    seeds = None if seeds is None else checkedSeeds('seeds', list(seeds))
    for group in study['groups']:
        points = [point for series in group['series'] for (x, values), places in zip(_xPoints(group, series), group['places'])
                  for point in _runsOf(plan, study, group, series, x, values, places, seeds or group['seeds'])]
        plan['groups'].append({'name': group['name'], 'title': group['title'], 'xName': _xName(group), 'xLabel': group['xLabel'],
                               'series': list(group['series']), 'figures': group['figures'], 'findings': group['findings'],
                               'points': points})
    return plan


def write(plan, folder):
    """Write the `plan` and the parameters of its beds and runs into the `folder`.

    A file that holds the same already is left alone: what was made from it stays up to date.
    """
    contents = {PLAN: plan}
    for kind, jobs in (('beds', plan['beds']), ('impacts', plan['runs'])):
        contents.update({os.path.join(kind, name, 'parameters.json'): job['parameters'] for name, job in jobs.items()})
    for name, content in contents.items():
        path = os.path.join(folder, name)
        if not _holds(path, content):
            os.makedirs(os.path.dirname(path), exist_ok=True)
            writeJson(path, content)


def _holds(path, content):
    try:
        with open(path, encoding='utf-8') as file:
            return file.read() == json.dumps(content, indent=2) + '\n'
    except (OSError, UnicodeDecodeError):
        return False


def _xName(group):
    return group['x'][0] if group['variants'] is None else 'variant'


def _xPoints(group, series):
    """(x, parameters that it sets) of all points of one series."""
    if group['variants'] is not None:
        return group['variants'].items()
    return [(x, {name: x for name in group['series'][series][1]}) for x in group['x'][1]]


def _runsOf(plan, study, group, series, x, values, number, seeds):
    """Add the runs of one point to the plan; yield its points, one a seed and one of `number` places."""
    try:
        parameters = standard(checked({**study['base'], **group['base'], **group['series'][series][0], **values}))
        places = placesOf(parameters, number)
        for place in places:
            checked({**parameters, **place})
    except ValueError as error:
        place = f'series {series!r}, ' if series else ''
        raise ValueError(f'groups.{group["name"]}, {place}{_xName(group)} = {x!r}: {error}') from None
    for seed in seeds:
        for index, place in enumerate(places):
            yield {'series': series, 'x': x, 'seed': seed, 'place': index, 'run': _addRun(plan, {**parameters, **place, 'seed': seed})}


def placesOf(parameters, number):
    """The places on the bed where the impactor falls: the one that the `parameters` say, the others on a ring about it.

    What a bed does to a blow depends on the few particles that it meets, and an impact costs a tenth of what its bed does.
    """
    x, y, ring = parameters['impactorX'], parameters['impactorY'], RING * parameters['radius']
    angles = [2 * math.pi * k / (number - 1) for k in range(number - 1)]
    return [{}] + [{'impactorX': round(x + ring * math.cos(a), 9), 'impactorY': round(y + ring * math.sin(a), 9)} for a in angles]


def _addRun(plan, parameters):
    """Add run and bed of the `parameters` unless they are there already; return the run's id."""
    poured = bedPart(parameters)
    bed = f'{parameters["shape"]}-{_hash({**poured, "seed": None}, 10)}-s{parameters["seed"]}'
    run = f'{bed}-{_hash({name: value for name, value in parameters.items() if name not in poured}, 6)}'
    plan['beds'].setdefault(bed, {'parameters': {**defaults(), **poured}, 'particles': particleCount(parameters)})
    plan['runs'].setdefault(run, {'bed': bed, 'parameters': parameters})
    return run


def standard(parameters):
    """The complete `parameters` with the shape in its one standard form, so that equal particles are the same bed.

    A shape is its exponents and its aspect: a cylinder with n2 = 8 is a cube or block, a cube with n1 = n2 = 2 an ellipsoid. Only
    the sphere stays one by name, as it is YADE's own.
    """
    shape = particleShape(parameters['shape'], parameters['radius'], parameters['aspect'], parameters['n1'], parameters['n2'])
    if shape.asSphere:
        return {**parameters, 'n1': None, 'n2': None}
    exponents, regular = (shape.n1, shape.n2), parameters['aspect'] == 1
    if exponents in NAMED:
        return {**parameters, 'shape': NAMED[exponents][0 if regular else 1], 'n1': None, 'n2': None}
    return {**parameters, 'shape': 'cube' if regular else 'block', 'n1': shape.n1, 'n2': shape.n2}


def _hash(content, digits):
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:digits]
