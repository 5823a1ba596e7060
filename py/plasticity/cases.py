"""What is computed with finite elements: the five pairs of the paper, loaded and unloaded, the same without plasticity, and finer meshes."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy

from . import hertz, mesh
from .body import Body
from .contact import Contact, Load, NotConverged
from .curves import Curve
from .returnmapping import Material

if TYPE_CHECKING:
    from ..typealiases import Floats

PLATE = numpy.inf
CASES = {'5-5': (5e-3, 5e-3), '5-10': (5e-3, 10e-3), '5-plate': (5e-3, PLATE), '10-10': (10e-3, 10e-3), '10-plate': (10e-3, PLATE)}   # radii [m]
ELASTIC_CASES = ('5-5', '5-10', '10-plate')   # one each of equal spheres, unequal ones, and a plate: 5-plate and 10-10 are larger copies
REFERENCE_CASE = '5-5'   # for the meshes and for more unloadings
FIRST_LOAD = 0.7        # a/ay of the smallest load
LARGEST_GROWTH = 1.7    # of the half-width beyond sqrt(R d): in the plastic limit it goes towards sqrt(2) and more
UNLOADINGS = (0.4, 1.0)                             # where they begin: of ln(a/ay) between yield and the largest load
REFERENCE_UNLOADINGS = (0.15, 0.3, 0.4, 0.55, 0.75, 1.0)   # the same of REFERENCE_CASE
UNLOADED = 0.87         # of the way back to the residual overlap, as Hertz's law has it


class Settings(NamedTuple):
    """How finely and how far.

    fineness: of the mesh, see mesh.elementSizes; steps: loads from FIRST_LOAD to the largest; unloadSteps: of each unloading; largest: sqrt(R d)/R of
    the largest load, where small strain and flat contact end (0.15: the disc's edge is inclined by about 0.2, strains reach 0.05); convergence:
    the finenesses that are compared.
    """

    fineness: float
    steps: int
    unloadSteps: int
    largest: float
    convergence: tuple[float, ...]


FULL = Settings(fineness=0.5, steps=40, unloadSteps=8, largest=0.15, convergence=(0.35, 0.5, 0.7, 1.0))
QUICK = Settings(fineness=0.35, steps=16, unloadSteps=6, largest=0.15, convergence=(0.25, 0.35))


class Result(NamedTuple):
    """A case: its loading Curve, its unloading Curves (each from its largest overlap down to a small force), the largest plastic
    strain, the largest penetration over overlap, and how often a step was halved."""

    loading: Curve
    unloading: list[Curve]
    largestStrain: float
    largestPenetration: float
    failures: int


class Case:
    """A pair of bodies of one material.

    :param material: dict as of materialfile.read
    :param plastic: False: purely elastic
    """

    def __init__(self, name: str, material: Mapping[str, Any], settings: Settings, plastic: bool = True, fineness: float | None = None) -> None:
        self.name, self.settings = name, settings
        radii = CASES[name]
        young, poisson = material['young'], material['poisson']
        self.radius, self.modulus = hertz.effectiveRadius(*radii), hertz.effectiveModulus(young, poisson)
        self.yieldPoint = hertz.yieldPoint(material['yieldStress'], self.modulus, self.radius)
        self.largest = settings.largest * self.radius
        if self.largest <= self.yieldPoint.contactRadius:
            raise ValueError(f"yieldStress = {material['yieldStress']!r}: the contact does not yield before a/R = {settings.largest}")
        law = Material(young, poisson, material['stressStrain'] if plastic else None)
        self.contact = self._contact(radii, law, young, poisson, fineness or settings.fineness)

    def _contact(self, radii: tuple[float, float], law: Material, young: float, poisson: float, fineness: float) -> Contact:
        different = sorted(set(radii))
        reach = {radius: mesh.PLATE_REACH * different[0] if numpy.isinf(radius) else mesh.REACH * radius for radius in different}
        elementSizes = mesh.elementSizes(FIRST_LOAD * self.yieldPoint.contactRadius, self.largest, fineness)
        surfaces = mesh.surfaceRadii(elementSizes, reach.values())
        bodies = [Body(radius, surfaces[reach[radius]], elementSizes.sectors, law) for radius in different]
        return Contact(bodies, LARGEST_GROWTH * self.largest, young, poisson)

    def approaches(self, steps: int) -> Floats:
        """Approaches [m] of the loads, a/ay in equal ratios from FIRST_LOAD to the largest."""
        scaled = numpy.geomspace(FIRST_LOAD, self.largest / self.yieldPoint.contactRadius, steps)
        return scaled**2 * self.yieldPoint.overlap

    def curve(self, loads: Sequence[Load]) -> Curve:
        return Curve(self.name, self.radius, self.yieldPoint, self.modulus,
                     *(numpy.array([getattr(load, key) for load in loads]) for key in ('overlap', 'force', 'halfWidth')))

    def unload(self) -> list[Load]:
        """Loads from the present one down to about a twentieth of its force, along Hertz's law with the present disc of contact.

        The last stretch is left out: there the edge of the dent loses touch all at once, and Newton's method finds nothing. If that happens
        before, the loads end there; it is counted in contact.failures.
        """
        top = self.contact.load()
        way = UNLOADED * (0.75 * top.force / (self.modulus * top.halfWidth) - self.contact.compliance * top.force)
        loads = [top]
        try:
            for approach in top.approach - way * numpy.linspace(0, 1, self.settings.unloadSteps + 1)[1:]:
                loads.append(self.contact.press(approach))
        except NotConverged:
            pass
        return loads


def run(case: Case) -> Result:
    """Load a plastic Case to its largest load, with unloadings on the way and one at the end. Returns the Result."""
    approaches = case.approaches(case.settings.steps)
    logarithms = numpy.log(approaches / case.yieldPoint.overlap)
    shares = REFERENCE_UNLOADINGS if case.name == REFERENCE_CASE else UNLOADINGS
    unloaded = numpy.searchsorted(logarithms, numpy.array(shares) * logarithms[-1])
    loads, unloading = [], []
    for i, approach in enumerate(approaches):
        loads.append(case.contact.press(approach))
        if i in unloaded:
            unloading.append(case.curve(case.unload()))
    return Result(case.curve(loads), unloading, max(body.state.hardening.max() for body in case.contact.bodies),
                  max(load.penetration / load.overlap for load in loads), case.contact.failures)


def runElastic(case: Case) -> Curve:
    """The loading Curve of a Case without plasticity, at few loads."""
    return case.curve([case.contact.press(approach) for approach in case.approaches(max(6, case.settings.steps // 4))])


def convergence(material: Mapping[str, Any], settings: Settings) -> dict[float, tuple[int, Curve]]:
    """Loading Curves of REFERENCE_CASE on the meshes of settings.convergence, half as many loads: {fineness: (unknowns, Curve)}."""
    curves = {}
    for fineness in settings.convergence:
        case = Case(REFERENCE_CASE, material, settings, fineness=fineness)
        loads = [case.contact.press(approach) for approach in case.approaches(settings.steps // 2)]
        curves[fineness] = sum(len(body.free) for body in case.contact.bodies), case.curve(loads)
    return curves
