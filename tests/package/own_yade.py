"""A YADE of the user's own, built from source: the installed one disguised as such, in another place, under another name, with plain `lib`."""
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from yade import config

project = Path(__file__).resolve().parents[2]
cache = Path(os.environ['SUPERQUADRIC_BUILD'], 'CMakeCache.txt').read_text(encoding='utf-8')
SCRIPT = """
from yade import config, superquadric
print(config.prefix, config.suffix, Superquadric(extents=(1, 2, 3)).volume(), superquadric.__name__)
"""


def cached(variable):
    """A variable of this build's CMake."""
    return re.search(rf'^{variable}:\w+=(.*)$', cache, re.M).group(1)


@pytest.fixture(scope='module')
def ownYade(tmp_path_factory):
    """PREFIX/bin/yade-own, as YADE's `make install` lays it out with -DCMAKE_INSTALL_PREFIX=PREFIX -DSUFFIX=-own."""
    prefix = tmp_path_factory.mktemp('own yade')
    installed = Path(cached('YADE_EXECUTABLE'))
    libDir = Path(config.libDir, 'libyade.so').resolve().parent
    shutil.copytree(libDir, prefix / 'lib' / 'yade-own', ignore=shutil.ignore_patterns('libsuperquadric.so', 'superquadric'))
    (prefix / 'bin').mkdir()
    for batch in ('', '-batch'):
        moved(Path(f'{installed}{batch}'), prefix / 'bin' / f'yade-own{batch}', libDir, prefix)
    moved(libDir / 'py' / 'yade' / 'config.py', prefix / 'lib' / 'yade-own' / 'py' / 'yade' / 'config.py', libDir, prefix)
    return prefix / 'bin' / 'yade-own'


def moved(source, target, libDir, prefix):
    """Write a file of YADE's as its build would have for the other place."""
    text = source.read_text(encoding='utf-8')
    text = text.replace(str(libDir), f'{prefix}/lib/yade-own').replace("'/usr'", f"'{prefix}'")
    text = re.sub(r"(libPATH ?= ?)'lib/[^']*'", r"\1'lib'", text)
    target.write_text(text.replace(config.suffix, '-own'), encoding='utf-8')
    target.chmod(source.stat().st_mode)


@pytest.fixture(scope='module')
def cacheHome(tmp_path_factory):
    """An empty cache but for the compiled files: those of this build fit, for a YADE of the same source."""
    home = tmp_path_factory.mktemp('cache')
    (home / 'yade-superquadric').mkdir()
    (home / 'yade-superquadric' / 'ccache').symlink_to(Path(os.environ['SUPERQUADRIC_BUILD']).parent / 'ccache')
    return home


def run(cacheHome, *command, **variables):
    """Through tools/env, as from a user's shell outside of it."""
    shell = {name: value for name, value in os.environ.items() if not name.startswith(('SUPERQUADRIC_', 'YADE_'))}
    shell['PYTHONPATH'] = ''
    shell['XDG_CACHE_HOME'] = str(cacheHome)
    shell['PATH'] = ':'.join(place for place in shell['PATH'].split(':') if 'overlay' not in place)
    return subprocess.run([project / 'tools' / 'env', *command], env={**shell, **variables}, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, check=False)


def test_thePluginIsBuiltForIt(ownYade, cacheHome, tmp_path):
    script = tmp_path / 'script.py'
    script.write_text(SCRIPT, encoding='utf-8')
    for name in ('yade', 'yade-own'):
        result = run(cacheHome, name, '-n', '-x', script, YADE_EXECUTABLE=str(ownYade), YADE_SOURCE=cached('YADE_SOURCE'))
        assert result.returncode == 0, result.stderr
        assert re.search(r'/overlay -own [\d.]+ yade.superquadric$', result.stdout, re.M), result.stdout


def test_whatIsMissingIsSaid(ownYade, cacheHome, tmp_path):
    for variables, message in (({'YADE_EXECUTABLE': '/no/yade', 'YADE_SOURCE': '/'}, 'YADE_EXECUTABLE=/no/yade is not a program'),
                               ({'YADE_EXECUTABLE': str(ownYade)}, 'YADE_EXECUTABLE needs YADE_SOURCE'),
                               ({'YADE_EXECUTABLE': str(ownYade), 'YADE_SOURCE': str(tmp_path)}, 'is not a YADE source tree')):
        result = run(cacheHome, 'true', **variables)
        assert result.returncode != 0 and message in result.stderr, result.stderr
