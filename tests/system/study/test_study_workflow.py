"""scripts/study.py and its Snakefile: what is stopped or killed goes on, nothing finished is done again, failures stay apart.

Most of it with a stand-in for YADE (fakeyade.py), whose jobs wait or fail on demand.
"""
import json
import os
import signal
import subprocess
import sys
import time

import pytest
import yade
import yaml
from project import LIMIT, PROJECT, SUPPORT

from yade.superquadric.study.plan import planOf
from yade.superquadric.study.studyfile import checkedStudy

SCRIPT = PROJECT / 'scripts' / 'study.py'
STUDY = {'title': 'Test', 'seeds': [1, 2], 'groups': {'layers': {
    'x': {'speed': [2, 3]}, 'base': {'thickness': 0.01}, 'series': {'die': {'shape': 'cube'}}}}}


class Study:
    """A study in the folder `path`, run by study.py with the stand-in for YADE."""

    def __init__(self, path, content=STUDY):
        self.path, self.output, self.orders, self.bin = path, path / 'out', path / 'orders', path / 'bin'
        self.orders.mkdir()
        self.bin.mkdir()
        (self.bin / 'yade').symlink_to(SUPPORT / 'fakeyade.py')
        (path / 'study.yaml').write_text(yaml.safe_dump(content))
        self.environment = {**os.environ, 'PATH': f'{self.bin}:{os.environ["PATH"]}', 'FAKE_ORDERS': str(self.orders),
                            'SUPERQUADRIC_BUILD': os.environ.get('SUPERQUADRIC_BUILD', 'any'),
                            'PYTHONPATH': os.path.dirname(os.path.dirname(os.path.abspath(yade.__file__)))}

    def start(self, *options):
        command = [sys.executable, SCRIPT, str(self.path / 'study.yaml'), '--output', str(self.output), *options]
        return subprocess.Popen(command, env=self.environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, *options):
        """(exit code, stdout, stderr)"""
        process = self.start(*(options or ('--cores', '2')))
        out, error = process.communicate(timeout=LIMIT)
        return process.returncode, out, error

    def order(self, kind, name):
        (self.orders / f'{kind}.{name}').touch()

    def release(self):
        for path in self.orders.glob('hold.*'):
            path.unlink()

    def plan(self):
        return json.loads((self.output / 'plan.json').read_text())

    def results(self):
        """{path: time of its last change} of all finished beds and impacts."""
        return {path: path.stat().st_mtime_ns for name in ('beds/*/bed.json', 'impacts/*/summary.json') for path in self.output.glob(name)}


def waitFor(condition, what):
    """Until the time is over in any case, which is long: Snakemake starts slowly on a busy machine."""
    end = time.monotonic() + LIMIT
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.05)
    raise AssertionError(f'{what} did not happen within {LIMIT:g} s')


def alive(pid):
    """Whether the process is there and no zombie."""
    try:
        with open(f'/proc/{pid}/stat', encoding='utf-8') as file:
            return file.read().rsplit(')', 1)[1].split()[0] != 'Z'
    except FileNotFoundError:
        return False


def childOf(pid):
    with open(f'/proc/{pid}/task/{pid}/children', encoding='utf-8') as file:
        return int(file.read().split()[0])


def killed(study, victims):
    """Start the study with one job at a time, wait until it is held up in a job, kill -9 the `victims` of (study.py, snakemake, job)."""
    process = study.start('--cores', '1')
    held = next(iter(study.orders.glob('hold.*'))).name.removeprefix('hold.')
    begun = study.orders / f'begun.{held}'
    begun.unlink(missing_ok=True)
    waitFor(begun.exists, f'job {held}')
    pids = [process.pid, childOf(process.pid), int(begun.read_text())]
    for pid, isVictim in zip(pids, victims):
        if isVictim:
            os.kill(pid, signal.SIGKILL)
    return process, pids


def test_killedAndStoppedStudiesGoOn(tmp_path):
    """Whatever ends a study: finished jobs are not redone, and in the end its table is that of a study that was never disturbed."""
    for name in ('reference', 'disturbed'):
        (tmp_path / name).mkdir()
    reference, study = Study(tmp_path / 'reference'), Study(tmp_path / 'disturbed')
    code, out, error = reference.run()
    assert code == 0, error
    assert '4 impacts on 2 beds; 0 impacts are finished' in out and (reference.output / 'figures' / 'findings.md').exists()
    runs = list(reference.plan()['runs'])
    study.order('hold', runs[3])
    finished = killJob(study, runs[3])
    killParents(study, runs[3], finished)
    interrupt(study, finished)
    goOnWithDamage(study, runs, finished)
    assert (study.output / 'results.csv').read_bytes() == (reference.output / 'results.csv').read_bytes()
    repeat(study, runs)


def killJob(study, run):
    """The others are finished, the table holds them. Returns their results."""
    process, _ = killed(study, (False, False, True))
    error = process.communicate(timeout=LIMIT)[1]
    assert process.returncode == 1
    assert 'not all was made: 3 of 4 impacts are finished and in the table' in error and f'logs/impacts/{run}.log' in error
    assert len((study.output / 'results.csv').read_text().splitlines()) == 1 + 3
    assert len(study.results()) == 2 + 3
    return study.results()


def killParents(study, run, finished):
    """Kill study.py, which takes snakemake with it, then snakemake alone: the job leaves its checkpoint."""
    for victims in ((True, False, False), (False, True, False)):
        process, pids = killed(study, victims)
        process.communicate(timeout=LIMIT)
        waitFor(lambda: not any(map(alive, pids)), 'end of the job')
        assert (study.output / 'impacts' / run / 'checkpoint.json').exists()
        assert study.results() == finished


def interrupt(study, finished):
    """Ctrl-C; before it a second study.py is refused."""
    process, pids = killed(study, (False, False, False))
    code, _, error = study.run()
    assert code == 2 and error.splitlines()[-1].endswith('another study.py is at work there')
    process.send_signal(signal.SIGINT)
    error = process.communicate(timeout=LIMIT)[1]
    assert process.returncode == 130 and '3 of 4 impacts are finished. The same command goes on.' in error
    assert not any(map(alive, pids)) and study.results() == finished


def goOnWithDamage(study, runs, finished):
    """A damaged summary, and a bed whose scene is damaged, are named, do not count and are made again; the interrupted job is taken up."""
    bed = study.output / 'beds' / study.plan()['runs'][runs[0]]['bed']
    damaged = study.output / 'impacts' / runs[0] / 'summary.json'
    whole = damaged.read_text()
    damaged.write_text(whole[:len(whole) // 2])
    (bed / 'bed.yade.gz').write_text('half')
    study.release()
    code, _, error = study.run()
    assert code == 0 and f'{damaged}: damaged' in error and f'{bed}: bed.yade.gz is damaged' in error and 'the bed is made again' in error
    assert (study.orders / f'done.{runs[3]}').read_text() == 'taken up'
    assert damaged.read_text() == whole and (bed / 'bed.yade.gz').read_text() != 'half'
    assert {path: time for path, time in finished.items() if path not in (damaged, bed / 'bed.json')}.items() <= study.results().items()


def repeat(study, runs):
    """Nothing is left to do, whatever the dates say."""
    table = study.output / 'results.csv'
    before = table.stat().st_mtime_ns
    os.utime(study.output / 'beds' / study.plan()['runs'][runs[0]]['bed'] / 'bed.json')
    for path in study.orders.iterdir():
        path.unlink()
    assert study.run()[0] == 0
    assert not list(study.orders.iterdir()) and len(study.results()) == 2 + 4
    assert table.stat().st_mtime_ns == before


def test_failedBedAndMoreSeeds(tmp_path):
    """What depends on a bed that failed is missing, and tried again; a study that grows keeps what it has."""
    study = Study(tmp_path)
    plan = planOf(checkedStudy(STUDY))
    bed = next(iter(plan['beds']))
    study.order('fail', bed)
    code, out, error = study.run()
    assert code == 1 and f'logs/beds/{bed}.log: impact.py: thickness = 1: not today' in error
    assert 'not all was made: 2 of 4 impacts are finished and in the table' in error
    rows = (study.output / 'results.csv').read_text().splitlines()[1:]
    assert sorted(row.split(',')[0] for row in rows) == sorted(run for run in plan['runs'] if plan['runs'][run]['bed'] != bed)
    finished = study.results()
    (study.orders / f'fail.{bed}').unlink()
    code, out, error = study.run('--seeds', '1', '2', '3', '--cores', '2')
    assert code == 0, error
    assert len((study.output / 'results.csv').read_text().splitlines()) == 1 + 6
    assert finished.items() <= study.results().items()


SBATCH = """#!/bin/sh
# A Slurm of one node: the job runs at once, its state is a file.
for script; do :; done
echo "$@" >> "$FAKE_ORDERS/sbatch"
id=$(wc -l < "$FAKE_ORDERS/sbatch")
echo RUNNING > "$FAKE_ORDERS/state.$id"
(sh "$script" > /dev/null 2>&1 && echo COMPLETED > "$FAKE_ORDERS/state.$id" || echo FAILED > "$FAKE_ORDERS/state.$id") > /dev/null 2>&1 &
echo "$id"
"""
SQUEUE = """#!/bin/sh
for word; do case $word in --jobs=*) cat "$FAKE_ORDERS/state.${word#--jobs=}" ;; esac; done
"""


def test_slurmProfile(tmp_path):
    study = Study(tmp_path)
    profile = ('--profile', PROJECT / 'scripts' / 'study' / 'slurm', '--seeds', '1')
    assert study.run(*profile, '--dry-run')[0] == 0 and not study.results()
    for name, text in (('sbatch', SBATCH), ('squeue', SQUEUE)):
        (study.bin / name).write_text(text)
        (study.bin / name).chmod(0o755)
    study.environment['CI'] = 'true'  # snakemake then does not wait for ten seconds between its looks at the jobs
    code, out, error = study.run(*profile)
    assert code == 0, error
    assert len(study.results()) == 1 + 2
    submitted = (study.orders / 'sbatch').read_text().splitlines()
    assert len(submitted) == 3 and all('--cpus-per-task=1 --mem=' in line and '--time=' in line for line in submitted)


@pytest.mark.parametrize('options, message', [
    (('--cores', '0'), "cores = '0': must be a whole number of at least 1"),
    (('--profile', 'nowhere'), "profile = 'nowhere': there is no config.yaml in that folder")])
def test_badInputIsOneLine(tmp_path, options, message):
    study = Study(tmp_path)
    code, out, error = study.run(*options)
    assert code == 2 and error.splitlines()[-1] == f'study.py: {message}' and 'Traceback' not in error
    assert not study.output.exists()


def test_badStudyFile(tmp_path):
    study = Study(tmp_path, {**STUDY, 'colour': 'red'})
    code, out, error = study.run()
    assert code == 2 and error.splitlines()[-1].startswith("study.py: study file: 'colour' is unknown") and not study.output.exists()


def test_resultThatCannotBeReadIsKept(tmp_path):
    """Not every file that cannot be read just now is damaged: a folder in its place stands for a disk that does not answer."""
    study = Study(tmp_path)
    run = next(iter(planOf(checkedStudy(STUDY))['runs']))
    summary = study.output / 'impacts' / run / 'summary.json'
    summary.mkdir(parents=True)
    code, out, error = study.run()
    assert code == 2 and error.splitlines()[-1].startswith('study.py: output = ') and str(summary) in error and 'Traceback' not in error
    assert summary.exists()


def test_outputThatIsAFile(tmp_path):
    study = Study(tmp_path)
    study.output.write_text('')
    code, out, error = study.run()
    assert code == 2 and error.splitlines()[-1].startswith('study.py: output = ')
