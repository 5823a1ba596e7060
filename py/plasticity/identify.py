"""From a material's stress-strain curve to its material file: all cases, the checks, the fit, tables and pictures in one folder."""
from __future__ import annotations

import os
import platform
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import getfem
import numpy
import scipy

from ..files import results
from ..materials import materialfile
from ..version import __version__
from . import cases, figures, fit, hertz, page, unloading

if TYPE_CHECKING:
    from ..typealiases import PathLike
    from .cases import Result, Settings
    from .curves import Curve

CURVE_COLUMNS = ('effectiveRadius', 'overlap', 'force', 'halfWidth')   # [m], [m], [N], [m]
RANGES = (1 / 3, 1 / 2, 2 / 3)   # of the largest sqrt(R d)/R
HERTZ_LIMIT = 0.02   # largest departure from Hertz with plasticity off


class Identification:
    """All that is computed for one material.

    :param material: dict as of materialfile.read
    :param report: called with a line of text whenever something is finished
    :ivar elastic: loading Curves without plasticity; results: cases.Results; convergence: as of cases.convergence
    :ivar law, disc, constant: fit.Fits over sqrt(R d), over the half-width, and the first with a G that does not depend on R
    :ivar ranges: as `constant`, but for loads up to a smaller sqrt(R d)/R: {that: fit.Fit}; unloadings: unloading.Comparisons
    :raises ValueError: the elastic cases miss Hertz by more than HERTZ_LIMIT; the constants are none that the law takes
    """

    def __init__(self, material: Mapping[str, Any], settings: Settings, report: Callable[[str], object] = lambda line: None) -> None:
        self.material, self.settings = material, settings
        self.elastic = [self._elastic(name, report) for name in cases.ELASTIC_CASES]
        self.hertzError = max(float(numpy.abs(error).max()) for curve in self.elastic for error in hertz.errors(curve))
        if self.hertzError > HERTZ_LIMIT:
            raise ValueError(f'fineness = {settings.fineness}: elastic contacts miss Hertz by {self.hertzError:.3g}')
        self.convergence = cases.convergence(material, settings)
        report('mesh convergence')
        self.results = [self._plastic(name, report) for name in cases.CASES]
        self.curves = [result.loading for result in self.results]
        self.law, self.disc = fit.fit(fit.points(self.curves)), fit.fit(fit.points(self.curves, lambda curve: curve.halfWidth))
        self.constant = fit.fit(fit.points(self.curves), degree=0)
        self.ranges = {share * settings.largest: fit.fit(fit.points(self.curves, largest=share * settings.largest), degree=0) for share in RANGES}
        self.unloadings = [unloading.compare(result.loading, curve) for result in self.results for curve in result.unloading]

    def _elastic(self, name: str, report: Callable[[str], object]) -> Curve:
        curve = cases.runElastic(cases.Case(name, self.material, self.settings, plastic=False))
        report(f'{name} elastic')
        return curve

    def _plastic(self, name: str, report: Callable[[str], object]) -> Result:
        result = cases.run(cases.Case(name, self.material, self.settings))
        report(f'{name}: {len(result.loading.force)} loads, {result.failures} halved steps')
        return result

    def materialContent(self) -> dict[str, Any]:
        """Content of the identified material file."""
        ratios = [curve.radius / fit.REFERENCE_RADIUS for curve in self.curves]
        hardening = {'referenceRadius': fit.REFERENCE_RADIUS, **self.law.constants, 'smallestRatio': min(ratios), 'largestRatio': max(ratios)}
        largest = min(curve.overlap[-1] / curve.yieldPoint.overlap for curve in self.curves)
        return {**self.material, 'hardening': hardening, 'fit': {
            'cases': list(cases.CASES), 'largestOverlap': _short(largest), 'largestHalfWidth': _short(self.settings.largest),
            'residual': _short(self.law.rms), 'hertzError': _short(self.hertzError),
            'intervals': {name: [_short(bound, 4) for bound in bounds] for name, bounds in self.law.intervals.items()},
            'fineness': self.settings.fineness, 'versions': versions()}}

    def write(self, folder: PathLike, name: str) -> None:
        """Write the material file `folder`/`name`.yaml, tables (CSV), pictures and page.md."""
        os.makedirs(folder, exist_ok=True)
        place: Callable[[str], str] = lambda file: os.path.join(folder, file)
        writeCurves(place('elastic.csv'), self.elastic)
        writeCurves(place('loading.csv'), self.curves)
        writeCurves(place('unloading.csv'), [curve for result in self.results for curve in result.unloading])
        figures.hertzPicture(place('hertz.png'), self.elastic)
        figures.convergencePicture(place('convergence.png'), self.convergence)
        figures.collapsePicture(place('collapse.png'), self.curves, self.law, self.disc)
        reference = list(cases.CASES).index(cases.REFERENCE_CASE)
        shown = [self.results[reference].unloading[i] for i in (2, -1)]
        figures.unloadingPicture(place('unloading.png'), self.curves[reference], shown)
        figures.restitutionPicture(place('restitution.png'), self.unloadings, self.law, self.ranges)
        with results.Replacing(place('page.md')) as file:
            file.write(page.text(self))
        materialfile.write(place(f'{name}.yaml'), self.materialContent())


def writeCurves(path: PathLike, curves: Sequence[Curve]) -> None:
    """All points of curves.Curves as CSV, the case's name in the first column."""
    with results.Replacing(path) as file:
        file.write(','.join(('case', *CURVE_COLUMNS)) + '\n')
        for curve in curves:
            for row in zip(curve.overlap, curve.force, curve.halfWidth):
                file.write(','.join([curve.name, repr(float(curve.radius)), *(repr(float(value)) for value in row)]) + '\n')


def versions() -> dict[str, str]:
    """Versions of what took part in the computation."""
    return {'yade-superquadric': __version__, 'getfem': str(getfem.getfem_env('version')), 'scipy': scipy.__version__, 'numpy': numpy.__version__,
            'python': platform.python_version()}


def _short(value: float, digits: int = 3) -> float:
    return float(f'{float(value):.{digits}g}')
