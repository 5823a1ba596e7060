"""Pictures with matplotlib, without a display: the force over time."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...files.wholefile import ReplacingBytes
from .pulse import Pulse

Record = tuple[Sequence[float], Sequence[float]]  # times and forces


def forcePicture(path: str, record: Record, pulse: Pulse, staticForce: float, bare: Record | None = None, title: str = '') -> None:
    """Force on the base over time, as PNG.

    :param record: (times [s], forces [N]) with the bed, times from the start of the record
    :param pulse: `Pulse` of the same; :param staticForce: what the base bore before [N]
    :param bare: (times, forces) of the impact on the bare base, moved in time to the first touch
    """
    figure, axes = _figure(8, 4.8)
    times, forces = 1e3 * np.asarray(record[0]), 1e-3 * (np.asarray(record[1]) - staticForce)
    start, end = 1e3 * pulse.start, 1e3 * pulse.end
    axes.axvspan(start, end, color='#f6e9d0', lw=0, zorder=0, label=f'duration {end - start:.2f} ms')
    if bare is not None:
        bareForces = 1e-3 * np.asarray(bare[1])
        shifted = 1e3 * np.asarray(bare[0]) + start
        touching = np.flatnonzero(bareForces > 0)
        shifted -= shifted[touching[0]] - start if len(touching) else 0
        keep = slice(max(touching[0] - 1, 0), touching[-1] + 2) if len(touching) else slice(0)
        axes.plot(shifted[keep], bareForces[keep], color='#888888', lw=1.2,
                  label=f'without a bed, $P_0$ = {bareForces.max():.2f} kN')
    axes.plot(times, forces, color='#b03a2e', lw=1.6, label='with the bed')
    peakTime, peak = 1e3 * pulse.peakTime, 1e-3 * pulse.peak
    axes.plot([peakTime], [peak], 'o', color='#b03a2e', ms=5)
    axes.annotate(f'$P$ = {peak:.3f} kN', (peakTime, peak), xytext=(8, 4), textcoords='offset points', color='#b03a2e')
    axes.axhline(0, color='black', lw=0.6)
    axes.set(xlabel='time [ms]', ylabel='force on the base, less the bed\'s weight on it [kN]', title=title,
             xlim=(max(times[0], start - 0.5 * (end - start)), min(times[-1], end + 2 * (end - start))))
    axes.legend(loc='upper right', framealpha=1, edgecolor='white')
    axes.spines[['top', 'right']].set_visible(False)
    _save(figure, path)


def _figure(width: float, height: float) -> tuple[Any, Any]:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    figure = Figure(figsize=(width, height), layout='constrained')
    FigureCanvasAgg(figure)
    return figure, figure.subplots()


def _save(figure: Any, path: str) -> None:
    with ReplacingBytes(path) as file:
        figure.savefig(file, format='png', dpi=150, metadata={'Software': None})
