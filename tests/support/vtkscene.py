"""What the tests of files for ParaView share: a scene of all kinds of bodies, and what VTK reads of a series."""
import pyvista
from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import CurvatureMat, Sphere, Superquadric

import yade.superquadric as sq
from yade.superquadric.vtk.series import Series

R = 4e-3
SHAPES = [sq.particleShape('cube', R), sq.particleShape('ellipsoid', R, aspect=1.6), sq.particleShape('cylinder', R, aspect=1.5),
          sq.particleShape('sphere', R)]


def scene(steps=400, **recorder):
    """Particles of all kinds that fall onto each other in a cylinder, a facet among its walls."""
    O.reset()
    material = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4, normalDamping=0.1, tangentialDamping=0.1, rollingFriction=0.002)
    O.materials.append(material)
    container = sq.cylinderContainer(0.02, 0.06, material)
    O.bodies.append(utils.facet([(-0.02, 0, 0.001), (0.02, 0, 0.001), (0, 0.02, 0.004)], material=material))
    sq.rainFilling(SHAPES * 5, container._replace(height=1.0), material, seed=2)
    for body in O.bodies:
        body.state.vel = Vector3(0, 0, -2) if not body.state.blockedDOFs else Vector3.Zero
    O.engines = sq.superquadricEngines()
    O.dt = 0.1 * sq.criticalTimeStep()
    if recorder:
        O.engines = O.engines + [sq.vtkRecorder(**recorder)]
    O.run(steps, True)


def particleBodies():
    return [body for body in O.bodies if isinstance(body.shape, (Sphere, Superquadric))]


def last(folder, name):
    """What VTK reads of the series' last moment."""
    return pyvista.read(str(folder / Series(str(folder), name).entries()[-1].file))
