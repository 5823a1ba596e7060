"""numpy's files of several arrays (.npz), read so that damage is noticed."""
from __future__ import annotations

import struct
import zipfile
import zlib
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ..typealiases import PathLike

# What numpy and zipfile raise where a file is not what numpy wrote; OSError: a place outside of the file is looked for.
DAMAGE = (ValueError, TypeError, LookupError, EOFError, AttributeError, MemoryError, RuntimeError, SyntaxError, OverflowError, OSError, struct.error,
          zipfile.BadZipFile, zlib.error)


def read(path: PathLike, names: Iterable[str]) -> dict[str, NDArray[Any]]:
    """{name: array} of the file.

    :raises ValueError: naming the file, which holds something else; OSError: it cannot be opened
    """
    with open(path, 'rb') as file:
        try:
            with np.load(file) as stored:
                if stored.zip.testzip() is not None:  # numpy reads no farther than a damaged header says, and so past no sum
                    raise ValueError('wrong sum')
                return {name: stored[name] for name in names}
        except DAMAGE as error:
            raise ValueError(f'{path}: damaged ({type(error).__name__}: {error})') from None
