"""The measured quantities as readers see them: names, symbols, units, and numbers as text."""
from __future__ import annotations

import math
import numbers
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Quantity:
    """Of a column of the table, for readers: name, symbol (or ''), unit (or ''), and by what its SI value is multiplied to get there."""

    name: str
    symbol: str = ''
    unit: str = ''
    factor: float = 1


# Those that several experiments have.
NUMBER = Quantity('number of particles')
THICKNESS = Quantity('thickness', '$H$', 'mm', 1e3)
PACKING_FRACTION = Quantity('packing fraction', '$C_0$')
UNCERTIFIED = Quantity('uncertified solutions')
BED_SECONDS = Quantity('computing the bed', '', 's')
RUN_SECONDS = Quantity('computing the run', '', 's')
THREADS = Quantity('threads')

X_LABELS = {'thickness': 'thickness $H$ [m]', 'aspect': 'aspect ratio $c/a$', 'n1': 'exponent $n_1$', 'n2': 'exponent $n_2$',
            'n': 'exponent $n$', 'friction': 'coefficient of friction', 'speed': 'speed $V_0$ [m/s]'}


def isNumber(value: object) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)


def allNumbers(values: Iterable[object]) -> bool:
    """Whether the x values make an axis (else they are names, such as those of variants)."""
    return all(map(isNumber, values))


def axisLabel(quantity: Quantity) -> str:
    """Label of an axis, such as 'peak force P [kN]'."""
    symbol = f' {quantity.symbol}' if quantity.symbol else ''
    unit = f' [{quantity.unit}]' if quantity.unit else ''
    return quantity.name + symbol + unit


def xAxisLabel(group: Mapping[str, Any]) -> str:
    """Label of the x axis of a plan's group: its own, or one made from the parameter's name."""
    return str(group.get('xLabel') or X_LABELS.get(group['xName'], group['xName']))


def xSentence(label: str, value: object) -> str:
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


def inUnit(quantity: Quantity, value: float, digits: int = 3) -> str:
    """The SI value of a quantity as text in its reader's unit."""
    return f'{plain(quantity.factor * value, digits)} {quantity.unit}'.strip()
