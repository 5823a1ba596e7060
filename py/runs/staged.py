"""A run in stages, in a folder of its own, that can be interrupted and taken up again: what all such runs have in common."""
import os
import sys
import time
from collections import Counter

from . import checkpoint
from ..scene.engines import solverCounters
from ..scene.stepping import Interrupted, Stepper


class StagedRun:
    """A run in the folder `output`. A subclass has a method `_<stage>` for each of its STAGES, which ends by setting state['stage'] to
    the next one, and 'done' at last. `summary` holds the results.

    :ivar state: what a resumed run has to know beside the scene; plain numbers, lists and dicts
    :ivar pictures: whether to draw them at the end
    """

    STAGES = ()
    SAVED = (Interrupted,)  # what leaves a checkpoint when it ends the run

    def __init__(self, output, state, stream=sys.stderr):
        self.output, self.state, self.stream = output, state, stream
        self.parameters = state['parameters']
        self.summary = None
        self.pictures = True

    @staticmethod
    def checkFolder(output):
        """ValueError if the folder holds an interrupted run."""
        if checkpoint.exists(output):
            raise ValueError(f'output = {output!r}: holds an interrupted run; use --resume or another folder')

    @classmethod
    def inFolder(cls, output, state, files, stream=sys.stderr):
        """A run at its beginning; of `files`, those that an earlier run left in the folder are removed.

        :raises ValueError: the folder holds an interrupted run
        """
        cls.checkFolder(output)
        os.makedirs(output, exist_ok=True)
        checkpoint.remove(output)
        run = cls(output, {'seconds': 0.0, 'stageSeconds': {}, 'solver': {}, **state, 'kind': cls.__name__}, stream)
        for name in files:
            if os.path.exists(run.path(name)):
                os.remove(run.path(name))
        return run

    @staticmethod
    def isInterrupted(output):
        """Whether the folder holds an interrupted run."""
        return checkpoint.exists(output)

    @classmethod
    def resume(cls, output, stream=sys.stderr):
        """Take up the interrupted run in the folder `output`.

        :raises ValueError: there is none, a damaged one, or one of another kind; YADE's present scene is then as it was
        """
        def check(state):
            if state.get('kind') != cls.__name__:
                raise ValueError(f'output = {output!r}: the interrupted run there is of the kind {state.get("kind")}, not {cls.__name__}')

        return cls(output, checkpoint.load(output, check), stream)

    def path(self, name):
        return os.path.join(self.output, name)

    def run(self, until='done'):
        """Do all stages that are left, write the results, return the summary.

        :param until: a later one of STAGES: stop before it, leave a checkpoint for `resume`, return None
        :raises Interrupted: after Ctrl-C, with a checkpoint written
        :raises ValueError: `until` is no stage, or one that this run has left behind; before anything changes
        """
        self._checkStage(until)
        self._started = time.perf_counter()
        with Stepper(self._plan(), self.stream, self.state.pop('stepsLeft', None)) as self.stepper:
            try:
                while self.state['stage'] != until:
                    stage = self.state['stage']
                    self.stepper.begin(stage)
                    getattr(self, '_' + stage)()
                    self.count(stage)
            except self.SAVED:
                self.count(stage)
                self.save()
                raise
            self.leave(until)
        return self.summary

    def _checkStage(self, until):
        stages, present = (*self.STAGES, 'done'), self.state['stage']
        if until not in stages:
            raise ValueError(f'until = {until!r}: must be one of {", ".join(stages)}')
        if stages.index(until) < stages.index(present):
            raise ValueError(f'until = {until!r}: the run in {self.output!r} is already in the stage {present!r}')

    def leave(self, until):
        """The folder as it should be when the stages before `until` are done."""
        if until == 'done':
            checkpoint.remove(self.output)  # what is done needs none: it would only mislead
        else:
            self.save()

    def save(self):
        """Write a checkpoint, for `resume`."""
        self.state['stepsLeft'] = self.stepper.left
        checkpoint.save(self.output, self.state)

    def _plan(self):
        """Expected steps of the stages that are left, {stage: steps}, for the estimate of the time left."""
        return {}

    def count(self, stage):
        """Add to the totals of a run that may have been interrupted: time taken in all and in the `stage`, solver's counters."""
        now = time.perf_counter()
        self.state['seconds'] += now - self._started
        self.state['stageSeconds'][stage] = self.state['stageSeconds'].get(stage, 0.0) + now - self._started
        self._started = now
        solver = Counter(self.state['solver'])
        solver.update(solverCounters(reset=True))
        self.state['solver'] = dict(solver)
