"""Material files by name: those that are shipped (`*.yaml` beside this module), or a user's by its path."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from . import materialfile

if TYPE_CHECKING:
    from ..typealiases import PathLike

FOLDER, SUFFIX = os.path.dirname(os.path.abspath(__file__)), '.yaml'


def shipped() -> tuple[str, ...]:
    """Names of the materials that come with the package."""
    return tuple(sorted(name[:-len(SUFFIX)] for name in os.listdir(FOLDER) if name.endswith(SUFFIX)))


def materialAt(name: str, value: Any) -> str:
    """`value` if it is the name of a shipped material, else the absolute path of the material file that it is; ValueError if it is neither."""
    isName = isinstance(value, (str, os.PathLike)) and '\0' not in os.fspath(value)
    if isName and value in shipped():
        return value
    if not isName or not os.path.isfile(value):
        raise ValueError(f'{name} = {value!r}: must be a material file, or one of {", ".join(shipped())}')
    return os.path.abspath(value)


def properties(material: PathLike) -> dict[str, Any]:
    """What the file of a `material` (a shipped name, or a path) says, a dict as of `materialfile.read`.

    :raises ValueError: there is no such file, or something is wrong with it
    """
    known = materialAt('material', material)
    return materialfile.read(os.path.join(FOLDER, known + SUFFIX) if known in shipped() else known)
