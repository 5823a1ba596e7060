"""A recorder for ParaView: an engine that writes the scene as compressed .vtp files with a .pvd time series (docs/view.md)."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from yade import O
from yade.wrapper import PyRunner

from .. import checks
from ..measure.scenesnapshot import SceneSnapshot
from ..mesh.surfaces import DETAIL
from ..scene.bodies import present
from . import polydata
from .series import Series

if TYPE_CHECKING:
    from ..typealiases import PathLike

SERIES = ('particles', 'surfaces', 'contacts', 'container')
PERIODS = ('iterPeriod', 'virtPeriod', 'realPeriod')


def vtkRecorder(folder: PathLike, iterPeriod: int | None = None, virtPeriod: float | None = None, realPeriod: float | None = None,
                surfaces: bool = True, contacts: bool = True, container: bool = True,
                detail: float = DETAIL, normals: bool = False, ids: Sequence[int] | None = None, initRun: bool = True, label: str = '') -> PyRunner:
    """An engine for the end of `O.engines` that writes, as often as the period says, into `folder`:

    particles.pvd: a point for each particle with all its data; surfaces.pvd: their surfaces with the same; contacts.pvd: a line from centre to centre
    for every contact; container.pvd: walls, hollow cylinders, facets. docs/view.md lists the arrays.

    After NewtonIntegrator, positions and velocities are those at the end of the step, contacts and stresses those at its beginning, which O.time
    names. The engine is saved with the scene and goes on after O.load: it is a PyRunner whose command holds all that is given here, and
    what it has written so far stands in the .pvd files. Moments after the loaded one go from there and are written again.

    :param folder: for the files, as seen from the working directory of the run; made if need be
    :param iterPeriod: steps, virtPeriod: simulated seconds, realPeriod: seconds of the clock between two moments; one of them at least
    :param surfaces, contacts, container: whether to write them; very large beds do without surfaces, ParaView draws the points as glyphs
    :param detail: of surfaces: largest distance between a particle's surface and its triangles, over its largest half size
    :param normals: write the surfaces' normals: they look smoother, and the files are twice as large
    :param ids: only these bodies, and the contacts that they have a part in; None: all. Those that have broken or were erased are left out
    :param initRun: also write the first step
    :param label: of the engine
    :raises ValueError: a value out of range; ImportError: VTK's Python modules are missing; OSError: the folder cannot be written to
    """
    periods = _checkPeriods(iterPeriod, virtPeriod, realPeriod)
    what: dict[str, Any] = {name: checks.boolean(name, value) for name, value in (
        ('surfaces', surfaces), ('contacts', contacts), ('container', container), ('normals', normals))}
    what['detail'] = checks.above('detail', detail, 0, 1)
    what['ids'] = None if ids is None else present('ids', ids)
    initRun, label = checks.boolean('initRun', initRun), checks.text('label', label)
    if not isinstance(folder, (str, os.PathLike)) or not checks.path('folder', folder):
        raise ValueError(f'folder = {folder!r}: must be the path of a folder')
    folder = checks.path('folder', folder)
    polydata.requireVtk()
    _series(folder, what)
    os.makedirs(folder, exist_ok=True)
    if not os.access(folder, os.W_OK):
        raise PermissionError(f'folder = {folder!r}: cannot be written to')
    arguments = ', '.join(f'{name}={value!r}' for name, value in what.items())
    command = f"__import__('{__name__}', fromlist=['record']).record({folder!r}, {arguments})"
    return PyRunner(command=command, updateGlobals=False, initRun=initRun, label=label, **periods)


def record(folder: PathLike, surfaces: bool = True, contacts: bool = True, container: bool = True, detail: float = DETAIL, normals: bool = False,
           ids: Sequence[int] | None = None) -> None:
    """Add the present moment to the series in `folder`; what `vtkRecorder` calls, with its arguments."""
    snapshot = SceneSnapshot.ofScene(None if ids is None else [i for i in ids if i < len(O.bodies) and O.bodies[i] is not None])
    data: dict[str, Callable[[], Any]] = {
        'particles': lambda: polydata.particleData(snapshot), 'surfaces': lambda: polydata.surfaceData(snapshot, detail, normals),
        'contacts': lambda: polydata.contactData(snapshot), 'container': lambda: polydata.containerData(snapshot)}
    for series in _series(folder, {'surfaces': surfaces, 'contacts': contacts, 'container': container}):
        series.append(snapshot.step, snapshot.time, _writer(data[series.name]))


def _writer(make: Callable[[], Any]) -> Callable[[str], None]:
    return lambda path: polydata.write(path, make())


def _series(folder: PathLike, wanted: Mapping[str, Any]) -> list[Series]:
    """The `Series` that are `wanted` ({name: bool}), particles always.

    :raises ValueError: one of them cannot be gone on with, and none has been changed
    """
    chosen = [Series(folder, name) for name in SERIES if wanted.get(name, True)]
    for series in chosen:
        series.entries()
    return chosen


def remove(folder: str) -> None:
    """Remove the series that `vtkRecorder` wrote into the folder, and the folder if nothing else is in it."""
    for name in SERIES:
        Series(folder, name).remove()
    with suppress(OSError):  # it is not there, or something else is in it
        os.rmdir(folder)


def _checkPeriods(iterPeriod: Any, virtPeriod: Any, realPeriod: Any) -> dict[str, float]:
    """{name: value} of the periods that are given.

    :raises ValueError: none is, or one is not positive
    """
    given = {name: value for name, value in zip(PERIODS, (iterPeriod, virtPeriod, realPeriod)) if value is not None}
    if not given:
        raise ValueError(f'iterPeriod = None: one of {", ".join(PERIODS)} is needed')
    return {name: checks.wholeNumber(name, value, 1, checks.STEPS) if name == 'iterPeriod' else checks.positive(name, value)
            for name, value in given.items()}
