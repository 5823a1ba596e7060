"""Bodies of one pure colour each in YADE's 3D view, for test_view.py: `xvfb-run -a yade -x viewscene.py FILE` saves pictures of them and
their boxes."""
import os
import sys

import numpy
from yade import Body, O, qt, utils
from yade.minieigenHP import Quaternion, Vector3
from yade.wrapper import CurvatureMat, Gl1_HollowCylinder, Gl1_Sphere, Gl1_Superquadric, HollowCylinder

from yade.superquadric import superquadric
from yade.superquadric.pictures.view import aim, grabImage, openView

SPACING = 2.6
BODIES = {  # extents [m], n1, n2, orientation; red is a sphere of radius 1, the ruler
    'green': ((1, 1, 1), 8, 8, Quaternion.Identity),
    'blue': ((0.6, 0.6, 1.2), 20, 2, Quaternion.Identity),
    'yellow': ((1.2, 0.5, 0.5), 2, 2, Quaternion(Vector3.UnitY, 0.6)),
    'magenta': ((0.9, 0.4, 0.7), 20, 20, Quaternion(Vector3(1, 2, 3).normalized(), 1.0)),
    'cyan': ((0.4, 0.8, 1.1), 3, 5, Quaternion(Vector3(3, -1, 1).normalized(), 2.0)),
}
COLOURS = {'red': (1, 0, 0), 'green': (0, 1, 0), 'blue': (0, 0, 1), 'yellow': (1, 1, 0), 'magenta': (1, 0, 1), 'cyan': (0, 1, 1)}


def place(i):
    return Vector3(SPACING * (i - 2.5), 0, 0)


def build():
    """Append the bodies; returns half the width and half the height [m] of all but the sphere, as the camera sees them."""
    O.materials.append(CurvatureMat())
    O.bodies.append(utils.sphere(place(0), 1, color=COLOURS['red']))
    for i, (name, (extents, n1, n2, orientation)) in enumerate(BODIES.items(), 1):
        O.bodies.append(superquadric(place(i), extents, n1, n2, orientation=orientation, color=COLOURS[name]))
    boxes = [O.bodies[i].shape.boxHalfExtents(O.bodies[i].state.ori) for i in range(1, len(COLOURS))]
    return [(box[0], box[2]) for box in boxes]


def addContainer(wire):
    body = Body()
    body.shape = HollowCylinder(radius=3 * SPACING, height=6, color=(1, 1, 1), wire=wire)
    utils._commonBodySetup(body, 0, Vector3.Zero, -1, pos=Vector3.Zero, fixed=True)
    return O.bodies.append(body)


def main(path):
    openView((1200, 300))
    view, renderer = openView((1200, 300)), qt.Renderer()  # the second call gives the one that is open
    view.axes, view.scale, view.timeDisp, renderer.light2, Gl1_Sphere.quality = False, False, '', False, 5
    boxes = build()
    aim(view, (0, 0, 0), 2.2, azimuth=-90, elevation=0, orthographic=True)
    pictures = {'smooth': grabImage()}
    Gl1_Superquadric.stripes = True
    pictures['stripes'] = grabImage()
    Gl1_Superquadric.stripes, Gl1_Superquadric.quality = False, 0.01
    pictures['coarse'] = grabImage()
    Gl1_Superquadric.quality, renderer.wire = 1, True
    pictures['wire'] = grabImage()
    renderer.wire = False
    container = addContainer(wire=False)
    pictures['container'] = grabImage()
    O.bodies[container].shape.wire = True
    pictures['wireContainer'] = grabImage()
    O.bodies[container].shape.wire, O.bodies[container].shape.height = False, float('inf')
    pictures['endless'] = grabImage()
    Gl1_HollowCylinder.div = -1  # as if it were 3
    pictures['threeSided'] = grabImage()
    numpy.savez(path, boxes=numpy.array(boxes), **pictures)


main(sys.argv[1])
sys.stdout.flush()
os._exit(0)
