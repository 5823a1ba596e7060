// One step of the leap-frog of a driven, damped oscillator, against the closed form of the difference equation that it is.
#include <pkg/mechanics/Oscillator.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using superquadric::Vector3;
namespace oscillator = superquadric::oscillator;

namespace {
constexpr double mass = 0.3, frequency = 35, step = 2e-4, phase = 0.7;
const Vector3 stiffness(9720, 4000, 0), damping(0, 3, 20), amplitude(9.72, 5, 2);
const double omega = 2 * std::acos(-1.) * frequency;

// u(n) = Im(U exp(i(omega n dt + phase))) solves m (u(n+1) - 2u(n) + u(n-1))/dt^2 + c (u(n+1) - u(n-1))/(2 dt) + k u(n) = F(n).
std::complex<double> response(int axis)
{
	const double sine = std::sin(omega * step / 2);
	const std::complex<double> impedance(stiffness[axis] - mass * std::pow(2 * sine / step, 2), damping[axis] * std::sin(omega * step) / step);
	return amplitude[axis] / impedance;
}

Vector3 steadyState(int n)
{
	Vector3 u;
	for (int axis = 0; axis < 3; ++axis)
		u[axis] = std::imag(response(axis) * std::polar(1., omega * n * step + phase));
	return u;
}
}

TEST(Oscillator, KeepsToTheSteadyStateOfItsDifferenceEquation)
{
	Vector3 u = steadyState(0), v = (u - steadyState(-1)) / step;
	for (int n = 0; n < 2000; ++n) {
		const Vector3 force = oscillator::harmonicForce(amplitude, frequency, phase, n * step) - stiffness.cwiseProduct(u);
		v = oscillator::nextVelocity(mass, damping, force, v, step);
		u += step * v;
		ASSERT_LT((u - steadyState(n + 1)).norm(), 1e-12) << "step " << n;
	}
}

TEST(Oscillator, EnergyClosesToRounding)
{
	Vector3 u(1e-3, -2e-3, 0), v(0.1, 0.2, -0.3), drive = Vector3::Zero(), dashpot = Vector3::Zero(), way = Vector3::Zero();
	double worked = 0, lost = 0, start = 0, scale = 0;
	for (int n = 0; n < 2000; ++n) {
		const Vector3 before = v, driveBefore = drive, dashpotBefore = dashpot;
		drive = oscillator::harmonicForce(amplitude, frequency, phase, n * step);
		v = oscillator::nextVelocity(mass, damping, drive - stiffness.cwiseProduct(u), v, step);
		dashpot = oscillator::dashpotForce(damping, before, v);
		worked += way.dot(driveBefore + drive) / 2;
		lost -= way.dot(dashpotBefore + dashpot) / 2;
		const double held = oscillator::kineticEnergy(mass, before, v) + oscillator::springEnergy(stiffness, u);
		if (n == 0) start = held;
		scale = std::max({ scale, held, lost });
		ASSERT_NEAR(held + lost - worked, start, 1e-13 * scale) << "step " << n;
		way = step * v;
		u += way;
	}
	EXPECT_GT(lost, start); // the test has met a sink
}

TEST(Oscillator, AHeavyDashpotStopsTheMassWithoutThrowingItBack)
{
	const Vector3 v = oscillator::nextVelocity(mass, Vector3::Constant(1e9), Vector3::Zero(), Vector3::Ones(), step);
	// The mean of both velocities, which the dashpot feels, is next to none.
	EXPECT_LT(std::abs(1 + v[0]), 1e-5);
	EXPECT_LE(std::abs(v[0]), 1);
}
