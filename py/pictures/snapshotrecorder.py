"""SnapshotSequence of a run at equal times, on disk so that they survive an interruption: for the pictures at its end."""
from __future__ import annotations

import os
import re
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from yade import O

from ..measure.scenesnapshot import SceneSnapshot
from ..renamed import oldNames
from ..vtk import recorder

NAME = re.compile(r'(\d{6})\.npz')


class SnapshotRecorder:
    """Looks at the scene after every step (`sample`); what it takes does not depend on where a run was interrupted. Snapshots from
    after the present moment, which a run took that was killed and goes on from an earlier checkpoint, are removed.

    :param folder: of the snapshots, None: none are kept; :param series: folder of a series for ParaView, None: none
    :param start: time of the first snapshot; :param period: from one to the next [s]
    """

    def __init__(self, folder: str | None, series: str | None, start: float, period: float) -> None:
        self.folder, self.series, self.start, self.period = folder, series, start, period
        for path in filter(None, (folder, series)):
            os.makedirs(path, exist_ok=True)
        if folder is not None:
            for number in _numbers(folder):
                if number > self._number(O.time - O.dt / 2):
                    os.remove(_path(folder, number))

    def sample(self) -> None:
        """Take a snapshot if the last step went past the time of one."""
        middle = O.time - O.dt / 2  # of the step: away from the snapshots' times, so that rounding decides nothing
        number = self._number(middle)
        if number == self._number(middle - O.dt):
            return
        if self.folder is not None:
            SceneSnapshot.ofScene().save(_path(self.folder, number))
        if self.series is not None:
            recorder.record(self.series)

    def _number(self, time: float) -> int:
        return int((time - self.start) // self.period)

    def snapshots(self) -> SnapshotSequence:
        """The `SnapshotSequence` so far; empty if the first ones were not taken."""
        numbers = [] if self.folder is None else _numbers(self.folder)
        return SnapshotSequence(self.folder or '', self.period, numbers if numbers[:1] == [0] else [])


class SnapshotSequence(Sequence[SceneSnapshot]):
    """SnapshotSequence in a folder in the order of time, each read when it is asked for: all of a large bed would not fit into memory.

    :ivar times: when they were taken, to a time step [s]; from the first one
    """

    def __init__(self, folder: str, period: float, numbers: Sequence[int]) -> None:
        self.folder, self.period, self.numbers = folder, period, numbers
        self.times = [number * period for number in numbers]

    def __len__(self) -> int:
        return len(self.numbers)

    def __getitem__(self, place: Any) -> Any:
        if isinstance(place, slice):
            return SnapshotSequence(self.folder, self.period, self.numbers[place])
        return SceneSnapshot.load(_path(self.folder, self.numbers[place]))


def removeSnapshots(folder: str) -> None:
    """Remove the snapshots in a folder, and the folder if nothing else is in it."""
    if os.path.isdir(folder):
        for name in os.listdir(folder):
            if NAME.fullmatch(name.removesuffix('.part')):
                os.remove(os.path.join(folder, name))
        with suppress(OSError):  # something else is in it
            os.rmdir(folder)


def _numbers(folder: str) -> list[int]:
    return sorted(int(found[1]) for found in map(NAME.fullmatch, os.listdir(folder)) if found)


def _path(folder: str, number: int) -> str:
    return os.path.join(folder, f'{number:06d}.npz')


__getattr__ = oldNames(__name__, {'Film': 'SnapshotRecorder', 'Frames': 'SnapshotSequence', 'removeFrames': 'removeSnapshots'})
