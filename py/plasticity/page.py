"""The page of an identification: what was found, and how far to trust it. Every number on it comes from the Identification."""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy

from . import cases, hertz, unloading
from . import fit as fits
from .curves import forceAt

if TYPE_CHECKING:
    from .fit import Fit
    from .identify import Identification

METHOD = """\
Axisymmetric finite elements (getfem) of spheres and plates of this metal: von Mises plasticity with isotropic hardening along the curve, no
friction, small strain, contact at the undeformed radial coordinate. Radii are in mm. The overlap d is the approach of the far ends, plus the
elastic deformation of the part that was cut off there, so that it is Hertz's overlap. R is the effective radius; dy, ay and fy are overlap,
half-width and force at the onset of yield with p_y = 1.6 sigma_y (Li, Gao, Zhang & Liu 2018)."""
FORMULA = """\
fN = fy + fy (m0 + m1 r + m2 r^2) ((a - ay)/ay)^H, r = R/(2.5 mm), fitted by least squares of the relative error of the force, at loads in equal
ratios of sqrt(d). In brackets: 95 % intervals from the errors. The errors are those of the power law itself and similar at neighbouring loads;
they therefore count as fewer independent ones."""
RANGES = """\
If the law is fitted to smaller loads only, with a G that does not depend on R, it follows these better and deviates at larger ones; see also the
restitution below."""
UNLOADING = """\
Residual overlap dR over the largest overlap dmax: of the finite elements, and of Hertz unloading curves through the same point with the contact
radius a^2 = R dmax (the law in YADE), with the original R, and with the contact radius of the finite elements, whose a^2/(R dmax) is given. Then
the restitution of a slow collision: of the finite elements, of their loading with the law's unloading, and of the law alone."""


def text(found: Identification) -> str:
    """The page (Markdown) of the identify.Identification `found`."""
    return '\n\n'.join([f'# {found.material["name"]}', _header(found), METHOD, _constants(found), _cases(found), _hertz(found),
                        _convergence(found), _unloading(found)]) + '\n'


def _table(columns: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """Markdown table of texts."""
    return '\n'.join(f'| {" | ".join(cells)} |' for cells in (columns, ['---'] * len(columns), *rows))


def _header(found: Identification) -> str:
    material, curve = found.material, found.curves[0]
    return (f'{material["source"].strip()}\n\nE = {material["young"] / 1e9:.4g} GPa, nu = {material["poisson"]:.3g}, '
            f'rho = {material["density"]:.4g} kg/m^3, sigma_y = {material["yieldStress"] / 1e6:.4g} MPa; '
            f'dy/R = {curve.yieldPoint.overlap / curve.radius:.3g}, ay/R = {curve.yieldPoint.contactRadius / curve.radius:.3g}.')


def _constants(found: Identification) -> str:
    kinds = (('sqrt(R d): the law in YADE', found.law), ('sqrt(R d), G without R', found.constant), ('half-width of the finite elements', found.disc))
    rows = [[name, *(_bracketed(fit, constant) for constant in fits.CONSTANTS), f'{100 * fit.rms:.2f} %', f'{100 * fit.largest:.1f} %']
            for name, fit in kinds]
    spread = fits.collapse(fits.points(found.curves))
    ranges = [[f'{largest:.3g}', f'{(largest * found.curves[0].radius / found.curves[0].yieldPoint.contactRadius)**2:.3g}',
               f'{fit.constants["m0"]:.4g}', f'{fit.constants["exponent"]:.4g}', f'{100 * fit.rms:.1f} %']
              for largest, fit in (*found.ranges.items(), (found.settings.largest, found.constant))]
    return '\n\n'.join(['## Constants', FORMULA, _table(['a', 'm0', 'm1', 'm2', 'H', 'rms error of the force', 'largest'], rows),
                        f'The cases differ by {100 * spread:.2f} % (rms) at the same (a - ay)/ay. {_dependence(found.law)}',
                        '![collapse](collapse.png)', RANGES, _table(['sqrt(R d)/R up to', 'd/dy up to', 'G', 'H', 'rms error of the force'], ranges)])


def _bracketed(fit: Fit, name: str) -> str:
    value, (low, high) = fit.constants[name], fit.intervals[name]
    return f'{value:.4g}' if low == high else f'{value:.4g} [{low:.3g}, {high:.3g}]'


def _dependence(fit: Fit) -> str:
    nil = [name for name in ('m1', 'm2') if fit.intervals[name][0] <= 0 <= fit.intervals[name][1]]
    different = 'that m1 and m2 are not zero is the finite size of the spheres, and the mesh.'
    said = f'{" and ".join(nil)} are not significantly different from zero.' if nil else different
    return 'Without a length scale in the material G cannot depend on R, because fy is proportional to R^2 and ay to R; ' + said


def _cases(found: Identification) -> str:
    rows = []
    for result in found.results:
        curve = result.loading
        pressure = curve.force[-1] / (math.pi * curve.halfWidth[-1]**2) / found.material['yieldStress']
        rows.append([curve.name, f'{1e3 * curve.radius:.3g}', f'{curve.overlap[-1] / curve.yieldPoint.overlap:.3g}',
                     f'{curve.halfWidth[-1] / curve.radius:.3g}', f'{curve.force[-1]:.4g}', f'{pressure:.3g}', f'{result.largestStrain:.2g}',
                     f'{100 * result.largestPenetration:.2g} %', str(result.failures)])
    columns = ['case', 'R [mm]', 'largest d/dy', 'largest a/R', 'force there [N]', 'mean pressure/sigma_y there', 'largest plastic strain',
               'penetration/d (subtracted)', 'halved steps']
    return '## Cases\n\n' + _table(columns, rows)


def _hertz(found: Identification) -> str:
    rows = []
    for curve in found.elastic:
        force, halfWidth = hertz.errors(curve)
        rows.append([curve.name, _worst(force), _worst(halfWidth), f'{fits.nominalHalfWidth(curve)[-1] / curve.radius:.3g}'])
    columns = ['case', 'force at the same overlap', 'half-width under the same force', 'up to sqrt(R d)/R']
    return '\n\n'.join(['## Without plasticity: Hertz', _table(columns, rows), '![Hertz](hertz.png)'])


def _worst(errors: Any) -> str:
    return f'{100 * errors[numpy.argmax(numpy.abs(errors))]:+.2f} %'


def _convergence(found: Identification) -> str:
    finest = found.convergence[max(found.convergence)][1]
    rows = []
    for fineness, (unknowns, curve) in sorted(found.convergence.items()):
        errors = curve.force / forceAt(finest, curve.overlap) - 1
        cells = ['', ''] if curve is finest else [f'{100 * numpy.sqrt(numpy.mean(errors**2)):.2f} %', _worst(errors)]
        rows.append([f'{fineness:g}', f'{unknowns:,}', *cells])
    about = (f'Case {cases.REFERENCE_CASE}; force at the same overlap against the finest mesh. The cases above are on meshes of the fineness '
             f'{found.settings.fineness:g}.')
    table = _table(['fineness', 'unknowns', 'rms difference', 'largest'], rows)
    return '\n\n'.join(['## Mesh', about, table, '![mesh convergence](convergence.png)'])


def _unloading(found: Identification) -> str:
    constants = [found.law.constants[name] for name in fits.CONSTANTS]
    rows = [[one.case, f'{one.largest:.3g}', f'{one.halfWidth:.2f}', f'{one.residual:.3f}', f'{one.law:.3f}', f'{one.original:.3f}',
             f'{one.disc:.3f}', f'{one.returned**0.5:.3f}', f'{one.lawReturned**0.5:.3f}',
             f'{unloading.lawRestitution(constants, one.ratio, one.largest):.3f}'] for one in found.unloadings]
    columns = ['case', 'dmax/dy', 'a^2/(R dmax)', 'dR/dmax', 'law', 'original R', 'true disc', 'restitution', 'law unloads', 'law']
    return '\n\n'.join(['## Unloading', UNLOADING, _table(columns, rows), '![unloading](unloading.png)', '![restitution](restitution.png)'])
