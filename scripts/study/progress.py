"""What scripts/study.py shows of snakemake's work: a line per finished job with the time left, and what went wrong.

snakemake loads this file (--log-handler-script) and calls `log_handler` with its messages, in the folder of the study.
"""
import json
import os
import re
import sys
import time

from snakemake.logging import logger

TARGETS = ('runs', 'page')


class Progress:
    """Jobs and their state, as far as snakemake has told."""

    def __init__(self):
        self.names, self.total, self.finished, self.cost = {}, 0, 0, {}
        self.begin, self.done, self.stopping = time.monotonic(), 0.0, False

    def start(self, message):
        """The list of jobs comes once, before the first one."""
        self.total = int(re.findall(r'\d+', message['msg'])[-1]) - 1  # but the target, which is no work
        with open('plan.json', encoding='utf-8') as file:
            plan = json.load(file)
        for name, bed in plan['beds'].items():
            if plan['bedJobs'] and not os.path.exists(f'beds/{name}/bed.json'):
                self.cost['bed', name] = bed['cost']
        for name, run in plan['runs'].items():
            if not os.path.exists(f'{plan["folder"]}/{name}/summary.json'):
                self.cost['run', name] = run['cost']

    def job(self, message):
        self.names[message['jobid']] = message['name'], next(iter((message.get('wildcards') or {}).values()), '')

    def finish(self, message):
        rule, name = self.names.get(message['jobid'], ('', ''))
        if rule in TARGETS:
            return
        self.finished += 1
        self.done += self.cost.get((rule, name), 0)
        left = (sum(self.cost.values()) / self.done - 1) * (time.monotonic() - self.begin) if self.done else 0
        say(f'{self.finished} of {self.total} jobs: {rule} {name}'.rstrip() + (f', about {clock(left)} left' if left > 1 else ''))

    def info(self, message):
        self.stopping |= message['msg'].startswith('Terminating processes on user request')

    def fail(self, message):
        if self.stopping:
            return
        logs = ' '.join(message.get('log') or ())
        say(f'FAILED: {message["name"]}' + (f', see {logs}: {reason(logs)}' if logs else ''))


def reason(path):
    """The last line of a log that tells of an error, or its last line."""
    try:
        with open(path, encoding='utf-8', errors='replace') as file:
            lines = (file.read().strip() or 'it is empty').splitlines()
    except OSError:
        return 'it is not there'
    return next((line for line in reversed(lines) if 'Error' in line or '.py: ' in line), lines[-1])


def clock(seconds):
    return f'{int(seconds) // 3600}:{int(seconds) // 60 % 60:02d} h' if seconds >= 3600 else f'{int(seconds) // 60 + 1} min'


def say(text):
    print(text, file=sys.stderr, flush=True)


progress = Progress()
HANDLERS = {'run_info': progress.start, 'job_info': progress.job, 'job_finished': progress.finish, 'job_error': progress.fail,
            'info': progress.info, 'error': lambda message: say(message['msg'])}


# snakemake's own words, ten lines a job, go to its log file in .snakemake/log only (--quiet would keep them from us as well).
logger.set_stream_handler = lambda handler: None


def log_handler(message):
    """Called by snakemake with each of its messages, a dict."""
    handler = HANDLERS.get(message['level'])
    if handler:
        handler(message)
