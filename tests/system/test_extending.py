"""docs/extending.md holds: the law that it writes is compiled as it stands there, loaded by YADE beside the plugin, and passes the page's own
test."""
import json
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import docblocks
import pytest
from project import LIMIT, PROJECT

BUILD = Path(os.environ['SUPERQUADRIC_BUILD'])
PAGE = PROJECT / 'docs' / 'extending.md'
NAMED = {'cpp': re.compile(r'`(pkg/[\w/]+\.[ch]pp)`'), 'python': re.compile(r'`(tests/[\w/]+\.py)`')}  # files that a block of this kind may be


def namedFiles():
    """{path: text} of the page's blocks that are files: each is the one that the text before it named last."""
    lines, found = PAGE.read_text().splitlines(), {}
    for block in docblocks.blocks(PAGE):
        names = NAMED[block.kind].findall('\n'.join(lines[:block.line])) if block.kind in NAMED else []
        if names:
            found[names[-1]] = block.text
    return found


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=LIMIT, **options)
    assert done.returncode == 0, done.stdout + done.stderr


def compilerAndFlags():
    """The words of the command that compiles YADE's adapters, without the source and what is made of it, and where it runs."""
    entries = json.loads((BUILD / 'compile_commands.json').read_text())
    entry, = (one for one in entries if one['file'].endswith('/superquadric.dir/Unity/unity_0_cxx.cxx'))
    words = shlex.split(entry['command'])
    for option in ('-o', '-c'):
        del words[words.index(option):words.index(option) + 2]
    return words, entry['directory']


@pytest.fixture(scope='module')
def extended():
    """A copy of the plugin's overlay with a library of the page's law in it, and the folder with the page's files. Paths in the build directory, so
    that the compiler's cache knows them."""
    place = BUILD / 'extending'
    shutil.rmtree(place, ignore_errors=True)
    for path, text in namedFiles().items():
        (place / path).parent.mkdir(parents=True, exist_ok=True)
        (place / path).write_text(text)
    shutil.copytree(BUILD / 'overlay', place / 'overlay', symlinks=True)
    launcher = place / 'overlay' / 'bin' / 'yade'
    launcher.write_text(launcher.read_text().replace(str(BUILD / 'overlay'), str(place / 'overlay')))
    plugin, = place.glob('overlay/lib/**/libsuperquadric.so')
    (words, directory), (source,) = compilerAndFlags(), place.glob('pkg/**/*.cpp')
    inProject = PROJECT / source.parent.relative_to(place)  # where its neighbours are
    run(*words, '-O0', '-iquote', inProject, '-c', source, '-o', source.with_suffix('.o'), cwd=directory)
    run(*words, '-shared', source.with_suffix('.o'), '-o', plugin.with_name('liblinearspring.so'), plugin, '-Wl,-rpath,$ORIGIN', cwd=directory)
    yield place, launcher
    shutil.rmtree(place)


def test_theLawOfThePagePassesItsTest(extended):
    place, launcher = extended
    test, = place.glob('tests/**/test_*.py')
    run(launcher, '-n', '-x', PROJECT / 'tests' / 'run_pytest.py', test, '-p', 'no:cacheprovider')


def test_thePageNamesItsFiles():
    """Else the test above would have nothing to run."""
    law = 'pkg/contact/Law2_ScGeom_CurvaturePhys_LinearSpring'
    assert sorted(namedFiles()) == [f'{law}.cpp', f'{law}.hpp', 'tests/physics/test_linear_spring.py']
