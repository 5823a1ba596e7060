"""The Python package without YADE: py/ as `yade.superquadric`, under a package `yade` in which there is nothing else.

    python3 tests/support/plainpackage.py SCRIPT [ARGUMENT]...    a script with this package where there is no YADE
"""
import importlib.util
import runpy
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


if __name__ == '__main__':
    del sys.argv[0]
    provideWhereMissing()
    runpy.run_path(sys.argv[0], run_name='__main__')
