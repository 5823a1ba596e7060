"""A run on a bed that is made once and used many times: what such runs have in common beside their stages (`StagedRun`)."""
import os
import shutil
import sys

from . import checkpoint, finishedbed
from ..scene.container import Container
from .staged import StagedRun


class BedRun(StagedRun):
    """A run that makes its bed in the stages before BED, or takes a finished one (`onBed`).

    `run(until=BED)` leaves the finished bed in the folder, for any number of runs. A subclass says what it writes and which parameters it has.
    """

    BED = 'prepare'  # the first stage after the bed
    FILES = ()       # of the results; first the one that says that the others are complete

    @staticmethod
    def checked(parameters):
        """Complete parameters from those given; ValueError."""
        raise NotImplementedError

    @staticmethod
    def bedPart(parameters):
        """Those of complete `parameters` from which the bed is made."""
        raise NotImplementedError

    @classmethod
    def inFolder(cls, output, state, files=None, stream=sys.stderr):
        """See `StagedRun.inFolder`; `files` are those of beds and results."""
        return super().inFolder(output, state, files or (finishedbed.STATE, *cls.FILES, finishedbed.SCENE), stream)

    @classmethod
    def onBed(cls, bed, parameters, output, stream=sys.stderr):
        """Take a finished bed (the folder `bed`, see `run`) instead of making one; otherwise like `begin`.

        :param parameters: where they belong to the bed, they must be its own
        :raises ValueError: there is no bed, a damaged one, or another one; before anything changes
        """
        state = finishedbed.read(bed, cls.bedPart)
        parameters = cls.checked({**state['parameters'], **parameters})
        finishedbed.requireSame(bed, cls.bedPart(parameters), cls.bedPart(state['parameters']))
        if os.path.realpath(output) == os.path.realpath(bed):
            raise ValueError(f'output = {output!r}: holds the bed; another folder is needed')
        cls.checkFolder(output)
        finishedbed.load(bed)
        own = {'parameters': parameters, 'bedSeconds': state['seconds'], 'seconds': 0.0, 'stageSeconds': {}}
        run = cls.inFolder(output, {**state, **own}, stream=stream)
        shutil.copyfile(os.path.join(bed, finishedbed.BEFORE), run.path(finishedbed.BEFORE))
        return run

    @property
    def container(self):
        return Container(**self.state['container'])

    def leave(self, until):
        if until == self.BED:
            finishedbed.save(self.output, self.state)
            checkpoint.remove(self.output)
        else:
            super().leave(until)
