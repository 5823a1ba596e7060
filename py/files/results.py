"""What a run leaves: time series as CSV, a summary as JSON."""
from __future__ import annotations

import contextlib
import csv
import json
import os
from collections.abc import Iterable, Sequence
from typing import IO, TYPE_CHECKING, Any

from .. import checks

if TYPE_CHECKING:
    from ..typealiases import PathLike


def writeCsv(path: PathLike, columns: Sequence[str], rows: Iterable[Iterable[float]]) -> None:
    """Write `rows` under the names `columns`; numbers keep all their digits."""
    with Replacing(path) as file:
        writer = csv.writer(file, lineterminator='\n')
        writer.writerow(columns)
        writer.writerows([repr(float(value)) for value in row] for row in rows)


def readCsv(path: PathLike) -> tuple[tuple[str, ...], list[tuple[float, ...]]]:
    """Columns and rows of floats, as `writeCsv` wrote them.

    :raises ValueError: naming the file, which holds something else
    """
    try:
        with open(path, newline='', encoding='utf-8') as file:
            reader = csv.reader(file)
            columns = tuple(next(reader, ()))
            rows = [tuple(map(float, row)) for row in reader]
    except (ValueError, csv.Error) as error:
        raise ValueError(f'{path}: damaged ({error})') from None
    if not columns or any(len(row) != len(columns) for row in rows):
        raise ValueError(f'{path}: damaged (it is empty, or a row is not as long as the first one)')
    return columns, rows


def writeJson(path: PathLike, content: Any) -> None:
    with Replacing(path) as file:
        json.dump(content, file, indent=2)
        file.write('\n')


def readJson(path: PathLike) -> Any:
    """What the JSON file holds.

    :raises ValueError: naming the file, which is no JSON
    """
    try:
        with open(path, encoding='utf-8') as file:
            return json.load(file)
    except (ValueError, RecursionError) as error:
        raise ValueError(f'{path}: damaged ({error})') from None


def flush(path: PathLike) -> None:
    """See to it that the file is on the disk, also after a power cut, before another one says that it is there."""
    with open(path, 'rb') as file:
        os.fsync(file.fileno())


class Replacing:
    """A text file that takes the place of `path` only when it has been written completely."""

    def __init__(self, path: PathLike) -> None:
        self.path = checks.path('path', path)
        self.partial = f'{self.path}.part'
        self.file: IO[Any]

    def __enter__(self) -> Any:
        self.file = open(self.partial, 'w', newline='', encoding='utf-8')
        return self.file

    def __exit__(self, failed: type[BaseException] | None, *_: object) -> None:
        try:
            if not failed:
                self.file.flush()  # where a full disk shows
                os.fsync(self.file.fileno())
                self.file.close()
                os.replace(self.partial, self.path)
        except BaseException:
            self._giveUp()
            raise
        if failed:
            self._giveUp()
        else:
            _flushFolder(os.path.dirname(self.path) or '.')

    def _giveUp(self) -> None:
        with contextlib.suppress(OSError):  # what is in its buffer may fail once more
            self.file.close()
        os.remove(self.partial)


def _flushFolder(path: PathLike) -> None:
    """The same for the names in the folder."""
    folder = os.open(path, os.O_RDONLY)
    try:
        with contextlib.suppress(OSError):  # some network file systems cannot
            os.fsync(folder)
    finally:
        os.close(folder)
