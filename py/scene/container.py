"""Rigid containers: the cylinder of the study, and a box. Both stand on the plane z = 0, which is a Wall."""
import math
from collections import namedtuple

from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import Body, HollowCylinder

from .. import checks

Container = namedtuple('Container', 'baseId sideIds radius width depth height')
Container.__doc__ = """A container in the scene.

baseId: id of the base (a Wall at z = 0, forces on it are recorded); sideIds: ids of the side wall(s);
radius [m] of a cylinder (else None); width, depth [m] of a box along x, y (else None); height [m].
"""


def crossSection(container):
    """Inner area [m2]."""
    if container.radius is None:
        return container.width * container.depth
    return math.pi * container.radius ** 2


def cylinderContainer(radius, height, material, largestParticle=0.0):
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


def boxContainer(width, depth, height, material, largestParticle=0.0):
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


def checkFits(container, largestParticle):
    """ValueError if a particle of bounding radius `largestParticle` [m] does not fit into the container."""
    if container.radius is not None:
        checkCylinder(container.radius, container.height, largestParticle)
    else:
        checkBox(container.width, container.depth, container.height, largestParticle)


def checkBox(width, depth, height, largestParticle):
    """The sizes as floats; ValueError if a particle of bounding radius `largestParticle` [m] does not fit into the box."""
    sizes = tuple(checks.positive(f'container {name}', size) for name, size in (('width', width), ('depth', depth), ('height', height)))
    largestParticle = checks.notNegative('largestParticle', largestParticle)
    for name, size in zip(('width', 'depth', 'height'), sizes):
        if size < 2 * largestParticle:
            raise ValueError(f'container {name} = {size!r}: the container is smaller than a particle '
                             f'(bounding diameter {2 * largestParticle:g} m)')
    return sizes


def checkCylinder(radius, height, largestParticle):
    """Radius and height as floats; ValueError if a particle of bounding radius `largestParticle` [m] does not fit into the cylinder."""
    radius, height = checks.positive('container radius', radius), checks.positive('container height', height)
    largestParticle = checks.notNegative('largestParticle', largestParticle)
    if radius < largestParticle:
        raise ValueError(f'container radius = {radius!r}: the container is smaller than a particle '
                         f'(bounding radius {largestParticle:g} m)')
    if height < 2 * largestParticle:
        raise ValueError(f'container height = {height!r}: the container is smaller than a particle '
                         f'(bounding diameter {2 * largestParticle:g} m)')
    return radius, height


def setHeight(container, height):
    """Give a cylinder another height [m] with its base where it is (a box has no rim, nothing is to do)."""
    height = checks.positive('height', height)
    if container.radius is not None:
        side = O.bodies[container.sideIds[0]]
        side.shape.height = height
        side.state.pos = side.state.refPos = Vector3(0, 0, height / 2)
    return container._replace(height=height)


def _base(material):
    return utils.wall(0.0, 2, sense=1, material=material)


def _cylinder(radius, height, material):
    body = Body()
    body.shape = HollowCylinder(radius=radius, height=height, wire=True)
    utils._commonBodySetup(body, 0, Vector3.Zero, material, pos=Vector3(0, 0, height / 2), fixed=True)
    body.aspherical = False
    return body
