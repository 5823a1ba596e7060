"""Scenes on several processes, or threads, against the same scene on one (parallelscene.py): totals at ten moments and after rank 0 has gone on
alone, and what the contacts remember.

Sums over the ranks add up in another order, and the solver starts elsewhere at a border: both are rounding, which grows in a bed. After these 400
steps it is below 1e-8 of the largest value; a contact that is missed, forgotten or counted twice shows at 1e-3 and above.
"""
import json
import os
import subprocess
from types import SimpleNamespace

import pytest
from project import LIMIT, SUPPORT

from yade.superquadric.scene import parallel

SCENE, REFUSALS = (SUPPORT / name for name in ('parallelscene.py', 'parallelrefusals.py'))
STEPS = 400
ROUNDING = 1e-8
# Open MPI: more processes than cores, as root in a container, and no network.
ENVIRONMENT = {**os.environ, 'OMPI_ALLOW_RUN_AS_ROOT': '1', 'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1', 'OMPI_MCA_btl': 'self,sm'}


def launch(ranks, threads, *arguments):
    launcher = [] if ranks == 1 else ['mpirun', '--oversubscribe', '-np', str(ranks)]
    return subprocess.run([*launcher, 'yade', '-n', '-x', f'-j{threads}', *map(str, arguments)], env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=LIMIT)


@pytest.fixture(scope='module')
def outcome(tmp_path_factory):
    """outcome(scene, ranks, division, threads=1): what rank 0 wrote; each is run once."""
    done = {}

    def run(scene, ranks, division, threads=1):
        which = scene, ranks, division, threads
        if which not in done:
            output = tmp_path_factory.mktemp('mpi') / 'outcome.json'
            process = launch(ranks, threads, SCENE, scene, division, STEPS, output)
            assert process.returncode == 0, process.stdout + process.stderr
            done[which] = json.loads(output.read_text())
        return done[which]

    return run


def largest(rows, value):
    return max(abs(component) for row in rows for component in value(row))


def assertSameTotals(rows, reference):
    """Of all processes while they ran, and of rank 0 alone afterwards, whose O.energy then is a part only."""
    assertSame(rows, reference, [lambda row: row['momentum'], lambda row: row['force']])
    names = sorted(reference[-1]['energy'])
    assertSame(rows[:-1], reference[:-1], [lambda row: [row['energy'].get(name, 0) for name in names]])


def assertSame(rows, reference, values):
    assert [row['bodies'] for row in rows] == [row['bodies'] for row in reference]
    for value in values:
        scale = largest(reference, value)
        assert scale > 0
        for row, other in zip(rows, reference, strict=True):
            assert value(row) == pytest.approx(value(other), rel=0, abs=ROUNDING * scale)


CASES = [('bed', 2, 'domains'), ('bed', 3, 'domains'), ('bed', 4, 'domains'), ('bed', 3, 'scattered'), ('yielding', 3, 'scattered'),
         ('mesh', 3, 'domains')]


@pytest.mark.parametrize('scene, ranks, division', CASES)
def test_ranksAgreeWithOneProcess(outcome, scene, ranks, division):
    one, several = outcome(scene, 1, 'domains'), outcome(scene, ranks, division)
    assert one['contacts']['number'] > 2 and one['contacts']['shearDisplacement'] > 0
    assertSameTotals(several['rows'], one['rows'])
    assert several['contacts'] == pytest.approx(one['contacts'], rel=1e-6)


@pytest.mark.parametrize('ranks', [1, 3])
def test_twoThreadsAgreeWithOne(outcome, ranks):
    one, two = outcome('bed', ranks, 'domains'), outcome('bed', ranks, 'domains', 2)
    assertSameTotals(two['rows'], one['rows'])


def test_metalsHaveYielded(outcome):
    assert outcome('yielding', 1, 'domains')['contacts']['plasticDissipation'] > 0


def test_everyParticleHasOneRank(outcome):
    for ranks in (2, 3, 4):
        held = outcome('bed', ranks, 'domains')['held']
        assert held[0] == [] and min(map(len, held[1:])) > 0
        assert sorted(sum(held, [])) == sorted(outcome('bed', 1, 'domains')['held'][0])


def test_bodiesChangeTheirRank(outcome):
    _, first, second = outcome('bed', 3, 'scattered')['held']
    dealt = sorted(first + second)[::2]  # to the first, at the start
    assert len(set(first) - set(dealt)) > 2


def test_anErrorOnRank0EndsTheRun(tmp_path):
    process = launch(3, 1, SCENE, 'clump', 'domains', STEPS, tmp_path / 'outcome.json')
    assert process.returncode != 0
    assert 'O.bodies: clumps cannot be cut into domains' in process.stdout + process.stderr


def test_whatSeveralRanksCannotDoIsRefused(tmp_path):
    """Nothing has changed then: the scene runs afterwards."""
    process = launch(3, 1, REFUSALS, 'refusals', tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    outcome = json.loads((tmp_path / 'messages.json').read_text())
    wall, engine = 'body 0: it is not dynamic and has a velocity', 'engine = RotationEngine: walls cannot move'
    late = ['Totals: must be made before the first run', 'run: not on several ranks after']
    expected = [wall, wall, engine, 'engine = TriaxialStressController: walls cannot move', 'engine = vtkRecorder:', late[0], wall, engine, late[1]]
    for messages, beginnings in zip(outcome['messages'], (expected, late, late), strict=True):
        assert [message[:len(beginning)] for message, beginning in zip(messages, beginnings, strict=True)] == beginnings
    assert outcome['steps'] == 20


def test_anErrorOnAnotherRankEndsTheRun(tmp_path):
    """Instead of leaving the others in the middle of their messages for ever."""
    process = launch(3, 1, REFUSALS, 'failing', tmp_path)
    assert process.returncode != 0 and 'rank 1 fails' in process.stdout + process.stderr
    assert not (tmp_path / 'messages.json').exists()


def test_anotherMpyIsNoticed(monkeypatch):
    """One whose splitScene does not call what is spared would silently forget contacts."""
    mpy = SimpleNamespace(NO_OUTPUT=False, unboundRemoteBodies=lambda: None, eraseRemote=lambda: None)
    mpy.splitScene = lambda: mpy.eraseRemote()
    monkeypatch.setattr(parallel, '_mpy', lambda: mpy)
    with pytest.raises(RuntimeError, match='yade.mpy of YADE .*: splitScene no longer calls unboundRemoteBodies, so'):
        parallel._split()
    assert mpy.NO_OUTPUT is False
