"""The measured quantities that findings and figures may ask for: columns of the table, with names and units for readers."""
from __future__ import annotations

import math
import numbers
from collections.abc import Collection, Iterable, Mapping
from typing import Any, NamedTuple


class Quantity(NamedTuple):
    """A column of the table for readers: name, symbol (or ''), unit (or ''), and by what its SI value is multiplied to get there."""

    name: str
    symbol: str
    unit: str
    factor: float


QUANTITIES = {
    'peak': Quantity('peak force', '$P$', 'kN', 1e-3),
    'peakTime': Quantity('time of the peak in the record', '', 'ms', 1e3),
    'duration': Quantity('duration', '', 'ms', 1e3),
    'lastTime': Quantity('end of the last pulse in the record', '', 'ms', 1e3),
    'impulse': Quantity('impulse', '', 'N s', 1),
    'P0': Quantity('peak force without a bed', '$P_0$', 'kN', 1e-3),
    'bufferingRatio': Quantity('buffering ratio', '', '', 1),
    'H': Quantity('thickness', '$H$', 'mm', 1e3),
    'C0': Quantity('packing fraction', '$C_0$', '', 1),
    'innerC0': Quantity('inner packing fraction', '', '', 1),
    'number': Quantity('number of particles', '', '', 1),
    'staticForce': Quantity('static force', '', 'N', 1),
    'weight': Quantity('weight of the bed', '', 'N', 1),
    'pours': Quantity('pours', '', '', 1),
    'surfaceSpeed': Quantity('speed at the surface', '', 'm/s', 1),
    'solves': Quantity('contact problems', '', '', 1),
    'iterations': Quantity('iterations', '', '', 1),
    'fallbacks': Quantity('fallbacks', '', '', 1),
    'uncertified': Quantity('uncertified solutions', '', '', 1),
    'dtImpact': Quantity('time step of the impact', '', 'us', 1e6),
    'bedSeconds': Quantity('computing the bed', '', 's', 1),
    'impactSeconds': Quantity('computing the impact', '', 's', 1),
    'amplitude': Quantity('amplitude at the drive\'s frequency', '', 'mm', 1e3),
    'phaseLag': Quantity('phase lag', '', 'degrees', 1),
    'peakToPeak': Quantity('displacement, peak to peak', '', 'mm', 1e3),
    'harmonicShare': Quantity('harmonic part of the variance', '', '', 1),
    'fundamentalShare': Quantity('part of the variance at the drive\'s frequency', '', '', 1),
    'centroidAmplitude': Quantity('amplitude of the centre of mass', '', 'mm', 1e3),
    'centroidPhaseLag': Quantity('phase lag of the centre of mass', '', 'degrees', 1),
    'centroidPeakToPeak': Quantity('centre of mass, peak to peak', '', 'mm', 1e3),
    'particlesMass': Quantity('mass of the particles', '', 'kg', 1),
    'work': Quantity('work of the drive', '', 'J', 1),
    'dissipated': Quantity('dissipated energy', '', 'J', 1),
    'plasticShare': Quantity('plastic share of the dissipation', '', '%', 100),
    'normalViscousShare': Quantity('normal viscous share of the dissipation', '', '%', 100),
    'frictionDissipShare': Quantity('sliding share of the dissipation', '', '%', 100),
    'tangentialViscousShare': Quantity('tangential viscous share of the dissipation', '', '%', 100),
    'normalViscousLead': Quantity('lead of the normal viscous share over the next one', '', '%', 100),
    'period': Quantity('period of the box over the drive\'s, 0 for none', '', '', 1),
    'centroidPeriod': Quantity('period of the centre of mass over the drive\'s, 0 for none', '', '', 1),
    'centroidRatio': Quantity('motion of the centre of mass over that of the box (rms)', '', '', 1),
    'centroidHarmonicShare': Quantity('harmonic part of the variance of the centre of mass', '', '', 1),
    'centroidLoopFill': Quantity('loop of the centre of mass in its phase plane over the rectangle about it', '', '', 1),
    'storedShare': Quantity('stored energy gained, over the work', '', '%', 100),
    'balanceError': Quantity('error of the energy account', '', '%', 100),
    'runSeconds': Quantity('computing the run', '', 's', 1),
    'strain': Quantity('axial strain', '', '%', 100),
    'stress': Quantity('axial stress at the end', '', 'MPa', 1e-6),
    'lateralRatio': Quantity('lateral stress over the axial one', '', '', 1),
    'startVoidRatio': Quantity('void ratio at the start', '', '', 1),
    'voidRatio': Quantity('void ratio at the end', '', '', 1),
    'firstStress': Quantity('axial stress at the first breakage', '', 'MPa', 1e-6),
    'onsetStress': Quantity('axial stress at which 1 % are broken', '', 'MPa', 1e-6),
    'broken': Quantity('breakages', '', '', 1),
    'generations': Quantity('generations of fragments', '', '', 1),
    'smallest': Quantity('smallest particle', '', 'mm', 1e3),
    'volumeError': Quantity('error of the particles\' volume', '', '', 1),
    'lost': Quantity('particles lost', '', '', 1),
    'centresOutside': Quantity('particles with their centre outside', '', '', 1),
    'hardin': Quantity('relative breakage', '$B_r$', '', 1),
    'einav': Quantity('breakage (Einav)', '$B$', '', 1),
    'd50Before': Quantity('median size before', '', 'mm', 1e3),
    'd50': Quantity('median size after', '', 'mm', 1e3),
    'widestGap': Quantity('widest gap of the sizes', '', '', 1),
    'steepestPart': Quantity('steepest part of the grading', '', '%', 100),
    'fragmentsWidestGap': Quantity('widest gap of the fragments\' sizes', '', '', 1),
    'fragmentsSteepestPart': Quantity('steepest part of the fragments\' grading', '', '%', 100),
    'fractalDimension': Quantity('fractal dimension of the tail', '', '', 1),
    'fractalFit': Quantity('correlation of its fit', '$r^2$', '', 1),
    'rattlerShareBefore': Quantity('rattlers before', '', '%', 100),
    'rattlerShare': Quantity('rattlers', '', '%', 100),
    'contactNumberBefore': Quantity('contacts of a particle before', '', '', 1),
    'contactNumber': Quantity('contacts of a particle', '', '', 1),
    'carryingContactNumber': Quantity('contacts of a particle that is no rattler', '', '', 1),
    'contactForce': Quantity('mean contact force', '', 'N', 1),
    'carryingContactForce': Quantity('mean contact force without rattlers', '', 'N', 1),
    'forceSpread': Quantity('scatter of the contact force', '', '', 1),
    'carryingForceSpread': Quantity('scatter of the contact force without rattlers', '', '', 1),
    'inertialNumberReached': Quantity('largest inertial number', '', '', 1),
    'unbalancedForce': Quantity('unbalanced force', '', '', 1),
    'plateOverBase': Quantity('stress on the plate over that on the base', '', '', 1),
    'stepSeconds': Quantity('computing a step', '', 'ms', 1e3),
    'threads': Quantity('threads', '', '', 1),
}

X_LABELS = {'thickness': 'thickness $H$ [m]', 'aspect': 'aspect ratio $c/a$', 'n1': 'exponent $n_1$', 'n2': 'exponent $n_2$',
            'n': 'exponent $n$', 'friction': 'coefficient of friction', 'speed': 'speed $V_0$ [m/s]'}


def checkQuantity(name: str, value: Any, columns: Collection[str]) -> str:
    """`value` if it is the name of a quantity that is among the `columns` of the table."""
    known = [quantity for quantity in QUANTITIES if quantity in columns]
    if not isinstance(value, str) or value not in known:
        raise ValueError(f'{name} = {value!r}: must be one of {", ".join(known)}')
    return value


def isNumber(value: Any) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)


def allNumbers(values: Iterable[Any]) -> bool:
    """Whether the x values make an axis (else they are names, such as those of variants)."""
    return all(map(isNumber, values))


def axisLabel(y: str) -> str:
    """Label of an axis for the quantity `y`, such as 'peak force P [kN]'."""
    quantity = QUANTITIES[y]
    symbol = f' {quantity.symbol}' if quantity.symbol else ''
    unit = f' [{quantity.unit}]' if quantity.unit else ''
    return quantity.name + symbol + unit


def xAxisLabel(group: Mapping[str, Any]) -> str:
    """Label of the x axis of a plan's group: its own, or one made from the parameter's name."""
    return group.get('xLabel') or X_LABELS.get(group['xName'], group['xName'])


def xSentence(label: str, value: Any) -> str:
    """'thickness H = 0.02 m' from the label 'thickness H [m]' and the value 0.02."""
    name, _, unit = label.partition(' [')
    return f'{name} = {xText(value)} {unit.rstrip("]")}'.strip()


def plain(value: float | None, digits: int = 3) -> str:
    """A number for readers: `digits` significant ones, no exponent between 1e-3 and 1e6; '-' for nothing."""
    if value is None or not math.isfinite(value):
        return '-'
    if value == 0 or 1e-3 <= abs(value) < 1e6:
        decimals = 0 if value == 0 else max(0, digits - 1 - math.floor(math.log10(abs(value))))
        return f'{value:.{decimals}f}'
    return f'{value:.{digits}g}'


def signed(value: float) -> str:
    """A difference for readers."""
    text = plain(value)
    return text if text.startswith('-') else '+' + text


def xText(value: Any) -> str:
    """An x value for readers, as it was given."""
    return f'{value:g}' if isNumber(value) else str(value)


def counted(number: int, noun: str = 'run') -> str:
    """'1 run', '3 runs'."""
    return f'{number} {noun}{"" if number == 1 else "s"}'


def inUnit(y: str, value: float, digits: int = 3) -> str:
    """The SI value of a quantity as text in its reader's unit."""
    quantity = QUANTITIES[y]
    return f'{plain(quantity.factor * value, digits)} {quantity.unit}'.strip()
