"""A finished oedometer test, read back from its folder: what pictures and comparisons work on."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ...files import results
from ...measure.bed import particleVolumes
from ...measure.contactstatistics import Contacts
from ...measure.grading import Grading
from ...measure.snapshot import Snapshot
from ...runs.filenames import BEFORE, SUMMARY
from ...typealiases import Floats

CONSERVED = 1e-9        # the volume is, if it is off by no more
SLOW = 0.05             # the test is slow enough if the stresses on plate and base differ by no more

STRESS, EVENTS, PARTICLES, GRADING, NUMBERS, FORCES = TABLES = (
    'stress.csv', 'events.csv', 'particles.csv', 'grading.csv', 'contacts.csv', 'forces.csv')


class Case(NamedTuple):
    """summary: dict; stress: {column: array} of the record; before, after: `Grading`; relative: `Grading` of the fragments over the sizes of the
    first particles that they are of, None without fragments; contacts: `Contacts` at the end."""

    summary: dict[str, Any]
    stress: dict[str, Floats]
    before: Grading
    after: Grading
    relative: Grading | None
    contacts: Contacts


def columns(path: str) -> dict[str, Floats]:
    """{column: array} of a CSV file that `results.writeCsv` wrote."""
    names, rows = results.readCsv(path)
    return dict(zip(names, np.array(rows).reshape(-1, len(names)).T))


def sizesOf(snapshot: Snapshot) -> Floats:
    """Diameters (N,) [m] of the spheres of the particles' volumes."""
    return (6 / np.pi * particleVolumes(snapshot)) ** (1 / 3)


def relativeGrading(particles: Mapping[str, Floats], before: Snapshot) -> Grading | None:
    """`Grading` of the fragments' sizes over those of their first ancestors; None without fragments.

    :param particles: {column: array}, with diameter [m], ancestor (-1: none), volume; :param before: `Snapshot` of the first particles
    """
    fragments = particles['ancestor'] >= 0
    if not fragments.any():
        return None
    first = dict(zip(before.ids, sizesOf(before)))
    ancestors = np.array([first[int(ancestor)] for ancestor in particles['ancestor'][fragments]])
    return Grading(particles['diameter'][fragments] / ancestors, particles['volume'][fragments])


def load(folder: str) -> Case:
    """The `Case` in a folder.

    :raises ValueError: there is none, or a damaged one
    """
    if not os.path.exists(os.path.join(folder, SUMMARY)):
        raise ValueError(f'folder = {folder!r}: there is no finished test in it ({SUMMARY})')
    try:
        return _read(folder)
    except (KeyError, ValueError, FileNotFoundError) as error:
        raise ValueError(f'folder = {folder!r}: the test in it is damaged ({type(error).__name__}: {error})') from None


def _read(folder: str) -> Case:
    particles = columns(os.path.join(folder, PARTICLES))
    before = Snapshot.load(os.path.join(folder, BEFORE))
    return Case(results.readJson(os.path.join(folder, SUMMARY)), columns(os.path.join(folder, STRESS)), Grading(sizesOf(before)),
                Grading(particles['diameter'], particles['volume']), relativeGrading(particles, before),
                Contacts(particles['contacts'].astype(int), particles['meanForce']))
