"""One body at its contact as finite elements of getfem: quadratic displacement, axisymmetric small strain, plasticity at the integration points.

Elements are quadrangles of eight nodes with 2 x 2 integration points, the usual choice for plastic flow without change of volume (no
locking), and a fan of quadratic triangles about the point of contact. The far end is held.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import getfem
import numpy
from scipy import sparse

from . import mesh as meshes

if TYPE_CHECKING:
    from ..typealiases import Floats, Ints
    from .returnmapping import Material, State

STRAIN = '[Grad_{0}(1,1), Grad_{0}(2,2), {0}(1)/X(1), Grad_{0}(1,2) + Grad_{0}(2,1)]'   # rr, zz, tt, rz
ON_RING = 1e-9   # of the distance from the contact point: nodes of the mesh are where they were put, up to rounding

getfem.util_trace_level(0)


class Body:
    """A sphere (or, with radius infinity, a plate) with its state.

    Displacements are vectors of all degrees of freedom [m]; their second component points into the body, away from the contact.

    :param radius: [m]
    :param surface: r of the rings [m], (m,)
    :param material: returnmapping.Material
    :ivar size, free: number of degrees of freedom; indices of those that are not held
    :ivar normals: indices of the normal ones on the surface, from the axis outwards: corner, middle, corner, ... (2 m + 1,)
    :ivar elastic: stiffness without plasticity [N/m], sparse
    :ivar state: returnmapping.State at the last accepted load
    """

    def __init__(self, radius: float, surface: Floats, sectors: int, material: Material) -> None:
        self.radius, self.surface, self.material = radius, surface, material
        self._build(*meshes.nodes(radius, surface, sectors))
        self._places = self._fem.basic_dof_nodes()
        self.size = self._fem.nbdof()
        self.free = self._freeDegrees()
        self.normals = self._surfaceDegrees()
        self.state = material.virgin(self._data.nbpts())
        self.elastic = self.internal(numpy.zeros(self.size))[1]

    def _build(self, r: Floats, z: Floats) -> None:
        mesh = getfem.Mesh('empty', 2)
        rings, lines = r.shape
        for j in range(lines - 1):
            mesh.add_convex(getfem.GeoTrans('GT_PK(2,1)'), [[0, r[0, j], r[0, j + 1]], [0, z[0, j], z[0, j + 1]]])
        triangles = mesh.cvid()
        for i in range(rings - 1):
            for j in range(lines - 1):
                corners = (slice(i, i + 2), slice(j, j + 2))
                mesh.add_convex(getfem.GeoTrans('GT_QK(2,1)'), [r[corners].T.ravel(), z[corners].T.ravel()])
        quadrangles = numpy.setdiff1d(mesh.cvid(), triangles)
        self._fem, self._integration = getfem.MeshFem(mesh, 2), getfem.MeshIm(mesh)
        for elements, fem, points in ((triangles, 'FEM_PK(2,2)', 'IM_TRIANGLE(2)'),
                                      (quadrangles, 'FEM_Q2_INCOMPLETE(2)', 'IM_GAUSS_PARALLELEPIPED(2,3)')):
            self._fem.set_fem(getfem.Fem(fem), elements)
            self._integration.set_integ(getfem.Integ(points), elements)
        self._data = getfem.MeshImData(self._integration, -1, 4)
        self._model = getfem.Model('real')
        self._model.add_fem_variable('u', self._fem)
        self._model.add_im_data('stress', self._data)
        self._model.add_im_data('tangent', getfem.MeshImData(self._integration, -1, [4, 4]))

    def _freeDegrees(self) -> Ints:
        """Degrees of freedom that are not held: all but those of the far end, and the radial ones on the axis."""
        r, z = self._places
        component = numpy.arange(self.size) % 2
        last = self.surface[-1]
        far = numpy.hypot(last, meshes.depth(self.radius, last))
        # The middle nodes of the far end's straight edges lie a little inside it.
        lastButOne = numpy.hypot(self.surface[-2], meshes.depth(self.radius, self.surface[-2]))
        held = numpy.hypot(r, z) > far - 0.2 * (far - lastButOne)
        return numpy.nonzero(~(held | ((component == 0) & (r < ON_RING * far))))[0]

    def _surfaceDegrees(self) -> Ints:
        """Normal degrees of freedom on the surface, from the axis outwards: corner, middle, corner, ... (2 m + 1,)."""
        corners = numpy.concatenate(([0], self.surface))
        r = numpy.empty(2 * len(corners) - 1)
        r[::2], r[1::2] = corners, (corners[1:] + corners[:-1]) / 2
        z = numpy.empty_like(r)
        z[::2] = meshes.depth(self.radius, corners)
        z[1::2] = (z[2::2] + z[:-2:2]) / 2
        places = self._places[:, 1::2]
        found = []
        for point in zip(r, z):
            distances = numpy.hypot(places[0] - point[0], places[1] - point[1])
            found.append(numpy.argmin(distances))
            assert distances[found[-1]] <= ON_RING * max(point[0], self.surface[0])
        return 2 * numpy.array(found) + 1

    def strain(self, displacement: Floats) -> Floats:
        """Strain rows (points, 4) at the integration points."""
        self._model.set_variable('u', displacement)
        return self._model.interpolation(STRAIN.format('u'), self._data).reshape(-1, 4)

    def internal(self, displacement: Floats) -> tuple[Floats, Any, State]:
        """Internal forces [N] (size,), their derivative [N/m] (sparse), and the State that `displacement` would lead to."""
        stress, tangent, state = self.material.respond(self.strain(displacement), self.state)
        self._model.set_variable('stress', stress.ravel())
        self._model.set_variable('tangent', tangent.ravel())
        test, unknown = STRAIN.format('Test_u'), STRAIN.format('u')
        forces = getfem.asm_generic(self._integration, 1, f'2*pi*X(1)*stress.{test}', -1, self._model)
        matrix = getfem.asm_generic(self._integration, 2, f'2*pi*X(1)*(tangent*{unknown}).{test}', -1, self._model)
        matrix.to_csc()
        columns, rows = matrix.csc_ind()
        return forces, sparse.csc_matrix((matrix.csc_val(), rows, columns), shape=(self.size, self.size)), state
