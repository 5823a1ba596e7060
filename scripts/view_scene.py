"""YADE's 3D view of superquadrics, as a picture and as frames per second.

    xvfb-run -a yade -x scripts/view_scene.py --output view.png    a container of cubes, cylinders, ellipsoids and spheres: smooth and as wire
    xvfb-run -a yade -x scripts/view_scene.py --frames 3000        the time of a frame with so many bodies, against as many of YADE's spheres

Without xvfb-run the same happens on the screen. Needs `tools/env --with view`.
"""
import argparse
import random
import statistics
import time

import numpy
from PIL import Image
from yade import O
from yade.wrapper import CurvatureMat

from yade.superquadric import (
    checkTimeStep,
    criticalTimeStep,
    cylinderContainer,
    particleShape,
    rainFilling,
    randomOrientation,
    setHeight,
    superquadricEngines,
)
from yade.superquadric.pictures.view import aim, grabImage, openView

COLOURS = {'cube': (0.85, 0.45, 0.13), 'cylinder': (0.13, 0.42, 0.70), 'ellipsoid': (0.25, 0.60, 0.25), 'sphere': (0.72, 0.18, 0.20)}
GREY = 0.42, 0.45, 0.48
RADIUS = 5e-3          # of the spheres of equal volume [m]
CONTAINER = 0.04, 0.06  # radius and height [m]
FALL = 0.6             # [s], after which the particles lie
ROUNDS = 9             # of frames, one of each kind of bodies


def shapeOf(name):
    return particleShape(name, radius=RADIUS, aspect=1 if name in ('cube', 'sphere') else 1.6)


def material():
    return CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4, normalDamping=0.1, tangentialDamping=0.1, rollingFriction=0.002)


def pour(each):
    """A container with `each` particles of every kind, fallen to its base."""
    glass = material()
    container = cylinderContainer(*CONTAINER, material=glass)
    names = [name for name in COLOURS for _ in range(each)]
    random.Random(1).shuffle(names)
    ids, filled = rainFilling([shapeOf(name) for name in names], container, glass, seed=1)
    for i, name in zip(ids, names):
        O.bodies[i].shape.color = COLOURS[name]
    O.engines = superquadricEngines(gravity=(0, 0, -9.81))
    O.dt = checkTimeStep(0.1 * criticalTimeStep())
    O.run(int(FALL / O.dt), wait=True)
    setHeight(filled, container.height)
    side = O.bodies[container.sideIds[0]].shape
    side.wire, side.color = False, GREY


def rendererOfView():
    from yade import qt  # only where there is a display; --help needs none
    return qt.Renderer()


def savePicture(path, pixels):
    """The scene smooth and as wire, side by side; each is drawn twice as large as shown, so that edges are smooth."""
    view, renderer = openView((2 * pixels, 2 * pixels)), rendererOfView()
    view.axes, view.scale, view.timeDisp = False, False, ''
    aim(view, (0, 0, CONTAINER[1] / 2), 1.35 * CONTAINER[0], elevation=22)
    panels = []
    for wire in False, True:
        renderer.wire = wire
        panels.append(grabImage())
    Image.fromarray(numpy.hstack(panels)).resize((2 * pixels, pixels), Image.LANCZOS).save(path)


def scatter(name, number):
    """So many bodies of a kind on a grid, turned at random."""
    O.reset()
    rng, glass, shape = random.Random(1), material(), shapeOf(name)
    O.materials.append(glass)
    columns = round(number ** (1 / 3))
    for i in range(number):
        place = numpy.array([i % columns, i // columns % columns, i // columns ** 2]) - (columns - 1) / 2
        O.bodies.append(shape.body(2.2 * RADIUS * place, randomOrientation(rng), glass, color=COLOURS[name]))
    return 2.2 * RADIUS * columns


def timeFrames(number):
    """Print the time of one frame [ms] for each kind of bodies, smooth and as wire: the median of rounds, and its ratio to YADE's own spheres."""
    view, renderer = openView(), rendererOfView()
    times = {(name, wire): [] for name in COLOURS for wire in (False, True)}
    for _ in range(ROUNDS):
        for name in COLOURS:
            width = scatter(name, number)
            aim(view, (0, 0, 0), 0.8 * width)
            for wire in False, True:
                renderer.wire = wire
                grabImage()
                begin = time.perf_counter()
                grabImage()
                times[name, wire].append(1e3 * (time.perf_counter() - begin))
    for wire in False, True:
        for name in COLOURS:
            ratios = [own / sphere for own, sphere in zip(times[name, wire], times['sphere', wire])]
            print(f'{"wire" if wire else "smooth":8} {name:10} {statistics.median(times[name, wire]):7.1f} ms a frame, '
                  f'{statistics.median(ratios):5.2f} times YADE\'s spheres ({min(ratios):.2f}-{max(ratios):.2f})')


def main():
    parser = argparse.ArgumentParser(prog='view_scene.py', description=__doc__.splitlines()[0])
    parser.add_argument('--output', metavar='FILE', help='save the picture there')
    parser.add_argument('--each', type=int, default=60, help='particles of each kind in the picture (%(default)s)')
    parser.add_argument('--pixels', type=int, default=800, help='height of the picture (%(default)s)')
    parser.add_argument('--frames', type=int, metavar='BODIES', help='print the time of a frame with so many bodies')
    arguments = parser.parse_args()
    if arguments.output:
        pour(arguments.each)
        savePicture(arguments.output, arguments.pixels)
    if arguments.frames:
        timeFrames(arguments.frames)


main()
