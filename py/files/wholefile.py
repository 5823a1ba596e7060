"""Binary files that are whole or not there; for text see `results.Replacing`."""
import os

from .results import Replacing


class ReplacingBytes(Replacing):
    """A binary file that takes the place of `path` only when it has been written completely."""

    def __enter__(self):
        self.file = open(self.partial, 'wb')
        return self.file


def requireFolder(path):
    """ValueError where the folder that `path` is to be written into is missing: before the work for it is done."""
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise ValueError(f'path = {path!r}: there is no folder {folder}')
