"""The command line that all scripts of one run share: where the results go, how an interrupted run goes on, the run's parameters."""
from __future__ import annotations

import argparse
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from .parameters import Parameters, fromFile, given

if TYPE_CHECKING:
    from .staged import StagedRun

BAD_INPUT, INTERRUPTED = 2, 130  # exit codes


def parser(script: str, description: str, output: str | None, outputHelp: str = '') -> argparse.ArgumentParser:
    """The options that do not belong to the experiment. The script adds its own, and the parameters by `parameters.addOptions`.

    :param script: its name, scripts/NAME.py; :param description: its docstring
    :param output: folder for the results by default; :param outputHelp: what to say of it instead of its name
    """
    result = argparse.ArgumentParser(prog=f'yade -n -x {script}', description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('--output', metavar='FOLDER', default=output, help=f'folder for the results (default: {outputHelp or "%(default)s"})')
    result.add_argument('--resume', action='store_true', help='go on with the interrupted run in that folder; '
                        'parameters are those it was started with')
    result.add_argument('--takeUp', action='store_true', help='the same where the folder holds an interrupted run; else begin one')
    result.add_argument('--noPictures', action='store_true', help='draw none')
    result.add_argument('--parameters', metavar='FILE', help='JSON file {name: value} of parameters; options override it')
    result.add_argument('--quiet', action='store_true', help='no progress')
    return result


def resumes(options: argparse.Namespace, experiment: type[StagedRun[Any, Any]], output: str) -> bool:
    """Whether the run in the folder `output` is to be taken up. `experiment`: the class of the run."""
    return bool(options.resume or (options.takeUp and experiment.isInterrupted(output)))


def parametersOf(options: argparse.Namespace, kind: type[Parameters], table: Mapping[str, Any] = MappingProxyType({})) -> dict[str, Any]:
    """{name: value} of those parameters that file, batch table and command line give, the last one first in rank."""
    sources = fromFile(options.parameters), table, given(options, kind)
    return {name: value for source in sources for name, value in kind.byPresentNames(source).items()}
