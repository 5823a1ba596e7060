"""Two bodies pressed together without friction: displacements of both by Newton's method, for given approaches of their far ends.

The bodies meet where they have the same r, as displacements are small. Pressure is stiff: p = stiffness * (what the bodies overlap), at two Gauss
points an element, so that there are no more conditions than displacements that can meet them. What they overlap is far below the
approach, and taken off it.
"""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy
from scipy import sparse
from scipy.sparse.linalg import splu

from . import hertz, mesh

if TYPE_CHECKING:
    from ..typealiases import Floats
    from .body import Body
    from .returnmapping import State

TOLERANCE = 1e-6            # of the residual's largest component over the largest contact force before
ITERATIONS = 25             # of Newton's method, before the step is halved
SHORTENINGS = 4             # of one correction
HOPELESS = 1e4              # residual from which it does not come back
HALVINGS = 8                # of one step, before the case is given up
EDGE_POINTS = 4             # outside the contact, that tell where it ends
STIFFNESS = 3e3             # of the contact, in E*/(largest half-width): penetration below 0.4 % of the approach
GAUSS = 1 / numpy.sqrt(3)   # points of Gauss's rule on [-1, 1]


class Load(NamedTuple):
    """A state of equilibrium.

    approach: of the far ends [m]; overlap: the same for bodies that go on without end and do not penetrate, as Hertz's [m]; force [N];
    halfWidth: radius of the disc of contact [m]; penetration: mean, weighted by the pressure [m].
    """

    approach: float
    overlap: float
    force: float
    halfWidth: float
    penetration: float


class System(NamedTuple):
    """What trial displacements bring about: of each body the residual forces [N], the stiffness [N/m] and the State they would lead
    to; the stiffness of the points of contact [N/m]; the contact force [N]; the largest residual over the contact force."""

    residuals: list[Floats]
    matrices: list[Any]
    spring: Floats
    states: list[State]
    force: float
    error: float


class NotConverged(Exception):
    """Newton's method found no equilibrium."""


class Interface:
    """Where bodies may touch: Gauss points on the surface up to `reach` [m].

    :ivar r, weights: of the points [m], [m^2]; the weights add up to the area
    :ivar interpolations: for each body the sparse matrix from its displacement to the normal one at the points
    """

    def __init__(self, bodies: Sequence[Body], reach: float) -> None:
        corners = numpy.concatenate(([0], bodies[0].surface))
        corners = corners[:numpy.searchsorted(corners, reach) + 1]
        half, middle = numpy.diff(corners) / 2, (corners[1:] + corners[:-1]) / 2
        places = numpy.array([-GAUSS, GAUSS])
        self.r = (middle[:, None] + half[:, None] * places).ravel()
        self.weights = 2 * numpy.pi * self.r * numpy.repeat(half, 2)
        shapes = numpy.array([places * (places - 1) / 2, 1 - places**2, places * (places + 1) / 2]).T   # left, middle, right node
        elements = numpy.arange(len(half))
        nodes = 2 * numpy.repeat(elements, 6) + numpy.tile([0, 1, 2], 2 * len(half))
        points = numpy.repeat(numpy.arange(len(self.r)), 3)
        values = numpy.tile(shapes.ravel(), len(half))
        self.interpolations = [sparse.csr_matrix((values, (points, body.normals[nodes])), shape=(len(self.r), body.size))
                               for body in bodies]


class Contact:
    """Bodies in contact, with their displacements.

    :param bodies: one body (it meets its mirror image) or two; their rings agree up to `reach`
    :param reach: r up to which they may touch [m]
    :param young, poisson: of both bodies
    :ivar approach, displacements: of the last equilibrium [m]; largest: force so far [N]
    :ivar compliance: of the far ends [m/N]
    :ivar failures: how often Newton's method failed and the step was halved
    """

    def __init__(self, bodies: Sequence[Body], reach: float, young: float, poisson: float) -> None:
        self.bodies, self.copies = bodies, 3 - len(bodies)
        self.young, self.poisson = young, poisson
        self.modulus = hertz.effectiveModulus(young, poisson)
        self.interface = Interface(bodies, reach)
        self.stiffness = STIFFNESS * self.modulus / reach
        self.gap = self.copies * sum(mesh.depth(body.radius, self.interface.r) for body in bodies)
        self.approach, self.displacements = 0.0, [numpy.zeros(body.size) for body in bodies]
        self.largest, self.failures = 0.0, 0
        self._last = self.approach, self.displacements   # the equilibrium before
        self.compliance = self._farCompliance(reach / 3)

    def _farCompliance(self, width: float) -> float:
        """What the cut-off far ends would give way [m/N]: a half-space's displacement minus the body's, both elastic and under the same
        pressure of unit force, exp(-(r/width)^2). As long as the loaded place is small it hardly matters how the load is spread there."""
        pressure = numpy.exp(-(self.interface.r / width)**2)
        pressure /= self.interface.weights @ pressure
        total = 0.0
        for body, interpolation in zip(self.bodies, self.interface.interpolations):
            load = interpolation.T @ (self.interface.weights * pressure)
            displacement = splu(body.elastic[body.free][:, body.free]).solve(load[body.free])
            total += hertz.meanDisplacement(self.young, self.poisson, width) - load[body.free] @ displacement
        return self.copies * total

    def press(self, approach: float) -> Load:
        """Move the far ends to `approach` [m] and find the equilibrium, in halved steps where needed. Returns the Load.

        :raises NotConverged: also the smallest step failed; the bodies stay at the last equilibrium
        """
        halvings, step = 0, approach - self.approach
        while self.approach != approach:
            target = approach if abs(approach - self.approach) <= abs(step) * (1 + 1e-9) else self.approach + step
            try:
                self._solve(target)
            except NotConverged:
                self.failures += 1
                halvings += 1
                step /= 2
                if halvings > HALVINGS:
                    raise
        return self.load()

    def load(self) -> Load:
        """The Load of the present equilibrium."""
        pressure = self._pressure(self.displacements, self.approach)
        force = float(self.interface.weights @ pressure)
        penetration = float(self.interface.weights @ pressure**2) / self.stiffness / force if force else 0.0
        overlap = self.approach + self.compliance * force - penetration
        return Load(float(self.approach), overlap, force, self._halfWidth(pressure), penetration)

    def _pressure(self, displacements: Sequence[Floats], approach: float) -> Floats:
        return self.stiffness * numpy.maximum(0, -self._gap(displacements, approach))

    def _gap(self, displacements: Sequence[Floats], approach: float) -> Floats:
        surface = sum(interpolation @ displacement for interpolation, displacement in zip(self.interface.interpolations, displacements))
        return self.gap + self.copies * surface - approach

    def _halfWidth(self, pressure: Floats) -> float:
        """Radius of the disc of contact: where the gap outside begins. Near the edge its power 2/3 rises along a straight line over r^2, as
        Hertz's does; the points of contact themselves only tell in which element the edge is."""
        touching = numpy.nonzero(pressure)[0]
        if not len(touching):
            return 0.0
        outside = slice(touching[-1] + 1, touching[-1] + 1 + EDGE_POINTS)
        gap = self._gap(self.displacements, self.approach)[outside]
        slope, start = numpy.polyfit(self.interface.r[outside]**2, gap**(2 / 3), 1)
        return float(numpy.sqrt(max(0.0, -start / slope))) if slope > 0 else float(self.interface.r[touching[-1]])

    def _solve(self, approach: float) -> None:
        """Newton's method, with shorter steps where a full one makes the residual grow; accepts the equilibrium it finds."""
        displacements = self._guess(approach)
        system = self._system(displacements, approach)
        for _ in range(ITERATIONS):
            if system.error <= TOLERANCE:
                self._accept(approach, displacements, system)
                return
            if not system.error < HOPELESS:   # or no number
                break
            direction = self._correction(system.matrices, system.spring, [-residual for residual in system.residuals])
            displacements, system = self._step(displacements, system, direction, approach)
        raise NotConverged(f'no equilibrium at an approach of {approach} m after {ITERATIONS} iterations')

    def _step(self, displacements: Sequence[Floats], system: System, direction: Sequence[Floats], approach: float) -> tuple[list[Floats], System]:
        """Displacements with (part of) the correction `direction`, and their System: the first of the lengths 1, 1/2, ... with a smaller
        residual; if there is none, the shortest."""
        length = 1.0
        for _ in range(SHORTENINGS + 1):
            tried = [displacement + length * step for displacement, step in zip(displacements, direction)]
            there = self._system(tried, approach)
            if there.error < system.error:
                break
            length /= 2
        return tried, there

    def _guess(self, approach: float) -> list[Floats]:
        """Displacements that go on as from the equilibrium before to the present one; where the path begins or turns, those of elastic bodies
        whose disc of contact stays as it is."""
        before, displacements = self._last
        way = (approach - self.approach) * (self.approach - before)
        if way > 0:
            way /= (self.approach - before)**2
            return [present + way * (present - past) for present, past in zip(self.displacements, displacements)]
        spring = self.stiffness * self.interface.weights * (self._pressure(self.displacements, self.approach) > 0)
        loads = [interpolation.T @ (spring * (approach - self.approach)) for interpolation in self.interface.interpolations]
        correction = self._correction([body.elastic for body in self.bodies], spring, loads)
        return [displacement + step for displacement, step in zip(self.displacements, correction)]

    def _correction(self, matrices: Sequence[Any], spring: Floats, loads: Sequence[Floats]) -> list[Floats]:
        """The displacements that `loads` [N] bring about in bodies with the stiffness `matrices` [N/m], held together by `spring` [N/m] at
        the points of contact.

        :raises NotConverged: the matrix is singular
        """
        blocks: list[list[Any]] = []
        springs = sparse.diags(self.copies * spring)
        for body, matrix, own in zip(self.bodies, matrices, self.interface.interpolations):
            row = [own.T @ springs @ other for other in self.interface.interpolations]
            row[len(blocks)] = row[len(blocks)] + matrix
            blocks.append([block[body.free][:, partner.free] for block, partner in zip(row, self.bodies)])
        load = numpy.concatenate([load[body.free] for load, body in zip(loads, self.bodies)])
        try:
            solution = splu(sparse.bmat(blocks, format='csc'), permc_spec='MMD_AT_PLUS_A', diag_pivot_thresh=0,
                            options={'SymmetricMode': True}).solve(load)
        except RuntimeError as error:
            raise NotConverged(f'the matrix cannot be inverted: {error}') from None
        corrections = []
        for body, part in zip(self.bodies, numpy.split(solution, numpy.cumsum([len(body.free) for body in self.bodies])[:-1])):
            corrections.append(numpy.zeros(body.size))
            corrections[-1][body.free] = part
        return corrections

    def _system(self, displacements: Sequence[Floats], approach: float) -> System:
        """The System at the displacements."""
        pressure = self._pressure(displacements, approach)
        weights = self.interface.weights
        force, error, residuals, matrices, states = weights @ pressure, 0.0, [], [], []
        for body, displacement, interpolation in zip(self.bodies, displacements, self.interface.interpolations):
            internal, matrix, state = body.internal(displacement)
            residuals.append(internal - interpolation.T @ (weights * pressure))
            matrices.append(matrix)
            states.append(state)
            error = max(error, numpy.abs(residuals[-1][body.free]).max())
        scale = self.largest or force or numpy.finfo(float).tiny
        return System(residuals, matrices, self.stiffness * weights * (pressure > 0), states, force, error / scale)

    def _accept(self, approach: float, displacements: list[Floats], system: System) -> None:
        self._last = self.approach, self.displacements
        self.approach, self.displacements, self.largest = approach, displacements, max(system.force, self.largest)
        for body, state in zip(self.bodies, system.states):
            body.state = state
