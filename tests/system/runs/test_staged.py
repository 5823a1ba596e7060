"""The order of a run's stages: skipped ones, those that are done again, where a run stops, and what another version has left."""
from dataclasses import dataclass, field

import pytest
from yade import O

import yade.superquadric as sq
from yade.superquadric import checks
from yade.superquadric.files import sealed
from yade.superquadric.runs.parameters import Parameters, parameter
from yade.superquadric.runs.staged import Stage, StagedRun
from yade.superquadric.runs.state import State


@dataclass(frozen=True, kw_only=True)
class Walk(Parameters):
    rests: int = parameter(1, lambda name, value: checks.wholeNumber(name, value, 0), 'rests')
    laps: int = parameter(1, lambda name, value: checks.wholeNumber(name, value, 1), 'laps')


@dataclass(repr=False, eq=False, kw_only=True)
class WalkState(State):
    done: list[str] = field(default_factory=list)


def start(run):
    run.state.done.append('start')


def lap(run):
    run.state.done.append('lap')
    return run.state.done.count('lap') >= run.parameters.laps


def rest(run):
    run.state.done.append('rest')
    if run.state.done.count('rest') < run.parameters.rests:
        raise sq.Interrupted


def end(run):
    run.state.done.append('end')
    run.summary = {'done': run.state.done}


class WalkRun(StagedRun):
    PARAMETERS, STATE = Walk, WalkState
    STAGES = (Stage('start', start), Stage('lap', lap, backTo='start'),
              Stage('rest', rest, when=lambda run: run.parameters.rests > 0), Stage('end', end))


def begin(folder, **values):
    O.reset()
    O.engines = sq.superquadricEngines()
    return WalkRun.inFolder(str(folder), Walk.checked(values), WalkState(stage='start'), stream=None)


def test_stagesFollowEachOtherSomeSkippedSomeAgain(tmp_path):
    assert begin(tmp_path, rests=0, laps=3).run()['done'] == ['start', 'lap'] * 3 + ['end']
    assert not WalkRun.isInterrupted(str(tmp_path))


def test_untilASkippedStageStopsBehindIt(tmp_path):
    run = begin(tmp_path, rests=0)
    assert run.run(until='rest') is None and run.state.stage == 'end' and WalkRun.isInterrupted(str(tmp_path))
    assert WalkRun.resume(str(tmp_path), stream=None).run()['done'] == ['start', 'lap', 'end']


def test_anInterruptedStageIsDoneAgain(tmp_path):
    with pytest.raises(sq.Interrupted):
        begin(tmp_path, rests=2).run()
    again = WalkRun.resume(str(tmp_path), stream=None)
    assert again.state.stage == 'rest' and again.state.done == ['start', 'lap', 'rest'] and again.parameters == Walk.checked({'rests': 2})
    assert again.run()['done'] == ['start', 'lap', 'rest', 'rest', 'end']
    assert set(again.state.stageSeconds) == {'start', 'lap', 'rest', 'end'}


@pytest.mark.parametrize('change, message', [
    ({'stage': None}, 'stage is missing'), ({'steps': 7}, 'steps is unknown'), ({'parameters': {'rests': 1}}, 'the parameter laps is missing'),
    ({'parameters': {'rests': 1, 'laps': 1, 'speed': 2}}, 'speed = 2: there is no such parameter'), ({'parameters': None}, 'parameters is missing')])
def test_checkpointsOfAnotherVersionAreNotResumed(tmp_path, change, message):
    """The message says what differs and what to do; YADE's scene stays."""
    begin(tmp_path).run(until='lap')
    state = {**sealed.read(str(tmp_path / 'checkpoint.json')), **change}
    sealed.write(str(tmp_path / 'checkpoint.json'), {name: value for name, value in state.items() if value is not None}, ('checkpoint.yade.gz',))
    O.reset()
    O.tags['description'] = 'mine'
    wanted = f'output = .*: its checkpoint is of another version .{message}.; finish that run with .* or remove checkpoint.json'
    with pytest.raises(ValueError, match=wanted):
        WalkRun.resume(str(tmp_path), stream=None)
    assert O.tags['description'] == 'mine'
