"""A run in stages, in a folder of its own, that can be interrupted and taken up again: what all such runs have in common."""
from __future__ import annotations

import os
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, Self, TextIO, TypeVar

from ..scene.engines import solverCounters
from ..scene.stepping import Interrupted, Stepper
from ..version import __version__
from . import checkpoint
from .filenames import CHECKPOINT
from .parameters import Parameters
from .state import State

DONE = 'done'  # follows the last stage

P = TypeVar('P', bound=Parameters)
S = TypeVar('S', bound=State)


def _always(run: Any) -> bool:
    return True


@dataclass(frozen=True)
class Stage:
    """A part of a run.

    :param do: function of the run; a run that is interrupted in it calls it again when it is taken up
    :param when: function of the run that says whether the stage is done at all
    :param backTo: name of the stage to which the run goes back when `do` returns False; else it goes on to the next one
    """

    name: str
    do: Callable[[Any], bool | None]
    when: Callable[[Any], bool] = _always
    backTo: str | None = None


class StagedRun(Generic[P, S]):
    """A run in the folder `output`; a subclass says which parameters, state and stages it has. `summary` holds the results.

    :ivar pictures: whether to draw them at the end
    """

    PARAMETERS: ClassVar[type[Parameters]]
    STATE: ClassVar[type[State]]
    STAGES: ClassVar[tuple[Stage, ...]]
    SAVED: ClassVar[tuple[type[Exception], ...]] = (Interrupted,)  # what leaves a checkpoint when it ends the run
    FILES: ClassVar[tuple[str, ...]] = ()                          # of the results; first the one that says that the others are complete

    stepper: Stepper

    def __init__(self, output: str, parameters: P, state: S, stream: TextIO | None = sys.stderr) -> None:
        self.output, self.parameters, self.state, self.stream = output, parameters, state, stream
        self.summary: dict[str, Any] | None = None
        self.pictures = True
        self._started = 0.0

    @staticmethod
    def checkFolder(output: str) -> None:
        """ValueError if the folder holds an interrupted run."""
        if checkpoint.exists(output):
            raise ValueError(f'output = {output!r}: holds an interrupted run; use --resume or another folder')

    @classmethod
    def inFolder(cls, output: str, parameters: P, state: S, stream: TextIO | None = sys.stderr) -> Self:
        """A run at its beginning; the results that an earlier run left in the folder are removed.

        :raises ValueError: the folder holds an interrupted run
        """
        cls.checkFolder(output)
        os.makedirs(output, exist_ok=True)
        checkpoint.remove(output)
        run = cls(output, parameters, state, stream)
        for name in cls.written():
            if os.path.exists(run.path(name)):
                os.remove(run.path(name))
        return run

    @classmethod
    def written(cls) -> Iterable[str]:
        """Names of the files that a run may leave in its folder, beside a checkpoint."""
        return cls.FILES

    @staticmethod
    def isInterrupted(output: str) -> bool:
        """Whether the folder holds an interrupted run."""
        return checkpoint.exists(output)

    @classmethod
    def resume(cls, output: str, stream: TextIO | None = sys.stderr) -> Self:
        """Take up the interrupted run in the folder `output`.

        :raises ValueError: there is none, a damaged one, or one of another kind or version; YADE's present scene is then as it was
        """
        def decode(content: dict[str, Any]) -> tuple[P, S]:
            if content.get('kind') != cls.__name__:
                raise ValueError(f'output = {output!r}: the interrupted run there is of the kind {content.get("kind")}, not {cls.__name__}')
            try:
                return cls.decoded(content)
            except ValueError as error:
                raise ValueError(f'output = {output!r}: its checkpoint is of another version ({error}); finish that run with the version that '
                                 f'began it, or remove {CHECKPOINT} to begin anew') from None

        parameters, state = checkpoint.load(output, decode)
        return cls(output, parameters, state, stream)

    def encoded(self) -> dict[str, Any]:
        """Parameters and state for JSON."""
        return {'kind': type(self).__name__, 'version': __version__, 'parameters': self.parameters.asDict(), **self.state.asDict()}

    @classmethod
    def decoded(cls, content: Mapping[str, Any]) -> tuple[Any, Any]:
        """Parameters and state of which `content` is what `encoded` gave.

        :raises ValueError: it is of a version with others
        """
        if not isinstance(content.get('parameters'), dict):
            raise ValueError('parameters is missing')
        state = {name: value for name, value in content.items() if name not in ('kind', 'version', 'parameters')}
        return cls.PARAMETERS.read(content['parameters']), cls.STATE.read(state)

    def path(self, name: str) -> str:
        return os.path.join(self.output, name)

    def run(self, until: str = DONE) -> dict[str, Any] | None:
        """Do all stages that are left, write the results, return the summary.

        :param until: a later one of STAGES: stop before it, leave a checkpoint for `resume`, return None
        :raises Interrupted: after Ctrl-C, with a checkpoint written
        :raises ValueError: `until` is no stage, or one that this run has left behind; before anything changes
        """
        order = self._checkedOrder(until)
        self._started = time.perf_counter()
        left, self.state.stepsLeft = self.state.stepsLeft, None
        with Stepper(self.expectedSteps(), self.stream, left) as self.stepper:
            try:
                while order.index(self.state.stage) < order.index(until):
                    self._do(self.STAGES[order.index(self.state.stage)])
            except self.SAVED:
                self.count(self.state.stage)
                self.save()
                raise
            self.leave(until)
        return self.summary

    def _checkedOrder(self, until: str) -> list[str]:
        """Names of the stages in their order, if the run can go on to the beginning of `until`."""
        order = [*(stage.name for stage in self.STAGES), DONE]
        if until not in order:
            raise ValueError(f'until = {until!r}: must be one of {", ".join(order)}')
        if order.index(until) < order.index(self.state.stage):
            raise ValueError(f'until = {until!r}: the run in {self.output!r} is already in the stage {self.state.stage!r}')
        return order

    def _do(self, stage: Stage) -> None:
        self.stepper.begin(stage.name)
        goesOn = stage.do(self) is not False
        later = self.STAGES[self.STAGES.index(stage) + 1:]
        self.state.stage = next((other.name for other in later if other.when(self)), DONE) if goesOn else str(stage.backTo)
        self.count(stage.name)

    def leave(self, until: str) -> None:
        """The folder as it should be when the stages before `until` are done."""
        if until == DONE:
            checkpoint.remove(self.output)  # what is done needs none: it would only mislead
        else:
            self.save()

    def save(self) -> None:
        """Write a checkpoint, for `resume`."""
        self.state.stepsLeft = self.stepper.left
        checkpoint.save(self.output, self.encoded())

    def expectedSteps(self) -> dict[str, float]:
        """Expected steps of the stages that are left, {stage: steps}, for the estimate of the time left."""
        return {}

    def count(self, stage: str) -> None:
        """Add to the totals of a run that may have been interrupted: time taken in all and in the `stage`, solver's counters."""
        now, state = time.perf_counter(), self.state
        state.seconds += now - self._started
        state.stageSeconds[stage] = state.stageSeconds.get(stage, 0.0) + now - self._started
        self._started = now
        solver = Counter(state.solver)
        solver.update(solverCounters(reset=True))
        state.solver = dict(solver)
