"""What several processes refuse, for test_mpi.py, run by every rank: mpirun -np 3 yade -n -x -j1 parallelrefusals.py SCENE FOLDER.

SCENE: refusals, then rank 0 writes the messages of all ranks as FOLDER/messages.json; or failing: an engine fails on rank 1 only.
"""
import json
import os
import sys

from yade import O
from yade import superquadric as sq
from yade.wrapper import CurvatureMat, PyRunner, RotationEngine, TriaxialStressController

from yade.superquadric.scene import parallel
from yade.superquadric.vtk import polydata

scene, folder = sys.argv[1:]
messages = []


def refused(do):
    try:
        do()
        messages.append('')
    except ValueError as error:
        messages.append(str(error))


def withEngine(engine):
    """`run` with one more engine."""
    whole = O.engines
    O.engines = whole + [engine]
    refused(lambda: parallel.run(1))
    O.engines = whole


def withMovingWall(name):
    """`run` with a wall that has a velocity."""
    setattr(O.bodies[0].state, name, (0, 0, 0.1))
    refused(lambda: parallel.run(1))
    setattr(O.bodies[0].state, name, (0, 0, 0))


if parallel.rank() == 0:
    glass = CurvatureMat(young=1e7, poisson=0.2, density=2500, frictionAngle=0.4)
    container = sq.boxContainer(0.1, 0.1, 0.3, glass)
    sq.rainFilling([sq.particleShape('cube', 5e-3)] * 8, container, glass, seed=1)
    O.engines, O.dt = sq.superquadricEngines(), 0.1 * sq.criticalTimeStep()
    if scene == 'failing':
        O.engines = O.engines + [PyRunner(command="assert sys.modules['yade.mpy'].rank != 1, 'rank 1 fails'", iterPeriod=5)]
    else:
        polydata.requireVtk = lambda: None  # it is not to write anything
        withMovingWall('vel')
        withMovingWall('angVel')
        withEngine(RotationEngine(ids=[0]))
        withEngine(TriaxialStressController())
        withEngine(sq.vtkRecorder(os.path.join(folder, 'vtk'), iterPeriod=1))
parallel.run(10)
refused(lambda: parallel.Totals([0]))
if parallel.rank() == 0:
    withMovingWall('vel')
    withEngine(RotationEngine(ids=[0]))
parallel.run(10)
parallel.merge(forGood=True)
refused(lambda: parallel.run(10))
everyones = parallel._mpy().comm.gather(messages, root=0)
if parallel.rank() == 0:
    with open(os.path.join(folder, 'messages.json'), 'w') as out:
        json.dump({'messages': everyones, 'steps': O.iter}, out)
