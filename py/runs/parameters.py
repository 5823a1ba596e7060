"""Parameters of an experiment: typed objects, each of whose fields is declared once, with its default, unit, check, help and scope::

    @dataclass(frozen=True, kw_only=True)
    class Layer(Parameters):
        TITLE = 'layer'
        thickness: float = parameter(0.025, checks.positive, 'thickness of the bed', 'm')

Command line, JSON files, batch tables, study plans and summaries are all made from these declarations. Groups that several experiments share are
classes of their own from which an experiment inherits; where its default is another one it says so with `redeclared`.
"""
from __future__ import annotations

import argparse
import dataclasses
import warnings
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from .. import checks
from ..files import results

Check = Callable[[str, Any], Any]

BED = 'bed'  # scope of what the bed is made from: runs that differ in other scopes only share it
_KEY = 'parameter'  # of a field's metadata


@dataclass(frozen=True)
class Parameter:
    """What is declared of a parameter. `check(name, value)` returns the accepted value or raises a ValueError; `scope` says what it belongs to;
    `insteadOf`: the parameter beside which it is not given."""

    default: Any
    check: Check
    help: str
    unit: str = ''
    scope: str = BED
    insteadOf: str | None = None


def parameter(default: Any, check: Check, help: str, unit: str = '', scope: str = BED, insteadOf: str | None = None) -> Any:
    """The field of a parameter, see `Parameter`."""
    return dataclasses.field(default=default, metadata={_KEY: Parameter(default, check, help, unit, scope, insteadOf)})


def redeclared(default: Any, **changes: Any) -> Any:
    """The field of a parameter of a group that has another default in this experiment, or another check, help or scope."""
    return dataclasses.field(default=default, metadata={_KEY: {'default': default, **changes}})


@dataclass(frozen=True, kw_only=True)
class Parameters:
    """Complete parameters. `checked` makes them; whoever calls the class itself gets them as they are given, without a check."""

    TITLE: ClassVar[str] = ''                       # of the group in --help
    RENAMED: ClassVar[Mapping[str, str]] = {}       # {old name: name now}

    @classmethod
    def checked(cls, values: Mapping[str, Any]) -> Self:
        """Parameters from `values`, missing ones by default.

        :raises ValueError: an unknown name, or a value that cannot be, alone or with the others
        """
        return cls._from(cls.defaults(), values)

    def changed(self, values: Mapping[str, Any]) -> Self:
        """The same with other `values`, checked like all."""
        return self._from(self.asDict(), values)

    @classmethod
    def read(cls, values: Mapping[str, Any]) -> Self:
        """Complete parameters as they were saved; old names are read.

        :raises ValueError: they are of another version: some are missing, unknown or cannot be
        """
        given = cls.byPresentNames(values)
        missing = [name for name in cls.declarations() if name not in given]
        if missing:
            raise ValueError(f'the parameter {missing[0]} is missing')
        return cls.checked(given)

    @classmethod
    def _from(cls, base: Mapping[str, Any], values: Mapping[str, Any]) -> Self:
        given, declarations = cls.byPresentNames(values), cls.declarations()
        unknown = sorted(set(given) - set(declarations))
        if unknown:
            raise ValueError(f'{unknown[0]} = {given[unknown[0]]!r}: there is no such parameter')
        merged = _merged(base, given, declarations)
        accepted = {name: declared.check(name, merged[name]) for name, declared in declarations.items()}
        result = cls(**cls.completed(accepted))
        result.check()
        return result

    @classmethod
    def byPresentNames(cls, values: Mapping[str, Any]) -> dict[str, Any]:
        """`values` with the names that parameters have now.

        :raises ValueError: one is given by its old and by its present name
        """
        result = dict(values)
        for old, new in cls.RENAMED.items():
            if old in result:
                if new in result:
                    raise ValueError(f'{old} = {result[old]!r}: is called {new} now, and that is given as well')
                warnings.warn(f'{old} is called {new} now', FutureWarning, stacklevel=3)
                result[new] = result.pop(old)
        return result

    @classmethod
    def completed(cls, values: dict[str, Any]) -> dict[str, Any]:
        """`values`, each accepted by itself, with those filled in that follow from others."""
        return values

    def check(self) -> None:
        """ValueError for values that do not go together."""

    @classmethod
    def declarations(cls) -> dict[str, Parameter]:
        """{name: `Parameter`} of all of them."""
        return {each.name: _declaration(cls, each.name) for each in dataclasses.fields(cls)}

    @classmethod
    def groups(cls) -> dict[type[Parameters], list[str]]:
        """{class that declares them: names}, in the order of the declarations."""
        groups: dict[type[Parameters], list[str]] = {}
        for name in cls.declarations():
            owner = next(kind for kind in reversed(cls.__mro__) if name in vars(kind).get('__dataclass_fields__', {}))
            groups.setdefault(owner, []).append(name)
        return groups

    @classmethod
    def defaults(cls) -> dict[str, Any]:
        """{name: default} of all parameters."""
        return {name: declared.default for name, declared in cls.declarations().items()}

    def asDict(self) -> dict[str, Any]:
        """{name: value} of all parameters, for JSON."""
        return {each.name: getattr(self, each.name) for each in dataclasses.fields(self)}

    def part(self, scope: str) -> dict[str, Any]:
        """{name: value} of those that belong to the `scope`."""
        return {name: getattr(self, name) for name, declared in self.declarations().items() if declared.scope == scope}


def _declaration(kind: type[Parameters], name: str) -> Parameter:
    """That of the class that declares the parameter, with what the classes derived from it declare otherwise."""
    changes: dict[str, Any] = {}
    for owner in kind.__mro__:
        own = vars(owner).get('__dataclass_fields__', {}).get(name)
        found = own.metadata[_KEY] if own is not None else {}
        if isinstance(found, Parameter):
            return dataclasses.replace(found, **changes)
        changes = {**found, **changes}
    raise TypeError(f'{kind.__name__}.{name}: is redeclared, but no group declares it')


def _merged(base: Mapping[str, Any], given: Mapping[str, Any], declarations: Mapping[str, Parameter]) -> dict[str, Any]:
    """`base` with what is `given` in its place. Of two parameters that stand for each other, the one that is not given gives way."""
    result = {**base, **given}
    for name, declared in declarations.items():
        if declared.insteadOf is not None:
            for one, other in ((name, declared.insteadOf), (declared.insteadOf, name)):
                if given.get(one) is not None and other not in given:
                    result[other] = None
    return result


def optional(check: Check) -> Check:
    """Of a value that may be None."""
    return lambda name, value: None if value is None else check(name, value)


def oneOf(choices: Collection[str]) -> Check:
    return lambda name, value: checks.oneOf(name, value, choices)


def between(low: float, high: float) -> Check:
    """In the open interval."""
    return lambda name, value: checks.above(name, value, low, high)


def within(low: float, high: float, highIncluded: bool = True) -> Check:
    return lambda name, value: checks.within(name, value, low, high, highIncluded)


def count(least: int) -> Check:
    return lambda name, value: checks.wholeNumber(name, value, least)


def addOptions(parser: argparse.ArgumentParser, kind: type[Parameters]) -> None:
    """An option for each of the parameters, by groups. Values stay text: the checks turn them into numbers and name what is wrong."""
    declarations = kind.declarations()
    for group, names in kind.groups().items():
        section = parser.add_argument_group(group.TITLE)
        for name in names:
            declared = declarations[name]
            unit = f' [{declared.unit}]' if declared.unit else ''
            default = '' if declared.default is None else f' (default: {declared.default})'
            section.add_argument('--' + name, metavar='VALUE', default=argparse.SUPPRESS, help=(declared.help + unit + default).replace('%', '%%'))
    for old in kind.RENAMED:
        parser.add_argument('--' + old, default=argparse.SUPPRESS, help=argparse.SUPPRESS)


def given(options: argparse.Namespace, kind: type[Parameters]) -> dict[str, Any]:
    """{name: value} of those parameters that are among the parsed `options`."""
    return {name: value for name, value in vars(options).items() if name in {**kind.defaults(), **kind.RENAMED}}


def fromFile(path: str | None) -> dict[str, Any]:
    """{name: value} from a JSON file; nothing without a `path`."""
    content = results.readJson(path) if path else {}
    if not isinstance(content, dict):
        raise ValueError(f'parameters = {path!r}: must hold one object {{name: value}}')
    return content
