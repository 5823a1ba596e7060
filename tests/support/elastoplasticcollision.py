"""One collision of a ball with a wall or with a like ball under the elastoplastic law, and its energies."""
import math

from yade import O, utils
from yade.minieigenHP import Vector3
from yade.wrapper import ElastoplasticMat

import yade.superquadric as sq

RADIUS = 2.5e-3  # [m]
# About aluminium, with a hardening that is well below Hertz at all overlaps.
ALUMINIUM = dict(young=70e9, poisson=0.33, density=2700, frictionAngle=0, yieldStress=100e6, m0=2.6, exponent=1.8)
ALL_DISSIPATE = dict(frictionAngle=math.atan(0.3), normalDamping=0.05, tangentialDamping=0.05, rollingFriction=0.05, rollingDamping=0.1)
KINDS = ('Sphere', 'Superquadric')
PARTNERS = ('wall', 'ball')
SINKS = ('yieldDissip', 'normDampDissip', 'shearDampDissip', 'plastDissip', 'rollingDampDissip', 'rollingDissip')


def effectiveModulus(material):
    return material.young / (2 * (1 - material.poisson ** 2))


def effectiveRadius(partner):
    return RADIUS if partner == 'wall' else RADIUS / 2


def yieldOverlap(material, radius):
    """(6) of Li et al.: dy = (pi p_y/(2E))^2 R with p_y = 1.6 sigma_y [m]."""
    return (math.pi * 1.6 * material.yieldStress / (2 * effectiveModulus(material))) ** 2 * radius


def yieldSpeed(material, radius, mass):
    """Speed that just reaches yield: m v^2/2 = 2/5 K dy^(5/2) [m/s]."""
    hertz = 4 / 3 * effectiveModulus(material) * math.sqrt(radius)
    return math.sqrt(4 / 5 * hertz * yieldOverlap(material, radius) ** 2.5 / mass)


def elasticDuration(material, radius, mass, speed):
    """Of Hertz's collision (Johnson: 2.87 (m^2/(R E^2 v))^(1/5)) [s]."""
    return 2.87 * (mass ** 2 / (radius * effectiveModulus(material) ** 2 * speed)) ** 0.2


def ball(kind, position, material):
    if kind == 'Sphere':
        return utils.sphere(position, RADIUS, material=material)
    return sq.superquadric(position, (RADIUS,) * 3, 2, 2, material=material)


class Collision:
    """A ball just above a wall at z = 0, or just above a like ball, about to touch it in the first step, in a new scene.

    :param velocity, spin: of the upper ball relative to the other one [m/s], [rad/s]
    :param steps: per duration of the elastic collision of the same normal speed
    :param more: attributes of the material other than ALUMINIUM's
    """

    def __init__(self, kind, partner, velocity, spin=(0, 0, 0), steps=1000, **more):
        O.reset()
        self.material = ElastoplasticMat(**{**ALUMINIUM, **more})
        O.materials.append(self.material)
        self.radius = effectiveRadius(partner)
        if partner == 'wall':
            O.bodies.append(utils.wall(0, axis=2, material=self.material))
        else:
            O.bodies.append(ball(kind, (0, 0, -RADIUS), self.material))
        O.bodies.append(ball(kind, (0, 0, RADIUS), self.material))
        self.states = [body.state for body in O.bodies if body.dynamic]
        self.speed = -velocity[2]
        self.mass = self.states[0].mass / len(self.states)
        self._setMotion(Vector3(*velocity), Vector3(*spin))
        O.engines = sq.superquadricEngines(gravity=(0, 0, 0), verletDist=0.1 * RADIUS)
        O.trackEnergy = True
        O.dt = elasticDuration(self.material, self.radius, self.mass, self.speed) / steps
        assert O.dt < 0.3 * sq.criticalTimeStep()

    def _setMotion(self, velocity, spin):
        part = 1 / len(self.states)  # with two balls their centre of mass rests
        for sign, state in zip((1, -1), reversed(self.states)):
            state.vel, state.angVel = sign * part * velocity, sign * part * spin
            state.angMom = Vector3(*(i * w for i, w in zip(state.inertia, state.angVel)))

    def contact(self):
        return O.interactions[0, 1] if O.interactions.has(0, 1) and O.interactions[0, 1].isReal else None

    def kineticEnergy(self):
        return sum(s.mass * s.vel.squaredNorm() + sum(i * w * w for i, w in zip(s.inertia, s.angVel)) for s in self.states) / 2

    def run(self, everyStep=lambda contact: None):
        """Step until the bodies have parted; `everyStep` is called with each step's contact."""
        touched = False
        while not touched or self.contact():
            O.step()
            contact = self.contact()
            touched = touched or contact is not None
            assert touched or O.iter < 10
            if contact:
                everyStep(contact)
        return self

    def imbalance(self):
        """Run, and the largest deviation of kinetic energy and all entries from their sum at the start, as a part of it.

        Velocities belong to half steps and forces to whole ones: the kinetic energy at a whole step is the mean of its neighbours.
        """
        kinetic, others = [self.kineticEnergy()], []

        def record(contact=None):
            kinetic.append(self.kineticEnergy())
            others.append(sum(booked().values()))

        self.run(record)
        record()  # the step in which they have parted
        return max(abs((before + after) / 2 + other - kinetic[0]) for before, after, other in zip(kinetic, kinetic[1:], others)) / kinetic[0]

    def restitution(self):
        up, low = O.bodies[1].state.vel[2], O.bodies[0].state.vel[2]
        return (up - low) / self.speed


class Prescribed:
    """A ball on a like one, both held, of which the upper one is moved in steps as told, in a new scene without an integrator."""

    def __init__(self, kind='Sphere', **more):
        O.reset()
        self.material = ElastoplasticMat(**{**ALUMINIUM, **more})
        O.materials.append(self.material)
        O.bodies.append([ball(kind, (0, 0, sign * RADIUS), self.material) for sign in (-1, 1)])
        O.engines = sq.superquadricEngines(gravity=(0, 0, 0), verletDist=0)[:-1]
        O.dt = 1e-6
        self.radius = effectiveRadius('ball')

    def move(self, by=(0, 0, 0), turn=(0, 0, 0)):
        """Physics of the contact after a step in which the upper ball has moved `by` [m] and turned by a vector [rad]."""
        state = O.bodies[1].state
        state.pos += Vector3(*by)
        state.vel, state.angVel = Vector3(*by) / O.dt, Vector3(*turn) / O.dt
        O.step()
        return O.interactions[0, 1].phys


def booked():
    """What the law has booked; YADE's integrator adds its own 'kinetic', which belongs to another half step."""
    return {name: value for name, value in O.energy.items() if name not in ('kinetic', 'gravWork')}
