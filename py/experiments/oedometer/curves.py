"""Curves of oedometer tests in studies: means over the beds with their bands, a line per point; like the figures of Zhao & Chi (2023)."""
from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy

from ...measure import contactstatistics
from ...measure.contactstatistics import Contacts
from ...measure.grading import Grading
from ...pictures.style import COLOURS, newFigure, outerLegend
from ...statistics.curves import meanCurve
from ...typealiases import Floats
from ..quantities import xText
from . import case as oedometercase
from .case import Case
from .plots import FORCE_EDGES, LABELS, RELATIVE_LOWEST, SIDES, plainTicks

SAMPLES = 400
FINEST = 1e-3           # of the mass: below, the axis of sizes ends
MOST_CONTACTS = 25      # of a particle, on the axis
RAREST = 1e-3           # probability density at which the axis of forces ends: in a bin less than one particle of 1,000


def drawStresses(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Axial and lateral stress over strain, void ratio over axial stress, number of particles over strain."""
    figure, ((strains, voids, numbers),) = newFigure(3, 1, 4.4, 3.8)
    for label, colour, cases, _ in _lines(data, series, values, records):
        tests = [case.stress for case in cases]
        at = numpy.linspace(0, max(test['strain'][-1] for test in tests), SAMPLES)
        for panel, column, unit, style in ((strains, 'plateStress', 1e-6, {'label': label}), (strains, 'lateralStress', 1e-6, {'lw': 0.9, 'ls': ':'}),
                                           (numbers, 'particles', 1, {})):
            _drawBand(panel, at, [(test['strain'], unit * test[column]) for test in tests], colour, 100, **style)
        # The highest stress so far: the record goes down at times.
        highest = [numpy.maximum.accumulate(test['plateStress']) for test in tests]
        at = numpy.geomspace(max(stress[0] for stress in highest), max(stress[-1] for stress in highest), SAMPLES)
        _drawBand(voids, at, [(stress, test['voidRatio']) for stress, test in zip(highest, tests)], colour, 1e-6)
    strains.set(**LABELS['strains'], ylim=(0, None))
    voids.set(**LABELS['voids'])
    numbers.set(**LABELS['particles'])
    plainTicks(voids)
    outerLegend(figure, (strains,))
    return figure


def drawGradings(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Grading curves before and after; and of the fragments, over the sizes of the particles that they are of."""
    figure, ((whole, relative),) = newFigure(2, 1, 5.2, 4.0)
    lowest, largest = 1.0, 0.0
    known: set[frozenset[str]] = set()
    for label, colour, cases, beds in _lines(data, series, values, records):
        finest, coarsest = min(case.after.size(FINEST) for case in cases), max(case.before.sizes[-1] for case in cases)
        lowest, largest = min(lowest, finest), max(largest, coarsest)
        sizes = numpy.geomspace(finest, 1.001 * coarsest, SAMPLES)
        if beds not in known:   # lines on the same beds begin alike
            first = None if known else 'before'
            known.add(beds)
            _drawBand(whole, sizes, _finer([case.before for case in cases], sizes), 'black', 1e3, ls='--', label=first)
        _drawBand(whole, sizes, _finer([case.after for case in cases], sizes), colour, 1e3, label=label)
        fragments = [case.relative for case in cases if case.relative is not None]
        if fragments:
            sizes = numpy.geomspace(RELATIVE_LOWEST, 1, SAMPLES)
            _drawBand(relative, sizes, _finer(fragments, sizes), colour, 1)
    whole.set(**LABELS['specimen'], xlim=(1e3 * lowest, 1.05e3 * largest))
    relative.set(**LABELS['fragments'])
    plainTicks(whole)
    plainTicks(relative)
    outerLegend(figure, (whole,))
    return figure


def drawContacts(data: Any, series: Sequence[str], values: Sequence[Any], panels: str, records: str) -> Any:
    """Distributions of contact number and mean contact force, with rattlers (left) and without (right)."""
    figure, axes = newFigure(2, 2, 4.6, 3.2)
    numbers, middles = numpy.arange(MOST_CONTACTS + 1), (FORCE_EDGES[1:] + FORCE_EDGES[:-1]) / 2
    for label, colour, cases, _ in _lines(data, series, values, records):
        for column, choice in enumerate((lambda contacts: contacts, contactstatistics.withoutRattlers)):
            chosen = [choice(case.contacts) for case in cases]
            shares = [(numbers, _shares(contacts, numbers)) for contacts in chosen]
            densities = [(middles, contactstatistics.forceDistribution(contacts, FORCE_EDGES)) for contacts in chosen]
            _drawBand(axes[0, column], numbers, shares, colour, 1, marker='o', ms=3, label=label)
            _drawBand(axes[1, column], middles, densities, colour, 1, RAREST, marker='o', ms=3)
    for column, title in enumerate(SIDES):
        axes[0, column].set(**LABELS['numbers'], title=title, ylim=(0, None))
        axes[1, column].set(**LABELS['forces'], ylim=(RAREST, None))
    outerLegend(figure, (axes[0, 0],))
    return figure


class _Line(NamedTuple):
    """A line of the pictures: the finished tests of a point, and the beds that they are on."""

    label: str
    colour: str
    cases: list[Case]
    beds: frozenset[str]


def _lines(data: Any, series: Sequence[str], values: Sequence[Any], records: str) -> Iterator[_Line]:
    """Of every point that has finished tests."""
    points = [(name, x) for name in series for x in values if len(data.rows(name, x))]
    severalValues = len({x for _, x in points}) > 1
    for k, (name, x) in enumerate(points):
        label = f'{name} {xText(x)}'.strip() if severalValues or not name else name
        rows = data.rows(name, x)
        cases = [oedometercase.load(os.path.join(records, run)) for run in rows['run']]
        yield _Line(label, COLOURS[k % len(COLOURS)], cases, frozenset(rows['bed']))


def _drawBand(axes: Any, at: Floats, curves: Sequence[tuple[Floats, Floats]], colour: str, unit: float, lowest: float | None = None,
              **style: Any) -> None:
    """Mean of `curves` [(x, y)] at `at` with its band over the beds; `unit`: of x; `lowest`: what is below is not there (on logarithmic axes)."""
    mean, half = meanCurve(curves, at)
    if lowest is not None:
        mean = numpy.where(mean >= lowest, mean, numpy.nan)
        half = numpy.minimum(half, mean - lowest)
    if numpy.isfinite(half).any():
        axes.fill_between(unit * at, mean - half, mean + half, color=colour, alpha=0.15, lw=0)
    axes.plot(unit * at, mean, color=colour, **{'lw': 1.5, **style})


def _finer(gradings: Sequence[Grading], sizes: Floats) -> list[tuple[Floats, Floats]]:
    """[(sizes, mass finer [%])]"""
    return [(sizes, 100 * grading.finer(sizes)) for grading in gradings]


def _shares(contacts: Contacts, numbers: Floats) -> Floats:
    """Share of the particles that have so many contacts, for each of `numbers` 0, 1, ..."""
    found = contactstatistics.numberDistribution(contacts)[1]
    return numpy.pad(found, (0, max(0, len(numbers) - len(found))))[:len(numbers)]
