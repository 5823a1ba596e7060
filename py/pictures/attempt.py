"""Pictures at the end of a run, which its results do not depend on."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any


def attempt(run: Any, what: str, draw: Callable[[], object]) -> bool:
    """Call `draw()`; whether it went well. What a missing package, the graphics library or the disk have against it is told on the run's stream."""
    try:
        draw()
    except (ImportError, OSError, RuntimeError) as error:
        run.stepper.say(f'no pictures of {what}: {error}')
        return False
    return True
