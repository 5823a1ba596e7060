"""Granular materials of superquadric particles in YADE: bodies, containers, engines, and the impact study on top.

    from yade import superquadric as sq
    O.bodies.append(sq.superquadric((0, 0, 0.1), (5e-3, 5e-3, 5e-3), n1=8, n2=8, material=material))
    O.engines = sq.superquadricEngines()
    O.dt = sq.checkTimeStep(0.1 * sq.criticalTimeStep())

SI units everywhere; z points up.
"""
from __future__ import annotations

import importlib
from typing import Any

from .renamed import oldNames
from .version import __version__

# Where each name is defined. It is imported when it is first asked for, so that what needs no YADE (statistics, files, studies) can be
# imported where there is none.
_HANDED_ON = {
    'experiments.impact.impactor': ('Recorder', 'addImpactor', 'bareImpact', 'recordImpact'),
    'experiments.impact.pulse': ('Pulse', 'pulse'),
    'experiments.impact.run': ('ImpactRun',),
    'materials.elastoplastic': ('elastoplasticMat',),
    'measure.bed': ('measureBed',),
    'measure.scenesnapshot': ('SceneSnapshot',),
    'measure.snapshot': ('Snapshot',),
    'mesh.packing': ('Measured', 'packingFraction', 'solidVolume'),
    'mesh.stl': ('TriangleMesh', 'particlesToStl', 'readStl', 'stlContainer', 'writeStl'),
    'mesh.tessellation': ('Tessellation', 'tessellation'),
    'pictures.render': ('animation', 'picture'),
    'scene.bodies': ('superquadric',),
    'scene.container': ('Container',),
    'scene.engines': ('checkTimeStep', 'criticalTimeStep', 'solverCounters', 'superquadricEngines'),
    'scene.expectedbed': ('particleNumber',),
    'scene.filling': ('rainFilling', 'randomOrientation'),
    'scene.restitution': ('normalDampingFor',),
    'scene.settling': ('RestCriterion', 'scaleStiffness', 'settle', 'stiffen'),
    'scene.shapes': ('ParticleShape', 'equalVolumeExtents', 'particleShape'),
    'scene.stepping': ('Interrupted', 'Stepper'),
    'scene.walls': ('boxContainer', 'cylinderContainer', 'setHeight'),
    'vtk.recorded': ('RecordedSeries',),
    'vtk.recorder': ('vtkRecorder',),
}
_MODULES = {  # handed on whole
    'parallel': 'scene.parallel', 'plots': 'experiments.impact.forceplot', 'regions': 'mesh.regions',
    'render': 'pictures.render', 'snapshotrecorder': 'pictures.snapshotrecorder', 'view': 'pictures.view'}
# Names of version 0.1, and what they are called now.
_RENAMED = {'Frame': 'SceneSnapshot', 'Surface': 'TriangleMesh', 'readSurface': 'readStl', 'film': 'snapshotrecorder'}
_PLACES = {name: module for module, names in _HANDED_ON.items() for name in names}

__all__ = [*sorted(_PLACES), *sorted(_MODULES), '__version__']


_oldName = oldNames(__name__, _RENAMED)


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        value = importlib.import_module(f'.{_MODULES[name]}', __name__)
    elif name in _PLACES:
        value = getattr(importlib.import_module(f'.{_PLACES[name]}', __name__), name)
    else:
        return _oldName(name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def _handOverToPytest() -> None:
    """`python3 -m pytest` in the checkout finds this folder where pytest asks for its own module `py`: it gets that one."""
    import importlib.machinery
    import importlib.util
    import sys
    from pathlib import Path
    checkout = Path(__file__).resolve().parents[1]
    spec = importlib.machinery.PathFinder.find_spec('py', [folder for folder in sys.path if Path(folder).resolve() != checkout])
    assert spec is not None and spec.loader is not None
    sys.modules['py'] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules['py'])


if __name__ == 'py':
    _handOverToPytest()
