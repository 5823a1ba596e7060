"""Running a scene step by step: progress with an estimate of the time left, and a clean stop on Ctrl-C."""
from __future__ import annotations

import signal
import sys
import time
from collections.abc import Callable, Mapping
from typing import Any, Self, TextIO

from yade import O

from .. import checks


class Interrupted(Exception):
    """Ctrl-C (or SIGTERM) came; the scene stands between two steps and can be saved."""


class Stepper:
    """Runs the scene. `with Stepper() as stepper:` catches the first Ctrl-C or SIGTERM and raises `Interrupted` at the
    end of the running step; a second Ctrl-C stops at once, as usual.

    A stage asks for steps in portions, and what it remembers changes between portions only. So a stop in a portion leaves
    `left`, its missing steps; a Stepper made with that number does only them when the same portion is asked for again, and
    the run goes on as if it had never stopped.

    :param plan: expected number of steps of each stage, {name: steps}, for the estimate of the time left
    :param stream: where progress goes; None for silence
    :param left: steps that are missing in the first portion, None: all
    """

    REFRESH = 0.5    # s between updates of the line on a terminal
    LOG_REFRESH = 5.0  # s between lines in a log file

    def __init__(self, plan: Mapping[str, float] | None = None, stream: TextIO | None = sys.stderr, left: int | None = None) -> None:
        self.plan: dict[str, float] = dict(plan or {})
        self.stream, self.left = stream, left
        self.stage, self.stageSteps = '', 0
        self.steps, self.seconds = 0, 0.0
        self._handlers: dict[int, Any] = {}
        self._stop, self._lastReport = False, 0.0

    def __enter__(self) -> Self:
        for number in (signal.SIGINT, signal.SIGTERM):
            self._handlers[number] = signal.signal(number, self._requestStop)
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._handlers.items():
            signal.signal(number, handler)
        self._endLine()

    def begin(self, stage: str) -> None:
        """Say which stage of the plan the next steps belong to."""
        if self.stage:
            self.plan.pop(self.stage, None)
        self.stage, self.stageSteps, self._lastReport = stage, 0, 0.0
        self.report()

    def run(self, steps: int, afterStep: Callable[[], object] | None = None) -> None:
        """Do a portion of `steps` steps; `afterStep()` is called after each, forces are then still those of the step.

        :raises ValueError: `steps` is no whole number
        :raises Interrupted: the user wants to stop; at least one step is left then, which brings the forces back
        """
        steps = checks.wholeNumber('steps', steps, 0)
        self.left = steps if self.left is None else self.left
        while self.left:
            if self._stop:
                raise Interrupted
            start = time.perf_counter()
            O.step()
            if afterStep:
                afterStep()
            self.seconds += time.perf_counter() - start
            self.steps += 1
            self.stageSteps += 1
            self.left -= 1
            self.report()
        self.left = None

    def secondsLeft(self) -> float | None:
        """Expected seconds for what the plan still holds; None without a plan, or before there is something to go by."""
        if not self.plan or self.steps < 20:
            return None
        left = sum(steps for stage, steps in self.plan.items() if stage != self.stage)
        left += max(self.plan.get(self.stage, 0) - self.stageSteps, 0)
        return left * self.seconds / self.steps

    def report(self) -> None:
        """Write the line of progress, if it is time for it."""
        if self.stream is None:
            return
        now, terminal = time.monotonic(), self.stream.isatty()
        if now - self._lastReport < (self.REFRESH if terminal else self.LOG_REFRESH):
            return
        self._lastReport = now
        left = self.secondsLeft()
        stage = f'{self.stage}: ' if self.stage else ''
        text = f'{stage}step {self.stageSteps}, t = {O.time:.4f} s' + (
            '' if left is None else f', about {_clock(left)} left')
        self.stream.write(f'\r\x1b[K{text}' if terminal else text + '\n')
        self.stream.flush()

    def say(self, text: str) -> None:
        """Write a line that stays."""
        if self.stream is not None:
            self._endLine()
            self.stream.write(text + '\n')
            self.stream.flush()

    def _endLine(self) -> None:
        if self.stream is not None and self.stream.isatty():
            self.stream.write('\r\x1b[K')

    def _requestStop(self, number: int, frame: object) -> None:
        if self._stop and number == signal.SIGINT:
            raise KeyboardInterrupt
        self._stop = True


def _clock(seconds: float) -> str:
    minutes, seconds = divmod(int(seconds + 0.5), 60)
    hours, minutes = divmod(minutes, 60)
    return f'{hours}:{minutes:02d}:{seconds:02d}' if hours else f'{minutes}:{seconds:02d}'
