"""Bodies and contacts of the scene as rows of `bodyarrays`, gathered in C++ in one pass (`BodyArrays`): no loop over bodies in Python."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from yade.wrapper import BodyArrays

from ..scene.bodies import numbers
from .bodyarrays import BORDER, CONTACT, PARTICLE

if TYPE_CHECKING:
    from ..typealiases import Rows


def particles(ids: Sequence[int] | None = None) -> Rows:
    """Spheres and superquadrics among the bodies `ids`, in that order; None: all, in the order of their ids. Rows of PARTICLE.

    id; kind: SPHERE or SUPERQUADRIC; material: its id; contacts: how many push; extents: half sizes [m]; exponents: (n1, n2); position [m],
    in a periodic scene inside the cell; orientation: body to scene; velocity [m/s]; angVel [rad/s]; volume [m3]; stress: mean stress [Pa],
    sum over the contacts of lever times force over the volume, tension positive; octahedralStress: its octahedral shear stress [Pa].

    :raises ValueError: a body that is not in the scene
    """
    return np.frombuffer(BodyArrays().particles(ids if ids is None else numbers('ids', ids)), PARTICLE)


def contacts() -> Rows:
    """All real contacts in the order of their ids; rows of CONTACT.

    id1, id2; centre1, centre2: the particles' centres [m], of a wall instead the contact point, in a periodic scene of the image that touches;
    point: of contact [m]; normalForce, shearForce: on body 2 [N]; overlap [m].
    """
    return np.frombuffer(BodyArrays().contacts(), CONTACT)


def container() -> Rows:
    """Walls, hollow cylinders and facets in the order of their ids; rows of BORDER.

    kind: WALL, CYLINDER or FACET; numbers: of a Wall (axis, sense), of a HollowCylinder (radius, height) [m], of a Facet its three vertices in
    the scene [m].
    """
    return np.frombuffer(BodyArrays().container(), BORDER)
