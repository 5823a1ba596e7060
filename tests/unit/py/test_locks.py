"""The locks of tools/env: who makes the same thing waits, everyone else goes on at once."""
import os
import subprocess
from contextlib import contextmanager

import pytest
from project import PROJECT

WAIT = 2    # [s] after which who has not got a lock waits for it
LIMIT = 30  # [s] of each command, so that a lock that nobody gives back is a failure


def shell(commands, cache):
    """Start bash with the functions of tools/env and a cache of its own."""
    script = f'set -e; . tools/setup/common.sh; {commands}'
    return subprocess.Popen(['timeout', str(LIMIT), 'bash', '-c', script], cwd=PROJECT, env={**os.environ, 'XDG_CACHE_HOME': str(cache)}, text=True,
                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


@contextmanager
def held(name, cache):
    """Another command holds the lock, until the end of the block."""
    other = shell(f'exec 2>&1; lock "$cache/{name}.lock"; echo held; read -r _ || true', cache)
    try:
        assert other.stdout.readline() == 'held\n'
        yield
    finally:
        other.communicate(timeout=60)


def test_anotherCopysBuildIsNotWaitedFor(tmp_path):
    with held('build-other', tmp_path), held('debian-forky', tmp_path):
        said = shell('lock "$cache/build-this.lock"; unlock; echo free', tmp_path).communicate(timeout=60)
    assert said == ('free\n', '')


def test_theSameBuildIsWaitedFor(tmp_path):
    with held('build-this', tmp_path):
        waiting = shell('lock "$cache/build-this.lock"; echo free', tmp_path)
        assert 'waiting for another command that makes the same (build-this.lock)' in waiting.stderr.readline()
        with pytest.raises(subprocess.TimeoutExpired):
            waiting.communicate(timeout=WAIT)
    assert waiting.communicate(timeout=60)[0] == 'free\n'


def test_unlockLetsTheNextOneIn(tmp_path):
    with held('debian-trixie', tmp_path):
        pass
    first = shell('lock "$cache/debian-trixie.lock"; unlock; echo unlocked; read -r _ || true', tmp_path)
    assert first.stdout.readline() == 'unlocked\n'
    assert shell('lock "$cache/debian-trixie.lock"; echo free', tmp_path).communicate(timeout=60)[0] == 'free\n'
    first.communicate(timeout=60)
