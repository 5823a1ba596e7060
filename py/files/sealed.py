"""JSON files that vouch for themselves and for the files that belong to them: what is damaged is noticed before any of it is used.

YADE reads a damaged scene as far as it can, and may end the whole process on the way; a flipped digit in a JSON file is another number.
Hence the sums (SHA-256), looked at first.
"""
from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, Any

from . import results

if TYPE_CHECKING:
    from ..typealiases import PathLike

SEAL = 'seal'


def write(path: PathLike, state: Mapping[str, Any], names: Collection[str]) -> None:
    """Write the `state`, a dict for JSON, and the sums of itself and of the files `names` in its folder, which are complete."""
    files = {name: _sumOfFile(os.path.join(os.path.dirname(path), name)) for name in names}
    for name in names:
        results.flush(os.path.join(os.path.dirname(path), name))
    results.writeJson(path, {**state, SEAL: {'files': files, 'state': _sumOf(state)}})


def read(path: PathLike) -> dict[str, Any]:
    """The state in the file, which has been compared with the sums, and so have the files that belong to it.

    :raises ValueError: naming the file that is damaged or missing
    :raises OSError: one cannot be read, which says nothing about what it holds
    """
    name = os.path.basename(path)
    try:
        state = results.readJson(path)
        seal = state.pop(SEAL)
        intact, files = seal['state'] == _sumOf(state), dict(seal['files'])
    except (ValueError, TypeError, KeyError, AttributeError):
        intact, files = False, {}
    if not intact:
        raise ValueError(f'{name} is damaged, or of another version')
    for beside, expected in files.items():
        try:
            found = _sumOfFile(os.path.join(os.path.dirname(path), beside))
        except FileNotFoundError:
            raise ValueError(f'{beside} is missing') from None
        if found != expected:
            raise ValueError(f'{beside} is damaged, or of another moment than {name}')
    return state


def _sumOf(state: Mapping[str, Any]) -> str:
    # What is read from JSON is written alike: tuples have become lists, keys texts, and numbers keep all their digits.
    return hashlib.sha256(json.dumps(state).encode()).hexdigest()


def _sumOfFile(path: PathLike) -> str:
    with open(path, 'rb') as file:
        return hashlib.file_digest(file, 'sha256').hexdigest()
