"""The box on a spring under a harmonic force (VibratingBoxEngine), empty and with particles frozen to it, against closed forms.

The numbers are those of Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39(8), 1211 (2018): 0.3 kg on 9,720 N/m has 28.7 Hz, with
0.222 kg of particles as added mass 21.7 Hz; the force has an amplitude of 9.72 N and 10-50 Hz.
"""
import cmath
import math

import numpy as np
import pytest
from yade import O, utils
from yade.wrapper import CurvatureMat, ForceResetter, NewtonIntegrator, VibratingBoxEngine, VibrationRecorder

import yade.superquadric as sq

MASS, STIFFNESS, FORCE = 0.3, 9720.0, 9.72
NATURAL = math.sqrt(STIFFNESS / MASS) / (2 * math.pi)  # [Hz]
LIGHT_DAMPING = 2 * 0.05 * math.sqrt(STIFFNESS * MASS)  # a twentieth of the critical one [N s/m]
STEPS_PER_PERIOD = 2000  # the leap-frog's frequency is then 4e-7 too high


def makeBox(bodies=(), engines=(), gravity=(0, 0, 0), **attributes):
    """A wall and `bodies` as one box, in a new scene with a recorder; time step by the drive, or else by the natural frequency."""
    O.reset()
    material = CurvatureMat(young=70e9, poisson=0.33, density=2700)
    members = O.bodies.append([utils.wall(0, axis=2, sense=1, material=material), *bodies])
    box = VibratingBoxEngine(ids=members, **{'mass': MASS, 'stiffness': (0, 0, STIFFNESS), **attributes})
    recorder = VibrationRecorder(box=box, iterPeriod=10, initRun=True)
    O.engines = [ForceResetter(), *engines, box, NewtonIntegrator(gravity=gravity, damping=0), recorder]
    O.dt = 1 / (box.frequency or NATURAL) / STEPS_PER_PERIOD
    return box, recorder


def fundamental(times, values, frequency):
    """Complex amplitude of the part at `frequency`, by least squares beside a constant: values = Im(amplitude exp(i omega t)) + constant."""
    angles = 2 * math.pi * frequency * np.array(times)
    columns = np.stack([np.sin(angles), np.cos(angles), np.ones_like(angles)], axis=1)
    real, imaginary, _ = np.linalg.lstsq(columns, np.array(values), rcond=None)[0]
    return complex(real, imaginary)


def closedForm(frequency, damping):
    """Steady state of m u'' + c u' + k u = F sin(omega t), as a complex amplitude [m]."""
    omega = 2 * math.pi * frequency
    return FORCE / complex(STIFFNESS - MASS * omega ** 2, damping * omega)


def latter(recorder):
    """Times and vertical displacements in the second half of the record, when the transient is over."""
    half = len(recorder.times) // 2
    return recorder.times[half:], [u[2] for u in recorder.boxDisplacement[half:]]


@pytest.mark.parametrize('frequency', (10, 22.3, 25.5, 28.7, 30.2, 50))
def test_resonance_curve_of_the_damped_box(frequency):
    _, recorder = makeBox(forceAmplitude=(0, 0, FORCE), frequency=frequency, damping=(0, 0, LIGHT_DAMPING))
    O.run(80 * STEPS_PER_PERIOD, True)
    measured, expected = fundamental(*latter(recorder), frequency), closedForm(frequency, LIGHT_DAMPING)
    assert abs(measured) == pytest.approx(abs(expected), rel=1e-5)
    assert cmath.phase(measured / expected) == pytest.approx(0, abs=1e-4)


@pytest.mark.parametrize('frequency', (10, 22.3, 35, 47.7))
def test_undamped_box_off_resonance_stays_in_its_steady_state(frequency):
    amplitude = closedForm(frequency, 0).real  # against the force above the natural frequency
    omega = 2 * math.pi * frequency
    box, recorder = makeBox(forceAmplitude=(0, 0, FORCE), frequency=frequency, velocity=(0, 0, amplitude * omega))
    O.run(20 * STEPS_PER_PERIOD, True)
    displacements = [u[2] for u in recorder.boxDisplacement]
    expected = [amplitude * math.sin(omega * time) for time in recorder.times]
    assert displacements == pytest.approx(expected, abs=1e-4 * abs(amplitude))
    assert [v[2] for v in recorder.boxVelocity] == pytest.approx(
        [amplitude * omega * math.cos(omega * time) for time in recorder.times], abs=1e-4 * abs(amplitude) * omega)


def naturalFrequency(recorder):
    """Of a free vibration, from its first to its last upward passage through its mean [Hz]."""
    z = np.array([u[2] for u in recorder.boxDisplacement])
    z -= (z.max() + z.min()) / 2
    upward = np.flatnonzero((z[:-1] < 0) & (z[1:] >= 0))
    times = np.array(recorder.times)
    passages = times[upward] - z[upward] * (times[upward + 1] - times[upward]) / (z[upward + 1] - z[upward])
    return (len(passages) - 1) / (passages[-1] - passages[0])


def test_natural_frequency_of_the_empty_box():
    _, recorder = makeBox(displacement=(0, 0, 1e-3))
    O.run(50 * STEPS_PER_PERIOD, True)
    assert naturalFrequency(recorder) == pytest.approx(NATURAL, rel=1e-5)
    assert NATURAL == pytest.approx(28.7, abs=0.06)  # 28.65, which the paper rounds up


def frozenParticles(number, mass):
    """Spheres of 2 mm with the total `mass` [kg] on a grid, all degrees of freedom blocked."""
    material = CurvatureMat(young=70e9, poisson=0.33, density=mass / number / (4 / 3 * math.pi * 1e-9))
    return [utils.sphere((2e-3 * (i % 20), 2e-3 * (i // 20 % 20), 2e-3 * (1 + i // 400)), 1e-3, material=material, fixed=True)
            for i in range(number)]


def test_frozen_particles_are_added_mass():
    box, recorder = makeBox(frozenParticles(2000, 0.222), displacement=(0, 0, 1e-3))
    recorder.particles = box.ids[1:]
    O.run(8 * STEPS_PER_PERIOD, True)
    expected = math.sqrt(STIFFNESS / (MASS + 0.222)) / (2 * math.pi)
    assert naturalFrequency(recorder) == pytest.approx(expected, rel=1e-5)
    assert expected == pytest.approx(21.7, abs=0.05)
    ways = [position[2] - recorder.centroidPosition[0][2] for position in recorder.centroidPosition]
    assert ways == pytest.approx([u[2] - recorder.boxDisplacement[0][2] for u in recorder.boxDisplacement], abs=1e-15)


@pytest.mark.parametrize('ownWeight', (False, True))
def test_weight_draws_the_box_down_to_its_equilibrium(ownWeight):
    box, recorder = makeBox(frozenParticles(100, 0.0111), gravity=(0, 0, -9.81), damping=(0, 0, LIGHT_DAMPING), ownWeight=ownWeight)
    O.run(80 * STEPS_PER_PERIOD, True)
    weight = 9.81 * (0.0111 + ownWeight * MASS)
    assert box.displacement[2] == pytest.approx(-weight / STIFFNESS, rel=1e-6)


def test_energy_of_a_driven_box_closes_to_rounding():
    makeBox(gravity=(0, 0, -9.81), forceAmplitude=(0, 0, FORCE), frequency=25.5, damping=(0, 0, LIGHT_DAMPING), displacement=(0, 0, 1e-3),
            ownWeight=True)
    O.trackEnergy = True
    O.step()
    start = O.energy.total()
    for _ in range(100):
        O.run(STEPS_PER_PERIOD, True)
        assert O.energy.total() == pytest.approx(start, abs=1e-12 * -O.energy['boxDrive'])
    assert O.energy['boxDashpot'] > 10 * O.energy['boxKinetic'] and O.energy['gravWork'] != 0


def test_kinetic_energy_of_frozen_particles_is_that_of_yade():
    makeBox(frozenParticles(10, 0.00111), forceAmplitude=(0, 0, FORCE), frequency=25.5, displacement=(0, 0, 1e-3))
    O.trackEnergy = True
    kinetic, totals = [], []
    for _ in range(STEPS_PER_PERIOD):
        O.step()
        energies = dict(O.energy.items())
        kinetic.append(energies.pop('kinetic'))
        totals.append(sum(energies.values()))
    # Of members it belongs to half a step later than all others: a whole step has the mean of its neighbours.
    sums = [totals[i] + (kinetic[i - 1] + kinetic[i]) / 2 for i in range(1, len(totals))]
    assert max(sums) - min(sums) < 1e-6 * max(totals)  # m (change of v in a step)^2/4 is 1.2e-7
    assert max(kinetic) > 1e-3 * max(totals)


def bouncingBall(**attributes):
    """A ball between two walls of a free box, with nothing else around: (box, ball)."""
    material = CurvatureMat(young=1e9, poisson=0.3, density=2700)
    lid = utils.wall((0, 0, 0.024), axis=2, sense=-1, material=material)
    box, _ = makeBox([lid], **{'stiffness': (0, 0, 0), 'velocity': (0, 0, 0.3), **attributes})
    ball = utils.sphere((0, 0, 0.012), 5e-3, material=material)
    ball.state.vel = (0, 0, -1)
    O.bodies.append(ball)
    O.engines = sq.superquadricEngines(gravity=(0, 0, 0), afterForces=[box])
    O.dt = 0.02 * sq.criticalTimeStep()
    return box, ball


def test_ball_and_free_box_exchange_momentum_and_lose_none():
    box, ball = bouncingBall()
    mass, turns, before = ball.state.mass, 0, ball.state.vel[2]
    start = MASS * 0.3 - mass
    for _ in range(40000):
        O.step()
        assert MASS * box.velocity[2] + mass * ball.state.vel[2] == pytest.approx(start, abs=1e-14)
        turns += before * ball.state.vel[2] < 0
        before = ball.state.vel[2]
    assert turns >= 3 and abs(box.velocity[2] - 0.3) > 1e-3
    energy = MASS * box.velocity[2] ** 2 + mass * before ** 2
    assert energy == pytest.approx(MASS * 0.3 ** 2 + mass, rel=1e-4)  # undamped, and out of contact at the end


def shakenBalls(stepFraction, width, height, number):
    """Balls of 3 mm radius with all sinks of the contact law, thrown about by a driven box under gravity; energies are tracked."""
    O.reset()
    material = CurvatureMat(young=1e8, poisson=0.33, density=2700, frictionAngle=math.atan(0.5), normalDamping=0.2, tangentialDamping=0.2,
                            rollingFriction=0.005)
    O.materials.append(material)
    container = sq.boxContainer(width, width, height, material)
    sq.rainFilling([sq.particleShape('sphere', 3e-3)] * number, container, material, seed=1, sideways=2 if number > 1 else 0)
    lid = O.bodies.append(utils.wall((0, 0, height), axis=2, sense=-1, material=material))
    box = VibratingBoxEngine(ids=[container.baseId, *container.sideIds, lid], mass=0.02, stiffness=(0, 0, 500), damping=(0, 0, 0.2),
                             forceAmplitude=(0, 0, 1), frequency=25)
    O.engines = sq.superquadricEngines(afterForces=[box])
    O.trackEnergy = True
    O.dt = stepFraction * sq.criticalTimeStep()


def imbalance(*case):
    """Largest change of the sum of all energies in three periods of the drive, over the drive's work; and the sinks, likewise."""
    shakenBalls(*case)
    kinetic, others = [], []
    while O.time < 0.12:
        O.step()
        energies = dict(O.energy.items())
        kinetic.append(energies.pop('kinetic'))
        others.append(sum(energies.values()))
    work = -O.energy['boxDrive']
    # YADE's kinetic energy is that of half a step before: a whole step has the mean of its neighbours.
    sums = [others[i] + (kinetic[i] + kinetic[i + 1]) / 2 for i in range(len(others) - 1)]
    return max(abs(total - sums[0]) for total in sums) / work, {name: value / work for name, value in O.energy.items()}


def test_energy_of_box_and_bouncing_ball_closes_with_the_square_of_the_time_step():
    coarse, sinks = imbalance(0.1, 0.03, 0.02, 1)
    fine, _ = imbalance(0.025, 0.03, 0.02, 1)
    assert coarse < 5e-4 and fine < coarse / 8  # a sixteenth, but for the steps at which blows begin and end
    assert sinks['normDampDissip'] > 0.02


def test_energy_of_a_shaken_box_of_balls_closes_with_the_time_step():
    coarse, sinks = imbalance(0.1, 0.03, 0.03, 16)
    fine, _ = imbalance(0.025, 0.03, 0.03, 16)
    assert coarse < 5e-3 and fine < coarse / 3  # the law books contacts that turn to first order
    for name in ('normDampDissip', 'shearDampDissip', 'plastDissip', 'rollingDissip', 'boxDashpot'):
        assert sinks[name] > 1e-3, name


def test_members_stay_where_they_are_in_the_box():
    box, _ = makeBox([utils.wall((0, 0, 0.024), axis=2, sense=-1)], forceAmplitude=(0, 0, FORCE), frequency=25.5, damping=(0, 0, LIGHT_DAMPING))
    for _ in range(100):
        O.run(2000, True)
        for member, height in ((0, 0.0), (1, 0.024)):
            assert O.bodies[member].state.pos[2] == pytest.approx(height + box.displacement[2], abs=1e-17)
            assert O.bodies[member].state.vel == box.velocity
