"""What a resumed run has to know beside scene and parameters, as typed fields, and its form as JSON."""
from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Self

_LATER = 'later'  # of a field's metadata


def later() -> Any:
    """A field that is absent until a stage sets it."""
    return field(init=False, metadata={_LATER: True})


@dataclass(repr=False, eq=False, kw_only=True)
class State:
    """Plain numbers, texts, lists and dicts, as they are in JSON; each kind of run adds its own."""

    stage: str                                                     # that is under way, or next
    seconds: float = 0.0                                           # wall time so far
    stageSeconds: dict[str, float] = field(default_factory=dict)   # of each stage
    solver: dict[str, int] = field(default_factory=dict)           # counters of the contact solvers
    stepsLeft: int | None = None                                   # of the portion in which the run was interrupted

    def has(self, name: str) -> bool:
        """Whether a stage has set the field."""
        return hasattr(self, name)

    def asDict(self) -> dict[str, Any]:
        """The fields that are set, for JSON."""
        return {each.name: getattr(self, each.name) for each in dataclasses.fields(self) if hasattr(self, each.name)}

    @classmethod
    def read(cls, content: Mapping[str, Any]) -> Self:
        """The state of which `content` is what `asDict` gave.

        :raises ValueError: a field is missing, or unknown
        """
        fields = {each.name: each for each in dataclasses.fields(cls)}
        for name in content:
            if name not in fields:
                raise ValueError(f'{name} is unknown')
        for name, each in fields.items():
            if name not in content and _LATER not in each.metadata:
                raise ValueError(f'{name} is missing')
        state = cls(**{name: value for name, value in content.items() if fields[name].init})
        for name, value in content.items():
            setattr(state, name, value)
        return state


@dataclass(repr=False, eq=False, kw_only=True)
class BedState(State):
    """Of a run on a bed, whether it makes the bed itself or takes a finished one."""

    container: dict[str, Any] = later()   # `scene.container.Container` by its fields
    bedSeconds: float = later()           # wall time that the bed took
