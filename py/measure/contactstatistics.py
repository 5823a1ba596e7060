"""Distributions of the number of contacts of a particle, and of their mean force. A contact counts when it carries a normal force."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from ..typealiases import Floats, Ints

RATTLER_CONTACTS = 1  # a particle with so many or fewer is a rattler: it carries nothing (Zhao & Chi 2023: none or one contact)


class Contacts(NamedTuple):
    """Of every particle: numbers (N,) of its contacts, walls included; forces (N,): their mean normal force [N], 0 without any."""

    numbers: Ints
    forces: Floats


def ofBodies(ids: Sequence[int]) -> Contacts:
    """`Contacts` of the particles `ids` (sorted), from the scene's last step."""
    from yade import O  # the rest of this module needs no YADE
    numbers, sums = np.zeros(len(ids), dtype=int), np.zeros(len(ids))
    places = {int(body): place for place, body in enumerate(ids)}
    # YADE's own order of the contacts is another one after loading: the last digits of sums would differ.
    for interaction in sorted(O.interactions.all(onlyReal=True), key=lambda contact: (contact.id1, contact.id2)):
        force = interaction.phys.normalForce.norm()
        if not force > 0:
            continue
        for body in (interaction.id1, interaction.id2):
            place = places.get(body)
            if place is not None:
                numbers[place] += 1
                sums[place] += force
    return Contacts(numbers, np.divide(sums, numbers, out=np.zeros(len(ids)), where=numbers > 0))


def withoutRattlers(contacts: Contacts) -> Contacts:
    """Those of the particles that carry. Their contacts with rattlers still count: the measure is the paper's, one look without repetition."""
    carrying = contacts.numbers > RATTLER_CONTACTS
    return Contacts(contacts.numbers[carrying], contacts.forces[carrying])


def numberDistribution(contacts: Contacts) -> tuple[Ints, Floats]:
    """(numbers 0 ... largest, share of the particles that have so many)."""
    if not len(contacts.numbers):
        return np.zeros(0, dtype=int), np.zeros(0)
    counts = np.bincount(contacts.numbers)
    return np.arange(len(counts)), counts / counts.sum()


def forceDistribution(contacts: Contacts, edges: Floats) -> Floats:
    """Probability density of a particle's mean contact force over the mean of all of them, in the bins between `edges` [-].

    Particles beyond the edges count in the whole, so the integral over the bins is the share within them. All zeros where no force is.
    """
    mean = contacts.forces.mean() if len(contacts.forces) else 0.0
    if not mean > 0:
        return np.zeros(len(edges) - 1)
    counts, _ = np.histogram(contacts.forces / mean, edges)
    return counts / (len(contacts.forces) * np.diff(edges))


def describe(contacts: Contacts) -> dict[str, float]:
    """Numbers of a distribution, as a dict for JSON."""
    number, carrying = len(contacts.numbers), withoutRattlers(contacts)
    return {'particles': number, 'rattlerShare': 1 - len(carrying.numbers) / number if number else 0.0,
            'meanNumber': _mean(contacts.numbers), 'meanNumberWithoutRattlers': _mean(carrying.numbers),
            'largestNumber': int(contacts.numbers.max(initial=0)), 'meanForce': _mean(contacts.forces),
            'meanForceWithoutRattlers': _mean(carrying.forces), 'forceSpread': _spread(contacts.forces),
            'forceSpreadWithoutRattlers': _spread(carrying.forces)}


def _mean(values: Floats) -> float:
    return float(np.mean(values)) if len(values) else 0.0


def _spread(values: Floats) -> float:
    """Standard deviation over the mean."""
    return float(np.std(values) / np.mean(values)) if len(values) and np.mean(values) > 0 else 0.0
