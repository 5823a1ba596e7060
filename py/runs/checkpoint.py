"""The checkpoint of an interrupted run: YADE's scene, and as JSON what a run has to know beside it. The two are always of one moment."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

from yade import O

from ..files import results, sealed
from .filenames import CHECKPOINT

SCENES = ('checkpoint.yade.gz', 'checkpoint-2.yade.gz')  # in turn: the one that the state names counts, the other one is being written


def exists(folder: str) -> bool:
    """Whether there is a complete checkpoint in the folder."""
    return os.path.exists(os.path.join(folder, CHECKPOINT))


def save(folder: str, state: Mapping[str, Any]) -> None:
    """Write the scene and the `state` (for JSON). Whoever is killed in the middle leaves the checkpoint of before, whole, if there was one."""
    scene = next(name for name in SCENES if name != _present(folder))
    O.save(os.path.join(folder, scene))
    sealed.write(os.path.join(folder, CHECKPOINT), {**state, 'scene': scene}, (scene,))
    _removeScenes(folder, but=scene)


def load(folder: str, decode: Callable[[dict[str, Any]], Any] = lambda state: state) -> Any:
    """Load the scene.

    :param decode: is given the state before the scene is loaded; may raise a ValueError
    :returns: what `decode` has made of the state
    :raises ValueError: there is no checkpoint, or a damaged one; YADE's present scene is then as it was
    """
    if not exists(folder):
        raise ValueError(f'output = {folder!r}: there is no checkpoint of an interrupted run to resume')
    try:
        state = sealed.read(os.path.join(folder, CHECKPOINT))
        scene = os.path.join(folder, state.pop('scene'))
    except KeyError:
        raise _damaged(folder, 'of another version') from None
    except ValueError as error:
        raise _damaged(folder, error) from None
    decoded = decode(state)
    try:
        O.load(scene)
    except (ValueError, RuntimeError) as error:
        raise _damaged(folder, error) from None
    return decoded


def remove(folder: str) -> None:
    """Remove the checkpoint: the state first, without which the scene counts for nothing."""
    if exists(folder):
        os.remove(os.path.join(folder, CHECKPOINT))
    _removeScenes(folder)


def _present(folder: str) -> str | None:
    """Name of the scene that belongs to the state in the folder; None without a state, or with a damaged one."""
    try:
        return str(results.readJson(os.path.join(folder, CHECKPOINT))['scene'])
    except (OSError, ValueError, KeyError, TypeError):
        return None


def _removeScenes(folder: str, but: str | None = None) -> None:
    for name in SCENES:
        if name != but and os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))


def _damaged(folder: str, error: object) -> ValueError:
    return ValueError(f'output = {folder!r}: its checkpoint is damaged ({error}); remove {CHECKPOINT} to begin anew')
