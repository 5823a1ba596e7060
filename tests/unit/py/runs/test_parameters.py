"""Declarations of parameters: groups, other defaults, options, old names, and parameters that stand for each other."""
import argparse
import warnings
from dataclasses import dataclass
from typing import Any

import pytest

from yade.superquadric import checks
from yade.superquadric.runs.parameters import BED, Parameters, addOptions, given, optional, parameter, redeclared


@dataclass(frozen=True, kw_only=True)
class Group(Parameters):
    TITLE = 'group'

    size: float = parameter(2.0, checks.positive, 'a size', 'm')
    gain: float | None = parameter(0.5, optional(checks.positive), 'a gain')
    loss: float | None = parameter(None, optional(checks.positive), 'a loss of 3 %', insteadOf='gain')


@dataclass(frozen=True, kw_only=True)
class Own(Group):
    TITLE = 'own'
    RENAMED = {'weight': 'mass'}

    size: float = redeclared(3.0, scope='test')
    mass: float = parameter(1.0, checks.positive, 'a mass', 'kg', 'test')

    @classmethod
    def completed(cls, values: dict[str, Any]) -> dict[str, Any]:
        return {**values, 'mass': 2 * values['size']} if values['mass'] == 99 else values

    def check(self) -> None:
        super().check()
        if self.mass > 100:
            raise ValueError(f'mass = {self.mass!r}: too heavy')


def test_whatIsRedeclaredChangesWhereItIsDeclared():
    assert Own.declarations()['size'].default == 3 and Own.declarations()['size'].unit == 'm' and Own.declarations()['size'].scope == 'test'
    assert Group.declarations()['size'].default == 2 and Group.declarations()['size'].scope == BED
    assert Own.checked({}).size == 3 and list(Own.defaults()) == ['size', 'gain', 'loss', 'mass']


def test_valuesAreCheckedAloneAndTogetherAndFilledIn():
    assert Own.checked({'mass': '7'}).mass == 7.0 and Own.checked({'mass': 99}).mass == 6
    for values, message in (({'mass': -1}, 'mass = -1: must be positive'), ({'mass': 101}, 'mass = 101.0: too heavy'),
                            ({'height': 1}, 'height = 1: there is no such parameter')):
        with pytest.raises(ValueError, match=message):
            Own.checked(values)


def test_changedOnesAreCheckedToo():
    own = Own.checked({'mass': 5})
    assert own.changed({'size': 4}) == Own.checked({'mass': 5, 'size': 4}) and own.mass == 5
    with pytest.raises(ValueError, match='size = 0'):
        own.changed({'size': 0})


def test_attributesCannotBeSet():
    with pytest.raises(AttributeError):
        Own.checked({}).mass = 3


def test_ofTwoThatStandForEachOtherTheDefaultGivesWay():
    assert (Own.checked({'loss': 0.1}).gain, Own.checked({'loss': 0.1}).loss) == (None, 0.1)
    assert Own.checked({'loss': 0.1}).changed({'gain': 0.2}).loss is None
    assert Own.checked({'gain': 0.3, 'loss': None}).gain == 0.3


def test_partsOfAScope():
    assert Own.checked({}).part(BED) == {'gain': 0.5, 'loss': None} and set(Own.checked({}).part('test')) == {'size', 'mass'}


def test_oldNamesAreReadWithAWarning():
    saved = {'size': 3.0, 'gain': 0.5, 'loss': None, 'weight': 8}
    for read, values in ((Own.checked, {'weight': 8}), (Own.checked({}).changed, {'weight': 8}), (Own.read, saved)):
        with pytest.warns(FutureWarning, match='weight is called mass now'):
            assert read(values).mass == 8
    with pytest.raises(ValueError, match='weight = 8: is called mass now, and that is given as well'):
        Own.checked({'weight': 8, 'mass': 9})


def test_whatWasSavedIsReadAsAWhole():
    own = Own.checked({'loss': 0.1})
    assert Own.read(own.asDict()) == own
    with pytest.raises(ValueError, match='the parameter mass is missing'):
        Own.read({name: value for name, value in own.asDict().items() if name != 'mass'})
    with pytest.raises(ValueError, match='height = 1: there is no such parameter'):
        Own.read({**own.asDict(), 'height': 1})


def test_optionsHaveHelpUnitDefaultAndGroup():
    parser = argparse.ArgumentParser()
    addOptions(parser, Own)
    text = ' '.join(parser.format_help().split())
    assert 'group: --size VALUE a size [m] (default: 3.0)' in text
    assert '--loss VALUE a loss of 3 % own: --mass VALUE a mass [kg] (default: 1.0)' in text
    assert 'weight' not in text
    assert given(parser.parse_args(['--mass', '4', '--weight', '5']), Own) == {'mass': '4', 'weight': '5'}
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        assert Own.checked(given(parser.parse_args(['--mass', '4']), Own)).mass == 4


def test_redeclaredMustBeDeclared():
    @dataclass(frozen=True, kw_only=True)
    class Wrong(Parameters):
        size: float = redeclared(3.0)
    with pytest.raises(TypeError, match='Wrong.size: is redeclared, but no group declares it'):
        Wrong.declarations()
