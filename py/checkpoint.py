"""The checkpoint of an interrupted run: YADE's scene, and as JSON what a run has to know beside it. The two are always of one moment."""
import os

from yade import O

from . import sealed

SCENE, STATE = 'checkpoint.yade.gz', 'checkpoint.json'


def exists(folder):
    """Whether there is a complete checkpoint in the folder."""
    return os.path.exists(os.path.join(folder, STATE))


def save(folder, state):
    """Write the scene and the `state` (a dict for JSON). Whoever is killed in the middle leaves none, never two halves that do not fit."""
    remove(folder)
    O.save(os.path.join(folder, SCENE))
    sealed.write(os.path.join(folder, STATE), state, (SCENE,))


def load(folder):
    """Load the scene; returns the state.

    :raises ValueError: there is no checkpoint, or a damaged one; YADE's present scene is then as it was
    """
    if not (exists(folder) and os.path.exists(os.path.join(folder, SCENE))):
        raise ValueError(f'output = {folder!r}: there is no checkpoint of an interrupted run to resume')
    try:
        state = sealed.read(os.path.join(folder, STATE))
        O.load(os.path.join(folder, SCENE))
    except (ValueError, RuntimeError) as error:
        raise ValueError(f'output = {folder!r}: its checkpoint is damaged ({error}); remove {STATE} to begin anew') from None
    return state


def remove(folder):
    """Remove the checkpoint: the state first, without which the scene counts for nothing."""
    for name in (STATE, SCENE):
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
