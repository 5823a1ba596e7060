"""A recorded series (`vtkRecorder`) read back as snapshots, for pictures and for measures."""
from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from copy import copy
from typing import TYPE_CHECKING, Any

import numpy as np

from ..measure import bodyarrays
from ..measure.scenesnapshot import SceneSnapshot
from . import polydata
from .series import Entry, Series

if TYPE_CHECKING:
    from ..typealiases import Rows


class RecordedSeries(Sequence[SceneSnapshot]):
    """The series in `folder`: a sequence of `SceneSnapshot`, each read when it is asked for, in the single precision of the files. A slice
    is such a series.

    :raises ValueError: there is none, or a file is missing, damaged or another program's
    """

    def __init__(self, folder: str) -> None:
        self.folder = folder
        self.moments = Series(folder, 'particles').entries()
        if not self.moments:
            raise ValueError(f'folder = {folder!r}: there is no recorded series (particles.pvd)')
        self._files = {name: {entry.step: entry.file for entry in Series(folder, name).entries()} for name in ('contacts', 'container')}

    def __len__(self) -> int:
        return len(self.moments)

    def __getitem__(self, place: Any) -> Any:
        if isinstance(place, slice):
            part = copy(self)
            part.moments = self.moments[place]
            return part
        moment = self.moments[place]
        return SceneSnapshot(self._read(moment.file, moment, _particles), self._optional('contacts', moment, _contacts),
                     self._optional('container', moment, _container), moment.step, moment.time)

    def _read(self, file: str, moment: Entry, convert: Callable[[Any], Rows]) -> Rows:
        path = os.path.join(self.folder, file)
        data = polydata.read(path)
        try:
            own = polydata.arrays(data.GetFieldData())
            if (own['step'][0], own['TimeValue'][0]) != (moment.step, moment.time):
                raise ValueError(f'it is of step {own["step"][0]}')
            return convert(data)
        except (AttributeError, KeyError, IndexError, ValueError) as error:
            raise ValueError(f'{path}: is another program\'s, or of another version ({type(error).__name__}: {error})') from None

    def _optional(self, name: str, moment: Entry, convert: Callable[[Any], Rows]) -> Rows | None:
        file = self._files[name].get(moment.step)
        return None if file is None else self._read(file, moment, convert)


def _particles(data: Any) -> Rows:
    values = polydata.arrays(data.GetPointData())
    rows = np.zeros(data.GetNumberOfPoints(), bodyarrays.PARTICLE)
    rows['position'] = polydata.points(data)
    rows['extents'], rows['orientation'] = values['halfSizes'], np.roll(values['orientation'], -1, axis=1)
    rows['stress'] = values['stress'].reshape(-1, 3, 3)
    for name in ('id', 'kind', 'material', 'contacts', 'exponents', 'velocity', 'angVel', 'volume', 'octahedralStress'):
        rows[name] = values[name]
    return rows


def _contacts(data: Any) -> Rows:
    values, ends = polydata.arrays(data.GetCellData()), polydata.points(data).reshape(-1, 2, 3)
    rows = np.zeros(len(ends), bodyarrays.CONTACT)
    rows['centre1'], rows['centre2'], rows['point'] = ends[:, 0], ends[:, 1], values['contactPoint']
    for name in ('id1', 'id2', 'normalForce', 'shearForce', 'overlap'):
        rows[name] = values[name]
    return rows


def _container(data: Any) -> Rows:
    numbers = polydata.arrays(data.GetFieldData())['borders'].reshape(-1, 18)
    rest = np.zeros(len(numbers), bodyarrays.BORDER)
    rest['id'], rest['kind'] = numbers[:, 0], numbers[:, 1]
    rest['position'], rest['orientation'], rest['numbers'] = numbers[:, 2:5], numbers[:, 5:9], numbers[:, 9:]
    cells, corners = polydata.arrays(data.GetCellData()), polydata.triangles(data)
    isFacet = cells['kind'] == bodyarrays.FACET
    facets = np.zeros(np.count_nonzero(isFacet), bodyarrays.BORDER)
    facets['id'], facets['kind'] = cells['id'][isFacet], bodyarrays.FACET
    facets['numbers'] = polydata.points(data)[corners[isFacet]].reshape(-1, 9)
    return np.concatenate([rest, facets])
