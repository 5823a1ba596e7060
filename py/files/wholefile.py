"""Binary files that are whole or not there; for text see `results.Replacing`."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from .results import Replacing

if TYPE_CHECKING:
    from ..typealiases import PathLike


class ReplacingBytes(Replacing):
    """A binary file that takes the place of `path` only when it has been written completely."""

    def __enter__(self) -> Any:
        self.file = open(self.partial, 'wb')
        return self.file


def requireFolder(path: PathLike) -> None:
    """ValueError where the folder that `path` is to be written into is missing: before the work for it is done."""
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise ValueError(f'path = {path!r}: there is no folder {folder}')
