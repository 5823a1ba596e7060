"""Snapshots as VTK's PolyData files (.vtp) for ParaView, written and read by VTK's own classes (Debian: python3-vtk9)."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..files import summed
from ..measure import bodyarrays
from ..mesh import surfaces

if TYPE_CHECKING:
    from ..measure.scenesnapshot import SceneSnapshot
    from ..typealiases import ArrayLike, Floats, Ints, PathLike, Rows

MISSING = 'VTK\'s Python modules are missing: install python3-vtk9, or start with tools/env --with view'


def requireVtk() -> None:
    """ImportError that says what to install, where VTK's modules are not there."""
    try:
        import vtkmodules.vtkIOXML  # noqa: F401
    except ImportError:
        raise ImportError(MISSING) from None


def surfaceData(snapshot: SceneSnapshot, detail: float = surfaces.DETAIL, normals: bool = False) -> Any:
    """vtkPolyData of the particles' surfaces; all arrays of `particleArrays` on their points."""
    surface = surfaces.particleSurfaces(snapshot.particles, detail)
    data = polyData(surface.points, polygons=surface.triangles)
    for name, values in particleArrays(snapshot.particles).items():
        _add(data.GetPointData(), name, values[surface.owner])
    if normals:
        _add(data.GetPointData(), 'normals', surface.normals.astype('f4'))
        data.GetPointData().SetActiveNormals('normals')
    return _timed(data, snapshot)


def particleData(snapshot: SceneSnapshot) -> Any:
    """vtkPolyData of one point a particle, with what a glyph needs: halfSizes, and orientation as ParaView's quaternion (w, x, y, z)."""
    rows = snapshot.particles
    data = polyData(rows['position'], vertices=np.arange(len(rows))[:, None])
    glyph = {'halfSizes': rows['extents'].astype('f4'), 'orientation': np.roll(rows['orientation'], 1, axis=1).astype('f4')}
    for name, values in {**glyph, **particleArrays(rows)}.items():
        _add(data.GetPointData(), name, values)
    return _timed(data, snapshot)


def particleArrays(rows: Rows) -> dict[str, NDArray[Any]]:
    """{name: values, one row a particle} of what every file of particles has; SI units, in single precision."""
    stress = rows['stress'].reshape(-1, 9)
    return {'id': rows['id'].astype('i4'), 'kind': rows['kind'].astype('i1'), 'material': rows['material'].astype('i2'),
            'exponents': rows['exponents'].astype('f4'), 'volume': rows['volume'].astype('f4'), 'velocity': rows['velocity'].astype('f4'),
            'angVel': rows['angVel'].astype('f4'), 'stress': stress.astype('f4'), 'pressure': (-stress[:, ::4].sum(axis=1) / 3).astype('f4'),
            'octahedralStress': rows['octahedralStress'].astype('f4'), 'contacts': rows['contacts'].astype('i2')}


def contactData(snapshot: SceneSnapshot) -> Any:
    """vtkPolyData of a line for each contact, from centre to centre; the size of the normal force also on the points, for tubes."""
    rows = snapshot.contacts
    ends = np.stack([rows['centre1'], rows['centre2']], axis=1).reshape(-1, 3)
    data = polyData(ends, lines=np.arange(len(ends)).reshape(-1, 2))
    for name in ('id1', 'id2'):
        _add(data.GetCellData(), name, rows[name].astype('i4'))
    for name, column in (('normalForce', 'normalForce'), ('shearForce', 'shearForce'), ('overlap', 'overlap'), ('contactPoint', 'point')):
        _add(data.GetCellData(), name, rows[column].astype('f4'))
    _add(data.GetPointData(), 'force', np.repeat(np.linalg.norm(rows['normalForce'], axis=1).astype('f4'), 2))
    return _timed(data, snapshot)


def containerData(snapshot: SceneSnapshot) -> Any:
    """vtkPolyData of walls, hollow cylinders and facets, with id and kind on the triangles. What is no facet also stands as numbers in the field
    data `borders`, in the order of the columns of BORDER.
    """
    surface = surfaces.containerSurfaces(snapshot.container, snapshot.box())
    data = polyData(surface.points, polygons=surface.triangles)
    owner = surface.owner[surface.triangles[:, 0]]
    _add(data.GetCellData(), 'id', snapshot.container['id'][owner].astype('i4'))
    _add(data.GetCellData(), 'kind', snapshot.container['kind'][owner].astype('i1'))
    rest = snapshot.container[snapshot.container['kind'] != bodyarrays.FACET]
    _add(data.GetFieldData(), 'borders', np.column_stack([rest[name] for name in bodyarrays.BORDER.names or ()]))
    return _timed(data, snapshot)


def polyData(points: ArrayLike, **cells: Ints) -> Any:
    """vtkPolyData of points (N, 3) and `cells`, one of vertices, lines, polygons: places of the points, (M, corners)."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    data, place = vtkPolyData(), vtkPoints()
    place.SetData(_vtkArray(np.asarray(points, dtype='f4')))
    data.SetPoints(place)
    (kind, corners), = cells.items()
    {'vertices': data.SetVerts, 'lines': data.SetLines, 'polygons': data.SetPolys}[kind](_cellArray(corners))
    return data


def _cellArray(corners: Ints) -> Any:
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    result, (number, size) = vtkCellArray(), np.shape(corners)
    result.SetData(_vtkArray(size * np.arange(number + 1, dtype='i4')), _vtkArray(np.asarray(corners, dtype='i4').ravel()))
    return result


def _vtkArray(values: ArrayLike) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    return numpy_to_vtk(np.ascontiguousarray(values), deep=True)


def _add(attributes: Any, name: str, values: ArrayLike) -> None:
    array = _vtkArray(values)
    array.SetName(name)
    attributes.AddArray(array)


def _timed(data: Any, snapshot: SceneSnapshot) -> Any:
    """The data with the snapshot's time and step, as ParaView reads them."""
    _add(data.GetFieldData(), 'TimeValue', np.array([snapshot.time]))
    _add(data.GetFieldData(), 'step', np.array([snapshot.step], dtype='i8'))
    return data


def write(path: PathLike, data: Any) -> None:
    """Write PolyData, compressed; the file takes the place of `path` only when it is complete.

    :raises OSError: it could not be written
    """
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    writer, partial = vtkXMLPolyDataWriter(), f'{path}.part'
    writer.SetFileName(partial)
    writer.SetInputData(data)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()  # raw bytes
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(1)   # higher ones take three times as long for a tenth less
    if not writer.Write() or writer.GetErrorCode():
        raise OSError(f'{path}: VTK could not write it (error {writer.GetErrorCode()}); is the disk full?')
    summed.sealFile(partial)
    os.replace(partial, path)


def read(path: PathLike) -> Any:
    """vtkPolyData of a .vtp file.

    :raises ValueError: there is none, or one that is not as `write` left it
    """
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    if not os.path.exists(path):
        raise ValueError(f'{path}: there is no such file')
    whole = summed.intact(path)
    reader, errors = vtkXMLPolyDataReader(), []
    reader.AddObserver('ErrorEvent', lambda *_: errors.append(1))
    reader.SetFileName(path)
    vtkObject.GlobalWarningDisplayOff()
    try:
        if whole:
            reader.Update()
    finally:
        vtkObject.GlobalWarningDisplayOn()
    if not whole or errors or reader.GetErrorCode():
        raise ValueError(f'{path}: is damaged, or another program\'s')
    return reader.GetOutput()


def arrays(attributes: Any) -> dict[str, NDArray[Any]]:
    """{name: numpy array} of the point, cell or field data of PolyData."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i)) for i in range(attributes.GetNumberOfArrays())}


def points(data: Any) -> Floats:
    """Points (N, 3) of PolyData [m]."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))


def triangles(data: Any) -> Ints:
    """Corners (M, 3) of PolyData of triangles, as places of its points."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
