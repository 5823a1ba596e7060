#include "Oscillator.hpp"

#include <cmath>

namespace superquadric::oscillator {

namespace {
	constexpr double twoPi = 2 * pi;
}

Vector3 harmonicForce(const Vector3& amplitude, double frequency, double phase, double time)
{
	return amplitude * std::sin(twoPi * frequency * time + phase);
}

Vector3 nextVelocity(double mass, const Vector3& damping, const Vector3& force, const Vector3& velocity, double step)
{
	const Vector3 half = step / (2 * mass) * damping; // c dt/(2 m)
	return ((Vector3::Ones() - half).cwiseProduct(velocity) + step / mass * force).cwiseQuotient(Vector3::Ones() + half);
}

Vector3 dashpotForce(const Vector3& damping, const Vector3& before, const Vector3& after) { return -damping.cwiseProduct(before + after) / 2; }

double kineticEnergy(double mass, const Vector3& before, const Vector3& after) { return mass / 2 * before.dot(after); }

double springEnergy(const Vector3& stiffness, const Vector3& displacement) { return stiffness.dot(displacement.cwiseAbs2()) / 2; }

} // namespace superquadric::oscillator
