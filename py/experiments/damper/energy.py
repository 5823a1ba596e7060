"""The energy account of a damper, from what YADE, contact law and box have booked in O.energy."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

CLOSED = 0.01  # of the work: an account that is off by more is not closed
STEADY = 0.1   # of the work: what else goes into stored energy, or comes out of it

SOURCES = ('boxDrive', 'gravWork')  # negative of the work that comes from outside
STATES = ('kinetic', 'elastPotential', 'boxKinetic', 'boxSpring')  # energy that is there now
ERRORS = ('nonconservative',)  # what elastic forces without a potential have taken out, not a sink


def sinks(energies: Mapping[str, float]) -> list[str]:
    """Names of what takes energy out, whatever the contact law calls it."""
    return [name for name in sorted(energies) if name not in SOURCES + STATES + ERRORS]


def account(before: Mapping[str, float], after: Mapping[str, float]) -> dict[str, Any]:
    """What has happened to the energy between two moments, as a dict for JSON. [J]; shares of all that was dissipated; [-].

    :param before, after: {name: energy}, as O.energy has them

    `balanceError` is what all entries together have gained, over the work of the drive: 0 but for the error of the time step. YADE's
    kinetic energy belongs to half a step before, which is no more than that.
    """
    change = {name: after[name] - before.get(name, 0.0) for name in after}
    dissipated = {name: change[name] for name in sinks(after)}
    total, work = sum(dissipated.values()), -change.get('boxDrive', 0.0)
    return {'work': work, 'gravityWork': -change.get('gravWork', 0.0), 'dissipated': total, 'sinks': dissipated,
            'shares': {name: value / total for name, value in dissipated.items()} if total else {},
            'stored': sum(change.get(name, 0.0) for name in STATES), 'nonconservative': sum(change.get(name, 0.0) for name in ERRORS),
            'balanceError': sum(change.values()) / work if work else 0.0}


def isSteady(energy: Mapping[str, Any]) -> bool:
    """Whether what an `account` says was stored or given back is little beside the work; a box that nothing damps counts as steady."""
    return not energy['dissipated'] or abs(energy['stored']) <= STEADY * abs(energy['work'])
