"""Names of version 0.1 that were changed: they warn, give what they are called now, and go with the next release."""
from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Mapping
from typing import Any


def oldNames(module: str, names: Mapping[str, str]) -> Callable[[str], Any]:
    """The function `__getattr__` of a `module` whose `names` were changed, {old: new}."""
    def attribute(name: str) -> Any:
        if name not in names:
            raise AttributeError(f'module {module!r} has no attribute {name!r}')
        warnings.warn(f'{module}.{name} is called {names[name]}; the old name goes with the next release', DeprecationWarning, stacklevel=2)
        return getattr(sys.modules[module], names[name])
    return attribute
