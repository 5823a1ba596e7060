"""Lists of parameters of an experiment: their kind, the checks that they are made with, and the options they become."""
import argparse
from collections import namedtuple

from .. import checks
from ..files import results

Parameter = namedtuple('Parameter', 'name default unit check help scope')
Parameter.__doc__ = """A parameter of an experiment. `check(name, value)` returns the accepted value or raises a ValueError; `scope` says what it
belongs to: runs that differ only in other scopes share it (a bed, say)."""


def optional(check):
    """Of a value that may be None."""
    return lambda name, value: None if value is None else check(name, value)


def oneOf(choices):
    return lambda name, value: checks.oneOf(name, value, choices)


def between(low, high):
    """In the open interval."""
    return lambda name, value: checks.above(name, value, low, high)


def within(low, high, highIncluded=True):
    return lambda name, value: checks.within(name, value, low, high, highIncluded)


def count(least):
    return lambda name, value: checks.wholeNumber(name, value, least)


def defaultsOf(parameters):
    """{name: default} of all `parameters`."""
    return {parameter.name: parameter.default for parameter in parameters}


def scopeOf(values, parameters, scope):
    """Those of the complete `values` that belong to the `scope`."""
    return {parameter.name: values[parameter.name] for parameter in parameters if parameter.scope == scope}


def completed(values, parameters):
    """All `parameters` as a dict, each accepted by its own check: from `values`, missing ones by default.

    :raises ValueError: an unknown name, or a value that cannot be
    """
    unknown = sorted(set(values) - set(defaultsOf(parameters)))
    if unknown:
        raise ValueError(f'{unknown[0]} = {values[unknown[0]]!r}: there is no such parameter')
    return {p.name: p.check(p.name, values.get(p.name, p.default)) for p in parameters}


def addOptions(parser, parameters):
    """An option for each of the `parameters`. Values stay text: the experiment's own checks turn them into numbers and name what is wrong."""
    for parameter in parameters:
        unit = f' [{parameter.unit}]' if parameter.unit else ''
        default = '' if parameter.default is None else f' (default: {parameter.default})'
        parser.add_argument('--' + parameter.name, metavar='VALUE', default=argparse.SUPPRESS,
                            help=(parameter.help + unit + default).replace('%', '%%'))


def given(options, parameters):
    """{name: value} of those `parameters` that are among the parsed `options`."""
    names = {parameter.name for parameter in parameters}
    return {name: value for name, value in vars(options).items() if name in names}


def fromFile(path):
    """{name: value} from a JSON file; nothing without a `path`."""
    content = results.readJson(path) if path else {}
    if not isinstance(content, dict):
        raise ValueError(f'parameters = {path!r}: must hold one object {{name: value}}')
    return content
