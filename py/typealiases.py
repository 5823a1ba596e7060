"""Types that annotations name: paths, and numpy's arrays by what they hold. Shapes and units are told by the docstrings."""
from __future__ import annotations

import os
from typing import Any, TypeAlias

from numpy.typing import ArrayLike, NDArray

PathLike: TypeAlias = str | os.PathLike[str]

Floats: TypeAlias = NDArray[Any]  # of floats
Ints: TypeAlias = NDArray[Any]    # of whole numbers
Bools: TypeAlias = NDArray[Any]   # of True and False
Rows: TypeAlias = NDArray[Any]    # structured: rows of `measure.bodyarrays`

__all__ = ['ArrayLike', 'Bools', 'Floats', 'Ints', 'PathLike', 'Rows']
