"""The version is one number: py/version.py has it, CMake (and so the package) takes it from there, the texts repeat it."""
import os
import re

import pytest
from project import PROJECT

BUILD = os.environ.get('SUPERQUADRIC_BUILD')


def only(pattern, file):
    """What the pattern's group matches first in a file of the project."""
    found = re.search(pattern, (PROJECT / file).read_text(encoding='utf-8'), re.MULTILINE)
    assert found, f'{file} has nothing like {pattern}'
    return found[1]


def test_theTextsNameTheVersion():
    version = only(r"^__version__ = '([\d.]+)'$", 'py/version.py')
    assert re.fullmatch(r'\d+\.\d+\.\d+', version)
    assert only(r'^version: (\S+)$', 'CITATION.cff') == version
    assert only(r'^## (\d\S*)', 'CHANGELOG.md') == version


def test_cmakeTakesItFromThere():
    assert only(r'^file\(STRINGS (\S+) versionLine', 'CMakeLists.txt') == 'py/version.py'
    assert only(r'^project\(\S+ VERSION (\S+)', 'CMakeLists.txt') == '${version}'
    assert only(r'^@PROJECT_NAME@ \((\S+)-@', 'cmake/package/changelog.Debian.in') == '@PROJECT_VERSION@'


@pytest.mark.skipif(BUILD is None, reason='not started through tools/env')
def test_theBuildHasIt():
    assert only(r'^CMAKE_PROJECT_VERSION:STATIC=(\S+)$', f'{BUILD}/CMakeCache.txt') == only(r"^__version__ = '([\d.]+)'$", 'py/version.py')
