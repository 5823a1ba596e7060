"""YADE's 3D view from a script: opened, aimed, and drawn at once into an array, also without a screen:

    xvfb-run -a yade -x script.py

gives it an X server in memory (the package xvfb; `tools/env --with view` has it).
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy
from numpy.typing import NDArray

from .. import checks
from ..renamed import oldNames

LARGEST = 16384  # pixels of a window's side: no screen has more
SCENE = 5  # what lies farther behind or before the aim than so many of its radii is cut off by the camera


def openView(size: tuple[int, int] = (800, 800)) -> Any:
    """YADE's 3D view, a `yade.qt.GLViewer` of `size` (width, height) in pixels; the one that is open already, or a new one.

    :raises ValueError: a bad size; ImportError: YADE was started without a display
    """
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ValueError(f'size = {size!r}: must be (width, height)') from None
    width, height = checks.wholeNumber('size[0]', width, 1, LARGEST), checks.wholeNumber('size[1]', height, 1, LARGEST)
    from yade import qt
    view = qt.views()[0] if qt.views() else qt.View()
    view.screenSize = width, height
    return view


def aim(view: Any, center: Sequence[float], radius: float, azimuth: float = -60, elevation: float = 25, orthographic: bool = False) -> None:
    """Turn the camera to the sphere about `center` [m] of `radius` [m], and fit it into the window.

    :param azimuth, elevation: where the camera stands, as in `picture`: around z from +x, counterclockwise seen from above, and above the horizontal
        [degrees]
    """
    center, radius = checks.vector('center', center), checks.positive('radius', radius)
    orthographic = checks.boolean('orthographic', orthographic)
    if not hasattr(view, 'fitSphere'):
        raise ValueError(f'view = {view!r}: must be a 3D view, as openView() gives it')
    around, up = math.radians(checks.finite('azimuth', azimuth)), math.radians(checks.within('elevation', elevation, -90, 90))
    view.ortho = orthographic
    view.sceneRadius = SCENE * radius
    view.viewDir = -math.cos(up) * math.cos(around), -math.cos(up) * math.sin(around), -math.sin(up)
    view.upVector = -math.sin(up) * math.cos(around), -math.sin(up) * math.sin(around), math.cos(up)
    view.fitSphere(center, radius)


def grabImage() -> NDArray[Any]:
    """The open view as it is now, drawn at once; (height, width, 3) uint8. RuntimeError when none is open."""
    image = _window().grabFramebuffer()
    image = image.convertToFormat(image.Format_RGB888)
    rows = numpy.frombuffer(image.constBits().asarray(image.byteCount()), numpy.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, :3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def _window() -> Any:
    from PyQt5.QtWidgets import QApplication
    for widget in QApplication.topLevelWidgets():
        if widget.inherits('yade::GLViewer'):
            return widget
    raise RuntimeError('no 3D view is open: call openView()')


__getattr__ = oldNames(__name__, {'frame': 'grabImage'})
