"""The bodies of a container: a Wall at z = 0 as its base, and a HollowCylinder or four Walls as its sides."""
from __future__ import annotations

from typing import Any

from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import Body, HollowCylinder

from .. import checks
from .container import Container, checkBox, checkCylinder


def cylinderContainer(radius: float, height: float, material: Any, largestParticle: float = 0.0) -> Container:
    """Put a rigid cylinder, axis z through the origin, base at z = 0, into the scene.

    :param radius: inner radius [m]; :param height: [m]
    :param material: its material
    :param largestParticle: bounding radius [m] of the largest particle that has to fit in
    :returns: `Container`
    :raises ValueError: before anything is added
    """
    radius, height = checkCylinder(radius, height, largestParticle)
    base = O.bodies.append(_base(material))
    side = O.bodies.append(_cylinder(radius, height, material))
    return Container(base, (side,), radius, None, None, height)


def boxContainer(width: float, depth: float, height: float, material: Any, largestParticle: float = 0.0) -> Container:
    """Put a rigid box (four walls and a base at z = 0, centred on the z axis) into the scene.

    :param width, depth, height: inner sizes along x, y, z [m]; the walls are planes, without an upper rim
    :param material, largestParticle: as in `cylinderContainer`
    """
    width, depth, height = checkBox(width, depth, height, largestParticle)
    base = O.bodies.append(_base(material))
    sides = [O.bodies.append(utils.wall(Vector3(*(sign * size / 2 if i == axis else 0 for i in range(3))), axis,
                                        sense=-sign, material=material))
             for axis, size in ((0, width), (1, depth)) for sign in (-1, 1)]
    return Container(base, tuple(sides), None, width, depth, height)


def setHeight(container: Container, height: float) -> Container:
    """Give a cylinder another height [m] with its base where it is (a box has no rim, nothing is to do)."""
    height = checks.positive('height', height)
    if container.radius is not None:
        side = O.bodies[container.sideIds[0]]
        side.shape.height = height
        side.state.pos = side.state.refPos = Vector3(0, 0, height / 2)
    return container._replace(height=height)


def _base(material: Any) -> Body:
    return utils.wall(0.0, 2, sense=1, material=material)


def _cylinder(radius: float, height: float, material: Any) -> Body:
    body = Body()
    body.shape = HollowCylinder(radius=radius, height=height, wire=True)
    utils._commonBodySetup(body, 0, Vector3.Zero, material, pos=Vector3(0, 0, height / 2), fixed=True)
    body.aspherical = False
    return body
