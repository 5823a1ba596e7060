"""The same bed crushed by several modes of breakage, and what differs: a table and the pictures of all together."""
from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TextIO

from ...files import results
from ...runs import checkpoint, finishedbed
from ...runs.filenames import SUMMARY
from ...runs.parameters import BED as BED_SCOPE
from . import case, plots
from .parameters import MODES, OedometerParameters
from .run import OedometerRun

BED = 'bed'  # folder of the bed, in that of the comparison
PICTURES = ('grading.png', 'stress.png', 'contacts.png')
TABLE = 'comparison.json'


def modesOf(text: str) -> list[str]:
    """Modes from a comma-separated list; ValueError for an unknown one, or for none."""
    modes = [mode.strip() for mode in text.split(',') if mode.strip()]
    for mode in modes:
        if mode not in MODES:
            raise ValueError(f'modes = {text!r}: {mode!r} is none of {", ".join(MODES)}')
    if not modes or len(set(modes)) < len(modes):
        raise ValueError(f'modes = {text!r}: at least one is needed, and each once')
    return modes


def compare(modes: Sequence[str], parameters: Mapping[str, Any], output: str, stream: TextIO | None = sys.stderr,
            pictures: bool = True) -> dict[str, dict[str, Any]]:
    """Crush one bed by every one of the `modes`, each in a folder of its own in `output`; write table and pictures.

    What is finished with the same parameters is taken as it is, what was interrupted is taken up: the same call goes on after Ctrl-C.

    :returns: {mode: summary}
    :raises ValueError: a bad parameter, before anything changes; :raises Interrupted: after Ctrl-C
    """
    wanted = {mode: OedometerParameters.checked({**parameters, 'mode': mode}) for mode in modes}
    bed = os.path.join(output, BED)
    if not _bedIsThere(bed, wanted[modes[0]]):
        _start(bed, stream, lambda: OedometerRun.begin(wanted[modes[0]].asDict(), bed, stream)).run(until=OedometerRun.AFTER_BED)
    summaries = {}
    for mode in modes:
        folder = os.path.join(output, mode)
        summaries[mode] = _finished(folder, wanted[mode]) or _crush(bed, wanted[mode], folder, stream, pictures)
    results.writeJson(os.path.join(output, TABLE), {mode: _row(summary) for mode, summary in summaries.items()})
    if pictures:
        draw(output, modes)
    return summaries


def draw(output: str, modes: Sequence[str]) -> None:
    """The pictures of all `modes` together, from their folders in `output`."""
    cases = [case.load(os.path.join(output, mode)) for mode in modes]
    for name, picture in zip(PICTURES, (plots.gradings, plots.stresses, plots.contacts)):
        picture(os.path.join(output, name), cases)


def _bedIsThere(folder: str, parameters: OedometerParameters) -> bool:
    if not finishedbed.exists(folder):
        return False
    own, _ = finishedbed.read(folder, OedometerRun.decoded)
    finishedbed.requireSame(folder, parameters.part(BED_SCOPE), own.part(BED_SCOPE))
    return True


def _crush(bed: str, parameters: OedometerParameters, folder: str, stream: TextIO | None, pictures: bool) -> dict[str, Any]:
    """The summary of a test on the bed in the folder `bed`."""
    run = _start(folder, stream, lambda: OedometerRun.onBed(bed, parameters.asDict(), folder, stream))
    run.pictures = pictures
    summary = run.run()
    assert summary is not None
    return summary


def _start(folder: str, stream: TextIO | None, begin: Callable[[], OedometerRun]) -> OedometerRun:
    """The run of a folder: taken up where it was interrupted, else begun."""
    return OedometerRun.resume(folder, stream) if checkpoint.exists(folder) else begin()


def _finished(folder: str, parameters: OedometerParameters) -> dict[str, Any] | None:
    """The summary in a folder if it is that of the `parameters`; None otherwise."""
    path = os.path.join(folder, SUMMARY)
    if not os.path.exists(path):
        return None
    summary = results.readJson(path)
    return dict(summary) if summary['parameters'] == parameters.asDict() else None


def _row(summary: Mapping[str, Any]) -> dict[str, Any]:
    """What the modes are compared by."""
    curves, contacts = summary['grading'], summary['contacts']['after']
    return {'stress': summary['compression']['stress'], 'strain': summary['compression']['strain'], 'events': summary['particles']['broken'],
            'particles': summary['particles']['number'], 'hardin': curves['hardin'], 'einav': curves['einav'], 'fractal': curves['fractal'],
            'widestGap': curves['after']['widestGap'], 'steepestPart': curves['after']['steepestPart'],
            'fragmentsWidestGap': curves['fragments'] and curves['fragments']['widestGap'],
            'fragmentsSteepestPart': curves['fragments'] and curves['fragments']['steepestPart'],
            **{name: contacts[name] for name in ('rattlerShare', 'meanNumber', 'meanNumberWithoutRattlers', 'forceSpread',
                                                 'forceSpreadWithoutRattlers')}}


def text(summaries: Mapping[str, Mapping[str, Any]]) -> str:
    """The comparison as a table, one line a mode."""
    lines = [f'{"mode":8} {"stress":>8} {"strain":>7} {"events":>7} {"particles":>9} {"B_r":>7} {"gap":>6} {"of fragments":>12} {"rattlers":>8} '
             f'{"contacts":>8}',
             f'{"":8} {"MPa":>8} {"%":>7} {"":>7} {"":>9} {"":>7} {"ratio":>6} {"ratio":>12} {"%":>8} {"carrying":>8}']
    for mode, summary in summaries.items():
        row = _row(summary)
        gap = row['fragmentsWidestGap']
        fragments = f'{gap["factor"]:.3f}' if gap else '-'
        lines.append(f'{mode:8} {1e-6 * row["stress"]:8.3f} {100 * row["strain"]:7.2f} {row["events"]:7} {row["particles"]:9} {row["hardin"]:7.4f} '
                     f'{row["widestGap"]["factor"]:6.3f} {fragments:>12} {100 * row["rattlerShare"]:8.1f} '
                     f'{row["meanNumberWithoutRattlers"]:8.2f}')
    return '\n'.join(lines)
