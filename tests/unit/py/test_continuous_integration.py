"""GitHub, GitLab and .ci/run call the same commands, on every YADE that `make test-yades` knows."""
import re

import yaml
from project import PROJECT

MAKEFILE = (PROJECT / 'Makefile').read_text(encoding='utf-8')


def commands():
    """What `make ci`, which .ci/run starts, consists of."""
    assert (PROJECT / '.ci' / 'run').read_text(encoding='utf-8').splitlines()[-1] == 'exec make ci'
    return re.search(r'^ci: ((?:[a-z]+ ?)+)$', MAKEFILE, re.MULTILINE)[1].split()


def suites():
    return re.search(r'^test-yades:.*?for suite in ([a-z ]+);', MAKEFILE, re.MULTILINE | re.DOTALL)[1].split()


def load(file):
    return yaml.safe_load((PROJECT / file).read_text(encoding='utf-8'))


def test_github():
    jobs = load('.github/workflows/tests.yml')['jobs']
    assert [job['steps'][-1]['run'] for job in jobs.values()] == [f'make {command}' for command in commands()]
    assert jobs['lint']['container']['image'] == 'debian:trixie'
    assert jobs['test']['strategy']['matrix']['suite'] == suites()
    assert jobs['test']['container'] == 'debian:${{ matrix.suite }}'


def test_gitlab():
    jobs = {name: job for name, job in load('.gitlab-ci.yml').items() if 'script' in job}
    assert [job['script'] for job in jobs.values()] == [[f'make {command}'] for command in commands()]
    assert jobs['lint']['image'] == 'debian:trixie'
    assert jobs['test']['parallel']['matrix'] == [{'SUITE': suites()}]
    assert jobs['test']['image'] == 'debian:$SUITE'
