"""Bodies and contacts of the scene as numpy arrays, gathered in C++ in one pass (`BodyArrays`): no loop over bodies in Python."""
import numpy as np

from yade.wrapper import BodyArrays

from ..scene.bodies import numbers

SPHERE, SUPERQUADRIC, WALL, CYLINDER, FACET = range(5)  # kinds of shapes

# The rows of pkg/python/BodyArrays.hpp. SI units; vectors along the scene's axes; a quaternion is (x, y, z, w).
PARTICLE = np.dtype([
    ('id', 'i8'), ('kind', 'i8'), ('material', 'i8'), ('contacts', 'i8'), ('extents', 'f8', 3), ('exponents', 'f8', 2), ('position', 'f8', 3),
    ('orientation', 'f8', 4), ('velocity', 'f8', 3), ('spin', 'f8', 3), ('volume', 'f8'), ('stress', 'f8', (3, 3)), ('octahedralStress', 'f8')])
CONTACT = np.dtype([
    ('id1', 'i8'), ('id2', 'i8'), ('centre1', 'f8', 3), ('centre2', 'f8', 3), ('point', 'f8', 3), ('normalForce', 'f8', 3),
    ('shearForce', 'f8', 3), ('overlap', 'f8')])
BORDER = np.dtype([('id', 'i8'), ('kind', 'i8'), ('position', 'f8', 3), ('orientation', 'f8', 4), ('numbers', 'f8', 9)])


def particles(ids=None):
    """Spheres and superquadrics among the bodies `ids`, in that order; None: all, in the order of their ids. Rows of PARTICLE.

    id; kind: SPHERE or SUPERQUADRIC; material: its id; contacts: how many push; extents: half sizes [m]; exponents: (n1, n2); position [m],
    in a periodic scene inside the cell; orientation: body to scene; velocity [m/s]; spin [rad/s]; volume [m3]; stress: mean stress [Pa],
    sum over the contacts of lever times force over the volume, tension positive; octahedralStress: its octahedral shear stress [Pa].

    :raises ValueError: a body that is not in the scene
    """
    return np.frombuffer(BodyArrays().particles(ids if ids is None else numbers('ids', ids)), PARTICLE)


def contacts():
    """All real contacts in the order of their ids; rows of CONTACT.

    id1, id2; centre1, centre2: the particles' centres [m], of a wall instead the contact point, in a periodic scene of the image that touches;
    point: of contact [m]; normalForce, shearForce: on body 2 [N]; overlap [m].
    """
    return np.frombuffer(BodyArrays().contacts(), CONTACT)


def container():
    """Walls, hollow cylinders and facets in the order of their ids; rows of BORDER.

    kind: WALL, CYLINDER or FACET; numbers: of a Wall (axis, sense), of a HollowCylinder (radius, height) [m], of a Facet its three vertices in
    the scene [m].
    """
    return np.frombuffer(BodyArrays().container(), BORDER)


def matrices(quaternions):
    """Rotation matrices (N, 3, 3) of unit quaternions (N, 4) as (x, y, z, w)."""
    x, y, z, w = np.moveaxis(np.asarray(quaternions, dtype=float), -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))
