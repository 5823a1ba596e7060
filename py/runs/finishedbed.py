"""A bed at rest in a folder of its own, for any number of runs: YADE's scene, the particles, and the state of the run that made it, written
last. All three or no bed."""
import os

from yade import O

from ..files import sealed

SCENE, STATE, BEFORE = 'bed.yade.gz', 'bed.json', 'before.npz'


def save(folder, state):
    """Write the scene, then the `state`; the file with the particles must be there already."""
    O.save(os.path.join(folder, SCENE))
    sealed.write(os.path.join(folder, STATE), state, (SCENE, BEFORE))


def read(folder, part):
    """The state of the finished bed in the `folder`; all its files are complete then.

    :param part: function that picks the bed's own from a complete dict of parameters
    :raises ValueError: there is no bed, a damaged one, or one of a version with other parameters
    """
    if not os.path.exists(os.path.join(folder, STATE)):
        raise ValueError(f'bed = {folder!r}: there is no finished bed in that folder ({STATE})')
    try:
        state = sealed.read(os.path.join(folder, STATE))
        part(state['parameters'])
    except ValueError as error:
        raise ValueError(f'bed = {folder!r}: {error}') from None
    except (KeyError, TypeError) as error:
        raise ValueError(f'bed = {folder!r}: {STATE} is of another version ({type(error).__name__}: {error})') from None
    return state


def load(folder):
    """Make the bed in the `folder` YADE's scene.

    :raises ValueError: it is damaged
    """
    try:
        O.load(os.path.join(folder, SCENE))
    except RuntimeError as error:
        raise ValueError(f'bed = {folder!r}: {SCENE} cannot be loaded ({error})') from None


def requireSame(folder, wanted, own):
    """ValueError if the parameters `wanted` of a bed, a dict, are not its `own`."""
    for name, value in wanted.items():
        if value != own[name]:
            raise ValueError(f'{name} = {value!r}: the bed in {folder!r} was poured with {own[name]!r}')
