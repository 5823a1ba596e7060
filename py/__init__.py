"""Granular materials of superquadric particles in YADE: bodies, containers, engines, and the impact study on top.

    from yade import superquadric as sq
    O.bodies.append(sq.superquadric((0, 0, 0.1), (5e-3, 5e-3, 5e-3), n1=8, n2=8, material=material))
    O.engines = sq.superquadricEngines()
    O.dt = sq.checkTimeStep(0.1 * sq.criticalTimeStep())

SI units everywhere; z points up.
"""
from . import regions
from .bedgeometry import measureBed
from .bodies import ParticleShape, equalVolumeExtents, particleShape, superquadric
from .container import Container, boxContainer, cylinderContainer, setHeight
from .engines import checkTimeStep, criticalTimeStep, solverCounters, superquadricEngines
from .filling import particleNumber, rainFilling, randomOrientation
from .frame import Frame
from .impact import Pulse, Recorder, addImpactor, bareImpact, pulse, recordImpact
from .materials import elastoplasticMat
from .meshes import Surface, particlesToStl, readSurface, stlContainer, writeStl
from .packing import Measured, packingFraction, solidVolume
from .render import animation, picture
from .restitution import normalDampingFor
from .run import ImpactRun
from .settling import RestCriterion, scaleStiffness, settle, stiffen
from .snapshot import Snapshot
from .stepping import Interrupted, Stepper
from .tessellation import Tessellation, tessellation
from .version import __version__
from .vtkframes import RecordedSeries
from .vtkrecorder import vtkRecorder

__all__ = [
    'Container', 'Frame', 'ImpactRun', 'Interrupted', 'Measured', 'ParticleShape', 'Pulse', 'RecordedSeries', 'Recorder', 'RestCriterion',
    'Snapshot', 'Stepper', 'Surface', 'Tessellation', 'addImpactor', 'animation', 'bareImpact', 'boxContainer', 'checkTimeStep',
    'criticalTimeStep', 'cylinderContainer', 'elastoplasticMat', 'equalVolumeExtents', 'measureBed', 'normalDampingFor', 'packingFraction',
    'particleNumber', 'particleShape', 'particlesToStl', 'picture', 'pulse', 'rainFilling', 'randomOrientation', 'readSurface',
    'recordImpact', 'regions', 'scaleStiffness', 'setHeight', 'settle', 'solidVolume', 'solverCounters', 'stiffen', 'stlContainer',
    'superquadric', 'superquadricEngines', 'tessellation', 'vtkRecorder', 'writeStl', '__version__']
