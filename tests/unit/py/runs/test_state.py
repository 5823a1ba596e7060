"""The state of a run as JSON: what is read is what was written, and of another version nothing is."""
import json
from dataclasses import dataclass, field

import pytest

from yade.superquadric.runs.state import State, later


@dataclass(repr=False, eq=False, kw_only=True)
class Own(State):
    rows: list[list[float]] = field(default_factory=list)
    height: float = later()


def test_whatIsReadIsWhatWasWritten():
    state = Own(stage='pour', rows=[[1.0, 2.5]])
    assert not state.has('height') and 'height' not in state.asDict()
    again = Own.read(json.loads(json.dumps(state.asDict())))
    assert again.asDict() == state.asDict() and not again.has('height') and again.rows == [[1.0, 2.5]]
    state.height = 0.3
    assert Own.read(state.asDict()).height == 0.3


def test_whatNoStageHasSetIsNotThere():
    with pytest.raises(AttributeError):
        assert Own(stage='pour').height


@pytest.mark.parametrize('change, message', [
    ({'width': 1}, 'width is unknown'), ({'rows': None}, 'rows is missing'), ({'stage': None}, 'stage is missing')])
def test_otherVersionsAreNamed(change, message):
    content = {**Own(stage='pour', stepsLeft=3).asDict(), **change}
    with pytest.raises(ValueError, match=message):
        Own.read({name: value for name, value in content.items() if value is not None})
