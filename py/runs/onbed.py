"""A run on a bed that is made once and used many times: what such runs have in common beside their stages (`StagedRun`)."""
from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Iterable, Mapping
from typing import Any, ClassVar, Self, TextIO, TypeVar

from ..scene.container import Container
from . import checkpoint, filenames, finishedbed
from .parameters import BED, Parameters
from .staged import StagedRun
from .state import BedState

P = TypeVar('P', bound=Parameters)
S = TypeVar('S', bound=BedState)


class BedRun(StagedRun[P, S]):
    """A run that makes its bed in the stages before AFTER_BED, or takes a finished one (`onBed`).

    `run(until=AFTER_BED)` leaves the finished bed in the folder, for any number of runs.
    """

    AFTER_BED: ClassVar[str] = 'prepare'  # the first stage after the bed

    @classmethod
    def written(cls) -> Iterable[str]:
        """See `StagedRun.written`; also the files of beds."""
        return filenames.BED, *cls.FILES, finishedbed.SCENE

    @classmethod
    def onBed(cls, bed: str, parameters: Mapping[str, Any], output: str, stream: TextIO | None = sys.stderr) -> Self:
        """Take a finished bed (the folder `bed`, see `run`) instead of making one; otherwise like `begin`.

        :param parameters: where they belong to the bed, they must be its own
        :raises ValueError: there is no bed, a damaged one, or another one; before anything changes
        """
        own, state = finishedbed.read(bed, cls.decoded)
        wanted = own.changed(parameters)
        finishedbed.requireSame(bed, wanted.part(BED), own.part(BED))
        if os.path.realpath(output) == os.path.realpath(bed):
            raise ValueError(f'output = {output!r}: holds the bed; another folder is needed')
        cls.checkFolder(output)
        finishedbed.load(bed)
        state.bedSeconds, state.seconds, state.stageSeconds = state.seconds, 0.0, {}
        run = cls.inFolder(output, wanted, state, stream)
        shutil.copyfile(os.path.join(bed, filenames.BEFORE), run.path(filenames.BEFORE))
        return run

    @property
    def container(self) -> Container:
        return Container(**self.state.container)

    def bedIsDone(self) -> None:
        """Note the time that the bed took, unless it was a finished one."""
        if not self.state.has('bedSeconds'):
            self.state.bedSeconds = self.state.seconds

    def leave(self, until: str) -> None:
        if until == self.AFTER_BED:
            finishedbed.save(self.output, self.encoded())
            checkpoint.remove(self.output)
        else:
            super().leave(until)
