"""Checks of what a user hands over: every function returns the accepted value or raises a ValueError that names
the parameter and the value. They are called before anything is changed."""
from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection, Mapping, Set
from numbers import Number
from typing import Any

STEPS = 10 ** 15  # of a run, at most: YADE counts them in 64 bits, and this many take years
LARGEST = 1e30  # no quantity of a bed in SI units comes near it, nor near its inverse, and products of ten such do not overflow


def shown(value: Any) -> str:
    """`value` for a message; Python writes out no whole number of thousands of digits."""
    return 'a whole number of thousands of digits' if isinstance(value, int) and abs(value) >= 10 ** 4000 else repr(value)


def finite(name: str, value: Any) -> float:
    """`value` as a finite float of at most LARGEST; True, False and arrays are no numbers, texts of numbers are."""
    try:
        if type(value).__name__ in ('bool', 'bool_') or isinstance(value, bytes) or bool(getattr(value, 'shape', None)):
            raise TypeError
        number = float(value)
    except OverflowError:
        number = math.inf
    except (TypeError, ValueError):
        raise ValueError(f'{name} = {shown(value)}: must be a number') from None
    if not math.isfinite(number):
        raise ValueError(f'{name} = {shown(value)}: must be finite')
    if abs(number) > LARGEST:
        raise ValueError(f'{name} = {shown(value)}: must not be above {LARGEST:g} in size')
    return number


def positive(name: str, value: Any) -> float:
    """`value` as a float above 0, of at least 1/LARGEST."""
    number = finite(name, value)
    if number < 1 / LARGEST:
        raise ValueError(f'{name} = {value!r}: must be positive' + (f', at least {1 / LARGEST:g}' if number > 0 else ''))
    return number


def notNegative(name: str, value: Any) -> float:
    """`value` as a float of at least 0."""
    number = finite(name, value)
    if number < 0:
        raise ValueError(f'{name} = {value!r}: must not be negative')
    return number


def within(name: str, value: Any, low: float, high: float, highIncluded: bool = True) -> float:
    """`value` as a float in [low, high], or in [low, high) without `highIncluded`."""
    number = finite(name, value)
    if not (low <= number < high or (highIncluded and number == high)):
        raise ValueError(f'{name} = {value!r}: must lie in [{low}, {high}{"]" if highIncluded else ")"}')
    return number


def above(name: str, value: Any, low: float, high: float) -> float:
    """`value` as a float in the open interval (low, high)."""
    number = finite(name, value)
    if not low < number < high:
        raise ValueError(f'{name} = {value!r}: must lie between {low} and {high}')
    return number


def wholeNumber(name: str, value: Any, least: int, most: int | None = None) -> int:
    """`value` as an int of at least `least`, and at most `most` (None: any)."""
    number = finite(name, value)
    if number != int(number) or number < least or (most is not None and number > most):
        raise ValueError(f'{name} = {value!r}: must be a whole number of at least {least}' + ('' if most is None else f' and at most {most}'))
    return value if type(value) is int else int(number)  # a float has not all digits of a large one


def path(name: str, value: Any) -> str:
    """`value` as the text of a path; TypeError for what is none. C++ cuts at null characters, and takes UTF-8 only."""
    result = os.fsdecode(value)
    if '\0' in result or any('\ud800' <= letter <= '\udfff' for letter in result):
        raise ValueError(f'{name} = {value!r}: must be of UTF-8, without null characters')
    return result


def text(name: str, value: Any) -> str:
    """`value` if it is a text."""
    if not isinstance(value, str):
        raise ValueError(f'{name} = {value!r}: must be a text')
    return value


def boolean(name: str, value: Any) -> bool:
    """`value` as bool: True or False, or (from a command line) one of these words; else ValueError."""
    words = {'true': True, 'false': False}
    if isinstance(value, bool):
        return value
    if isinstance(value, str) and value.lower() in words:
        return words[value.lower()]
    raise ValueError(f'{name} = {value!r}: must be true or false')


def oneOf(name: str, value: Any, choices: Collection[Any]) -> Any:
    """`value` if it is among `choices`."""
    if not (value is None or isinstance(value, (str, Number))) or value not in choices:
        raise ValueError(f'{name} = {value!r}: must be one of {", ".join(map(str, choices))}')
    return value


def vector(name: str, value: Any, check: Callable[[str, Any], float] = finite) -> tuple[float, float, float]:
    """Three numbers as a tuple of floats, each accepted by `check`."""
    x, y, z = _numbers(name, value, 3, 'three', check)
    return x, y, z


def pair(name: str, value: Any) -> tuple[float, float]:
    """Two finite numbers as a tuple of floats."""
    x, y = _numbers(name, value, 2, 'two', finite)
    return x, y


def _numbers(name: str, value: Any, count: int, word: str, check: Callable[[str, Any], float]) -> list[float]:
    try:
        numbers = () if isinstance(value, (str, bytes, Set, Mapping)) else tuple(value)
    except TypeError:
        numbers = ()
    if len(numbers) != count:
        raise ValueError(f'{name} = {value!r}: {word} numbers are needed')
    return [check(f'{name}[{i}]', number) for i, number in enumerate(numbers)]


def extents(name: str, value: Any) -> tuple[float, float, float]:
    """Three positive half sizes [m] as a tuple of floats."""
    return vector(name, value, positive)


def exponent(name: str, value: Any) -> float:
    """A superquadric's exponent, in [2, 20]."""
    return within(name, value, 2, 20)
