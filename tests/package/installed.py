"""In a Debian with the package: YADE has the plugin, Python the modules, both where YADE keeps its own."""
import os

from yade import config
from yade import superquadric as sq

from yade.superquadric.materials.elastoplastic import elastoplasticMat

assert 'YADE_PREFIX' not in os.environ
assert os.path.isfile(os.path.join(config.libDir, 'libsuperquadric.so'))
assert sq.__file__ == os.path.join(config.libDir, 'py', 'yade', 'superquadric', '__init__.py'), sq.__file__

material = CurvatureMat(young=1e8, poisson=0.2, density=2500)
floor = O.bodies.append(utils.wall(0, 2, sense=1, material=material))
grain = O.bodies.append(sq.superquadric((0, 0, 6e-3), (5e-3, 5e-3, 5e-3), n1=8, n2=8, material=material))
O.engines = sq.superquadricEngines()
O.dt = sq.checkTimeStep(0.1 * sq.criticalTimeStep())
while O.bodies[grain].state.vel[2] <= 0:  # until it comes up again
    O.step()
    assert O.time < 0.1, 'the cube fell through the floor'
assert elastoplasticMat('steel-4340').yieldStress > 0  # a file that came with the package
print(f'yade {config.version}, yade-superquadric {sq.__version__}: installed in {os.path.dirname(sq.__file__)}')
