"""A bed at rest in a folder of its own, for any number of runs: YADE's scene, the particles, and the state of the run that made it, written
last. All three or no bed."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

from yade import O

from ..files import sealed
from .filenames import BED, BEFORE

SCENE = 'bed.yade.gz'


def save(folder: str, state: Mapping[str, Any]) -> None:
    """Write the scene, then the `state`; the file with the particles must be there already."""
    O.save(os.path.join(folder, SCENE))
    sealed.write(os.path.join(folder, BED), state, (SCENE, BEFORE))


def exists(folder: str) -> bool:
    return os.path.exists(os.path.join(folder, BED))


def read(folder: str, decode: Callable[[dict[str, Any]], Any] = lambda state: state) -> Any:
    """The finished bed in the `folder`; all its files are complete then.

    :param decode: is given the state; may raise a ValueError
    :returns: what `decode` has made of the state
    :raises ValueError: there is no bed, a damaged one, or one of another version
    """
    if not exists(folder):
        raise ValueError(f'bed = {folder!r}: there is no finished bed in that folder ({BED})')
    try:
        state = sealed.read(os.path.join(folder, BED))
    except ValueError as error:
        raise ValueError(f'bed = {folder!r}: {error}') from None
    try:
        return decode(state)
    except ValueError as error:
        raise ValueError(f'bed = {folder!r}: {BED} is of another version ({error}); make the bed again') from None


def load(folder: str) -> None:
    """Make the bed in the `folder` YADE's scene.

    :raises ValueError: it is damaged
    """
    try:
        O.load(os.path.join(folder, SCENE))
    except RuntimeError as error:
        raise ValueError(f'bed = {folder!r}: {SCENE} cannot be loaded ({error})') from None


def requireSame(folder: str, wanted: Mapping[str, Any], own: Mapping[str, Any]) -> None:
    """ValueError if the parameters `wanted` of a bed are not its `own`."""
    for name, value in wanted.items():
        if value != own[name]:
            raise ValueError(f'{name} = {value!r}: the bed in {folder!r} was poured with {own[name]!r}')
