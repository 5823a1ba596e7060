"""More inertia for small fragments in a quasi-static test, so that they do not dictate the time step ("differential density scaling").

The critical time step (14) goes as size times sqrt(density). A particle of size d below d* that has (d*/d)^2 times its inertia takes the step of one
of size d*. Forces, stiffness and volumes stay; where motion is slow, inertia does not matter, and how slow it is is measured (inertial
number, unbalanced force).
"""
import math

from yade import O
from yade.wrapper import Sphere, Superquadric


def sizeOf(shape):
    """Diameter [m] of the sphere of a particle's volume; None for walls."""
    if isinstance(shape, Sphere):
        return 2 * shape.radius
    return (6 * shape.volume() / math.pi) ** (1 / 3) if isinstance(shape, Superquadric) else None


def scaleNewborns(ids, inertialSize):
    """Give the particles `ids` that are smaller than `inertialSize` [m] the inertia with which their critical time step is that of this size."""
    for body in map(O.bodies.__getitem__, ids):
        size = sizeOf(body.shape) if body is not None else None
        if size is not None and size < inertialSize:
            factor = (inertialSize / size) ** 2
            body.state.mass *= factor
            body.state.inertia *= factor
