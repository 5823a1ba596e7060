"""Run a study: many beds and runs on them, impacts for example, on all cores or a cluster, and from them a table, figures and findings.

    tools/env --with study scripts/study.py scripts/study/quick.yaml --output results/quick

The study file says what varies (docs/study.md; examples are in scripts/study/). The same command goes on after Ctrl-C or a crash, and after
a change of the study file: what is finished is never computed again.
"""
import argparse
import fcntl
import os
import shutil
import signal
import subprocess
import sys

from yade.superquadric.files import results, sealed
from yade.superquadric.runs.commandline import BAD_INPUT, INTERRUPTED
from yade.superquadric.study import plan as plans
from yade.superquadric.study import studyfile, table

SNAKEFILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'study', 'Snakefile')
SHOWN = ['--log-handler-script', os.path.join(os.path.dirname(SNAKEFILE), 'progress.py')]  # what the user sees of snakemake's work
FAILED = 1  # exit code beside those of all scripts


def parser():
    result = argparse.ArgumentParser(prog='study.py', description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('study', metavar='STUDY.yaml', help='the study file')
    result.add_argument('--output', metavar='FOLDER', required=True, help='folder of the study\'s results')
    result.add_argument('--cores', metavar='N', help='jobs at a time, one thread each (default: all cores)')
    result.add_argument('--profile', metavar='FOLDER', help='a snakemake profile, such as scripts/study/slurm for a cluster')
    result.add_argument('--seeds', metavar='SEED', nargs='+', help='instead of the seeds in the study file')
    result.add_argument('--dry-run', action='store_true', help='only write the plan and say what there is to do')
    return result


class Snakemake:
    """Calls snakemake, and hands Ctrl-C and the like on to it and all its jobs.

    It runs in a process group of its own: a Ctrl-C on the terminal reaches each job once, since a second one would keep it from
    saving its state.

    :ivar stopped: whether the user wants to stop
    """

    def __init__(self, folder, options):
        self.folder, self.stopped, self._process = folder, False, None
        self._limits = ['--profile', os.path.abspath(options.profile)] if options.profile else ['--keep-going', '--rerun-incomplete']
        if options.cores or not options.profile:
            self._limits += ['--cores', options.cores or str(len(os.sched_getaffinity(0)))]
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if number != signal.SIGHUP or signal.getsignal(number) != signal.SIG_IGN:  # nohup
                signal.signal(number, self._stop)

    def run(self, target, *options):
        """Make the target of the Snakefile. Returns whether all of it was made."""
        if self.stopped:
            return False
        # Dates are for table and figures; beds and runs that are there are no jobs at all. When this process is killed snakemake
        # dies as well, and then its jobs leave a checkpoint.
        self._process = subprocess.Popen(
            ['setpriv', '--pdeathsig', 'KILL', 'snakemake', target, '--snakefile', SNAKEFILE, '--directory', self.folder, *self._limits,
             '--rerun-triggers', 'mtime', 'input', '--scheduler', 'greedy', *options],
            start_new_session=True)
        if self.stopped:  # while it was being started
            self._interrupt()
        return self._process.wait() == 0

    def _stop(self, number, frame):
        if not self.stopped:
            print('study.py: stopping; jobs save their state', file=sys.stderr, flush=True)
        self.stopped = True
        self._interrupt()

    def _interrupt(self):
        if self._process and self._process.poll() is None:
            os.killpg(self._process.pid, signal.SIGINT)


def lockedFile(folder):
    """The open file that keeps the folder for this process; ValueError if another one has it."""
    file = open(os.path.join(folder, 'study.lock'), 'w', encoding='utf-8')
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise ValueError(f'output = {folder!r}: another study.py is at work there') from None
    return file


def removeDamaged(plan, folder):
    """Remove results that do not hold what their name promises (a full disk, a power cut); yield a sentence on each."""
    for bed in plan['beds']:
        path = os.path.join(folder, 'beds', bed, 'bed.json')
        try:
            if os.path.exists(path):
                sealed.read(path)
        except ValueError as error:
            os.remove(path)
            yield f'{os.path.dirname(path)}: {error}; the bed is made again'
    for run in table.finishedRuns(plan, folder):
        try:
            table.readSummary(plan, folder, run)
        except ValueError as error:
            os.remove(table.summaryPath(plan, folder, run))
            yield f'{error}; the run is done again'


def conclusions(folder):
    """The verdicts on the study's findings, one line each."""
    for finding in results.readJson(os.path.join(folder, 'figures', 'findings.json'))['findings']:
        yield f'{finding["verdict"]:14}{finding["paper"]}'


def prepare(options):
    """Check all input, then write the plan. Returns plan, folder and lock."""
    if options.cores is not None and not (options.cores.isdecimal() and int(options.cores)):
        raise ValueError(f'cores = {options.cores!r}: must be a whole number of at least 1')
    if options.profile and not os.path.isfile(os.path.join(options.profile, 'config.yaml')):
        raise ValueError(f'profile = {options.profile!r}: there is no config.yaml in that folder')
    plan = plans.planOf(studyfile.read(options.study), options.seeds)
    folder = os.path.abspath(options.output)
    try:
        os.makedirs(folder, exist_ok=True)
        lock = lockedFile(folder)
        plans.write(plan, folder)
        # With our lock in hand, the one of snakemake is that of a snakemake that was killed.
        shutil.rmtree(os.path.join(folder, '.snakemake', 'locks'), ignore_errors=True)
        for sentence in removeDamaged(plan, folder):
            print(f'study.py: {sentence}', file=sys.stderr)
    except OSError as error:
        raise ValueError(f'output = {options.output!r}: {error.strerror} ({error.filename})') from None
    return plan, folder, lock


def main():
    options = parser().parse_args()
    try:
        plan, folder, lock = prepare(options)
    except ValueError as error:
        print(f'study.py: {error}', file=sys.stderr)
        return BAD_INPUT
    with lock:
        return run(plan, folder, options)


def run(plan, folder, options):
    """Make what is missing of the study, then table and figures from what there is. Returns the exit code."""
    snakemake = Snakemake(folder, options)
    what, finished = plan['folder'], table.finishedRuns(plan, folder)
    print(f'{len(plan["runs"])} {what} {"on" if plan["bedJobs"] else "of"} {len(plan["beds"])} beds; {len(finished)} {what} are finished', flush=True)
    if options.dry_run:
        return 0 if snakemake.run('runs', '--dry-run', '--quiet', 'rules') else FAILED
    complete = snakemake.run('runs', *SHOWN)
    finished = table.finishedRuns(plan, folder)
    drawn = bool(finished) and snakemake.run('page', *SHOWN, '--config', 'finishedOnly=1')
    if snakemake.stopped:
        print(f'Stopped; {len(finished)} of {len(plan["runs"])} {what} are finished. The same command goes on.', file=sys.stderr)
        return INTERRUPTED
    if drawn:
        print(*conclusions(folder), sep='\n')
        print(f'results       {folder}/results.csv, {folder}/figures/findings.md')
    if complete and drawn:
        return 0
    print(f'study.py: not all was made: {len(finished)} of {len(plan["runs"])} {what} are finished'
          f'{" and in the table" if drawn else ""}. What went wrong is in {folder}/logs; the same command tries again.', file=sys.stderr)
    return FAILED


if __name__ == '__main__':
    sys.exit(main())
