"""Frames of a run at equal times, on disk so that they survive an interruption: for the pictures at its end."""
import os
import shutil

from yade import O

from . import vtkrecorder
from .frame import Frame


class Film:
    """Looks at the scene after every step (`sample`); what it takes does not depend on where a run was interrupted.

    :param folder: of the frames, None: none are kept; :param series: folder of a series for ParaView, None: none
    :param start: time of the first frame; :param period: from frame to frame [s]
    """

    def __init__(self, folder, series, start, period):
        self.folder, self.series, self.start, self.period = folder, series, start, period
        for path in filter(None, (folder, series)):
            os.makedirs(path, exist_ok=True)

    def sample(self):
        """Take a frame if the last step went past the time of one."""
        middle = O.time - O.dt / 2  # of the step: away from the frames' times, so that rounding decides nothing
        number = self._number(middle)
        if number == self._number(middle - O.dt):
            return
        if self.folder is not None:
            Frame.ofScene().save(os.path.join(self.folder, _name(number)))
        if self.series is not None:
            vtkrecorder.record(self.series)

    def _number(self, time):
        return int((time - self.start) // self.period)

    def frames(self):
        """The frames so far, in the order of time; none if the first ones were not taken."""
        if self.folder is None or not os.path.exists(os.path.join(self.folder, _name(0))):
            return []
        return [Frame.load(os.path.join(self.folder, name)) for name in sorted(os.listdir(self.folder))]

    def remove(self):
        """Remove the frames, not the series."""
        if self.folder is not None:
            shutil.rmtree(self.folder)


def _name(number):
    return f'{number:06d}.npz'
