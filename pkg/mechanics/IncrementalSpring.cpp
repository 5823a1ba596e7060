#include "IncrementalSpring.hpp"

#include <algorithm>
#include <cmath>

namespace superquadric {

namespace {
	// What is lost between two stiffnesses, each with the square of the stretch or the force that belongs to it.
	double softening(const Spring& before, const Spring& now)
	{
		if (now.stiffness < before.stiffness)
			return (before.stiffness - now.stiffness) / 4 * (before.stretch().squaredNorm() + now.stretch().squaredNorm());
		return before.stiffness > 0 ? before.energy() * (1 - before.stiffness / now.stiffness) : 0;
	}
}

Vector3 Spring::stretch() const { return stiffness > 0 ? Vector3(force / -stiffness) : Vector3(Vector3::Zero()); }

double Spring::energy() const { return stiffness > 0 ? force.squaredNorm() / (2 * stiffness) : 0; }

SpringStep follow(const Spring& before, double stiffness, double limit, const Vector3& displacement)
{
	SpringStep step;
	if (!(stiffness > 0 && limit > 0)) {
		step.softening = before.energy();
		return step;
	}
	step.spring.stiffness = stiffness;
	Vector3& force = step.spring.force;
	force = (stiffness < before.stiffness ? stiffness / before.stiffness : 1) * before.force - stiffness * displacement;
	const double asked = force.norm();
	if (asked > limit) {
		force *= limit / asked;
		step.slips = true;
		// The mean of the force along the slip, before and after.
		step.slipWork = (asked - limit) / stiffness * (std::max(0., before.force.dot(force) / limit) + limit) / 2;
	}
	step.softening = softening(before, step.spring);
	return step;
}

Vector3 dashpot(double ratio, double mass, double stiffness, const Vector3& velocity) { return -2 * ratio * std::sqrt(mass * stiffness) * velocity; }

double rollingStiffness(double normalStiffness, double coefficient, double radius)
{
	const double lever = coefficient * radius;
	return 2.25 * normalStiffness * lever * lever;
}

double inverseRollingInertia(double inverseMass, double inverseInertia, double distance)
{
	if (!(inverseMass > 0 && inverseInertia > 0)) return 0;
	return 1 / (1 / inverseInertia + distance * distance / inverseMass);
}

} // namespace superquadric
