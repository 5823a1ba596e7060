"""A time series of files for ParaView: NAME.pvd in a folder, and the files of its moments in the folder NAME beside it."""
from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, NamedTuple
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

from ..files import summed
from ..files.wholefile import ReplacingBytes

if TYPE_CHECKING:
    from ..typealiases import PathLike


class Entry(NamedTuple):
    """A moment of a series: O.iter, O.time [s], file beside the .pvd."""

    step: int
    time: float
    file: str


class Series:
    """The series `folder`/`name`.pvd. The .pvd is replaced as a whole with each new moment, and names complete files only: a run may be killed at any
    time, and ParaView may read while it goes on.

    The list is the file's: whoever goes on with a run needs nothing else.
    """

    def __init__(self, folder: PathLike, name: str) -> None:
        self.folder, self.name = folder, name
        self.path = os.path.join(folder, f'{name}.pvd')

    def entries(self) -> list[Entry]:
        """The moments so far, a list of `Entry`, in the order of time.

        :raises ValueError: a damaged .pvd
        """
        if not os.path.exists(self.path):
            return []
        try:
            if not summed.intact(self.path):
                raise ValueError('its sum is wrong or missing')
            return [Entry(self._step(node.attrib['file']), float(node.attrib['timestep']), node.attrib['file'])
                    for node in ElementTree.parse(self.path).iter('DataSet')]
        except (ElementTree.ParseError, KeyError, ValueError) as error:
            raise ValueError(f'{self.path}: is damaged, or another program\'s ({error}); remove it to begin anew') from None

    def append(self, step: int, time: float, write: Callable[[str], object]) -> None:
        """Add the moment; `write(path)` makes its file. Moments that the series has at this step and later are of a run that did not go on (of
        before an O.load, or an earlier one from the start) and go, with their files.
        """
        before = self.entries()
        kept = [entry for entry in before if entry.step < step]
        file = f'{self.name}/{self.name}.{step:010d}.vtp'
        os.makedirs(os.path.join(self.folder, self.name), exist_ok=True)
        if len(kept) < len(before):
            self._write(kept)
            for entry in before[len(kept):]:
                if os.path.exists(os.path.join(self.folder, entry.file)):
                    os.remove(os.path.join(self.folder, entry.file))
        write(os.path.join(self.folder, file))
        self._write([*kept, Entry(step, time, file)])

    def remove(self) -> None:
        """Remove the files of the series, and its folder of moments if nothing else is in it."""
        moments = os.path.join(self.folder, self.name)
        for name in os.listdir(moments) if os.path.isdir(moments) else ():
            if re.fullmatch(rf'{re.escape(self.name)}\.\d{{10,}}\.vtp(\.part)?', name):
                os.remove(os.path.join(moments, name))
        for path in (self.path, f'{self.path}.part'):
            if os.path.exists(path):
                os.remove(path)
        with suppress(OSError):  # it is not there, or something else is in it
            os.rmdir(moments)

    def _write(self, entries: Sequence[Entry]) -> None:
        moments = ''.join(f'<DataSet timestep="{entry.time!r}" part="0" file={quoteattr(entry.file)}/>\n' for entry in entries)
        content = (f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="1.0" byte_order="LittleEndian">\n<Collection>\n{moments}'
                   '</Collection>\n</VTKFile>').encode()
        with ReplacingBytes(self.path) as file:
            file.write(content + summed.seal(content))

    def _step(self, file: str) -> int:
        """The step in the name of a file of this series."""
        found = re.fullmatch(rf'{re.escape(self.name)}/{re.escape(self.name)}\.(\d{{10,}})\.vtp', file)
        if not found:
            raise ValueError(f'{file!r} is none of this series')
        return int(found[1])
