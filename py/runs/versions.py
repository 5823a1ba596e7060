"""The versions of what takes part in a computation."""
from __future__ import annotations

import platform

import numpy
from yade import config

from ..version import __version__


def versions() -> dict[str, str]:
    """{name: version} of YADE, this package, Python and numpy."""
    return {'yade': config.version, 'yade-superquadric': __version__, 'python': platform.python_version(),
            'numpy': numpy.__version__}
