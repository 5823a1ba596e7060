"""The Python package without YADE: py/ as `yade.superquadric`, under a package `yade` in which there is nothing else.

    python3 tests/support/plainpackage.py SCRIPT [ARGUMENT]...    a script with this package where there is no YADE
"""
import importlib.util
import os
import sys
from types import ModuleType

from project import PROJECT

NAME = 'yade.superquadric'


def provide():
    """Make `yade.superquadric` importable from this checkout; what needs more of YADE raises ImportError. An installed YADE is hidden."""
    forget()
    yade = ModuleType('yade')
    yade.__path__ = []  # a package, in which nothing is found
    spec = importlib.util.spec_from_file_location(NAME, PROJECT / 'py' / '__init__.py', submodule_search_locations=[str(PROJECT / 'py')])
    yade.superquadric = importlib.util.module_from_spec(spec)
    sys.modules.update({'yade': yade, NAME: yade.superquadric})
    spec.loader.exec_module(yade.superquadric)


def forget():
    """Forget all modules of `yade`, so that the next import loads them anew."""
    for name in [name for name in sys.modules if name.partition('.')[0] == 'yade']:
        del sys.modules[name]


def provideWhereMissing():
    """As `provide` where there is no YADE; else nothing, and YADE's own `yade.superquadric` serves."""
    if importlib.util.find_spec('yade') is None:
        provide()


def environment():
    """Of a program that is to find the same `yade` as this one, if there is one."""
    import yade
    folder = {} if getattr(yade, '__file__', None) is None else {'PYTHONPATH': os.path.dirname(os.path.dirname(yade.__file__))}
    return {**os.environ, **folder}


if __name__ == '__main__':
    del sys.argv[0]
    provideWhereMissing()
    # Not runpy: YADE's C++ looks into __main__, which must stay the real one.
    with open(sys.argv[0], encoding='utf-8') as script:
        exec(compile(script.read(), sys.argv[0], 'exec'))
