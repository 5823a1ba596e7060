"""The floors of the house (docs/architecture.md): no import and no include runs upward, and every arrow between two rooms is one that is meant."""
import ast
import re

import pytest
from project import PROJECT

PY, PKG = PROJECT / 'py', PROJECT / 'pkg'

GROUND = ('version', 'checks', 'renamed', 'typealiases')  # modules of py that import nothing of this package, and that all rooms may import

# From the ground up: each room of py, and the rooms that it imports beside the ground. `experiments` are the modules that all experiments share.
PY_ROOMS = {
    '__init__': (),
    'statistics': (),
    'files': (),
    'scene': (),
    'measure': ('files', 'scene'),
    'runs': ('files', 'scene'),
    'materials': ('files',),
    'mesh': ('files', 'scene', 'measure'),
    'vtk': ('files', 'scene', 'measure', 'mesh'),
    'pictures': ('files', 'measure', 'mesh', 'vtk'),
    'experiments': ('scene', 'runs'),
    'experiments/impact': ('statistics', 'files', 'scene', 'measure', 'runs', 'vtk', 'pictures', 'experiments'),
    'experiments/damper': ('statistics', 'files', 'scene', 'runs', 'materials', 'pictures', 'experiments'),
    'experiments/oedometer': ('statistics', 'files', 'scene', 'measure', 'runs', 'pictures', 'experiments'),
    'validations': ('scene', 'pictures'),
    'plasticity': ('files', 'materials', 'pictures'),
    'study': ('statistics', 'files', 'runs', 'pictures', 'experiments', 'experiments/impact', 'experiments/damper', 'experiments/oedometer'),
}
EXPERIMENTS = ('experiments/impact', 'experiments/damper', 'experiments/oedometer')  # they stand beside each other

# The same of pkg. What else is included is YADE's, Eigen's, CGAL's or the standard library's.
PKG_ROOMS = {
    'geometry': (),
    'detection': ('geometry',),
    'mechanics': ('geometry',),
    'mesh': ('geometry',),
    'support': (),
    'superquadric': ('geometry', 'detection', 'support'),
    'contact': ('mechanics', 'support', 'superquadric'),
    'loop': ('geometry', 'detection', 'support', 'superquadric', 'contact'),
    'breakage': ('geometry', 'mechanics', 'support', 'superquadric', 'contact'),
    'vibration': ('mechanics', 'support'),
    'python': ('mechanics', 'mesh', 'support', 'superquadric'),
    'view': ('geometry', 'superquadric'),
}


def roomOf(parts):
    """The room of a module of py, whose path is `parts`."""
    if parts[0] == 'experiments' and len(parts) > 1 and (PY / 'experiments' / parts[1]).is_dir():
        return '/'.join(parts[:2])
    return parts[0]


def imported(path):
    """Paths of the modules that a file of py imports from this package, wherever in it."""
    package = path.relative_to(PY).parts[:-1]
    for node in ast.walk(ast.parse(path.read_text(encoding='utf-8'))):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = (*package[:len(package) - node.level + 1], *(node.module or '').split('.'))
            base = tuple(part for part in base if part)
            for name in node.names:
                yield base if PY.joinpath(*base).with_suffix('.py').exists() else (*base, name.name)


def included(path):
    """Rooms of pkg that a file of it includes."""
    return set(re.findall(r'#include [<"]pkg/(\w+)/', path.read_text(encoding='utf-8'))) & set(PKG_ROOMS)


def pyArrows():
    """{room: rooms that it imports}"""
    arrows = {}
    for path in PY.rglob('*.py'):
        room = roomOf(path.relative_to(PY).with_suffix('').parts)
        arrows.setdefault(room, set()).update({roomOf(parts) for parts in imported(path) if parts} - {room})
    return arrows


def withoutGround(arrows):
    return {room: others - set(GROUND) for room, others in arrows.items() if room not in GROUND}


def pkgArrows():
    arrows = {folder.name: set() for folder in PKG.iterdir() if folder.is_dir()}
    for path in PKG.glob('*/*.[ch]pp'):
        arrows[path.parent.name] |= included(path) - {path.parent.name}
    return arrows


@pytest.mark.parametrize('table', [PY_ROOMS, PKG_ROOMS], ids=['py', 'pkg'])
def test_tablesAllowNoArrowUpward(table):
    rooms = list(table)
    for place, room in enumerate(rooms):
        assert set(table[room]) <= set(rooms[:place]), room


@pytest.mark.parametrize('table, arrows', [(PY_ROOMS, withoutGround(pyArrows())), (PKG_ROOMS, pkgArrows())], ids=['py', 'pkg'])
def test_arrowsAreThoseOfTheTable(table, arrows):
    assert {room: sorted(others) for room, others in arrows.items()} == {room: sorted(others) for room, others in table.items()}


def test_theGroundStandsOnNothing():
    assert [pyArrows()[module] for module in GROUND] == [set()] * len(GROUND)


def test_experimentsDoNotImportEachOther():
    for one in EXPERIMENTS:
        assert not set(EXPERIMENTS) & set(PY_ROOMS[one]), one
        assert not set(EXPERIMENTS) & (pyArrows()[one]), one


def test_mathematicsKnowsNoYade():
    """No header of YADE in geometry, detection, mechanics and mesh."""
    for room in ('geometry', 'detection', 'mechanics', 'mesh'):
        for path in (PKG / room).glob('*.[ch]pp'):
            others = re.findall(r'#include <((?:lib|core|pkg)/[^>]*)>', path.read_text(encoding='utf-8'))
            assert [name for name in others if name.split('/')[1] not in PKG_ROOMS] == [], path


def test_arrowsAreSeen():
    """The test's own eyes: an import in a function, of a module of another room, of a name in one, and of a module beside."""
    found = set(imported(PY / 'measure' / 'snapshot.py'))
    assert {('files', 'arrayfile'), ('measure', 'bodyarrays'), ('measure', 'scenearrays')} <= found
    assert ('scene', 'shapes') in set(imported(PY / 'measure' / 'bed.py'))
