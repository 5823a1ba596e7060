#include "HertzMindlin.hpp"

#include "CoulombLimit.hpp"

#include <algorithm>
#include <cmath>

namespace superquadric::hertzMindlin {

namespace {

	double shearModulus(double young, double poisson) { return young / (2 * (1 + poisson)); }
}

double effectiveModulus(double young1, double poisson1, double young2, double poisson2)
{
	return 1 / ((1 - poisson1 * poisson1) / young1 + (1 - poisson2 * poisson2) / young2);
}

double stiffnessRatio(double young1, double poisson1, double young2, double poisson2)
{
	const double shearCompliance = (2 - poisson1) / shearModulus(young1, poisson1) + (2 - poisson2) / shearModulus(young2, poisson2);
	return effectiveModulus(young1, poisson1, young2, poisson2) * shearCompliance / 4;
}

double boundedCurvature(const Side& side, double overlapLimit)
{
	if (side.smallestHalfSize == 0) return side.curvature;
	const double largestOverlap = overlapLimit * side.smallestHalfSize;
	const double flattest = largestOverlap / (side.sectionRadius * side.sectionRadius);
	return std::min(std::max(side.curvature, flattest), 1 / largestOverlap);
}

double Pair::hertz() const { return 4. / 3 * modulus * std::sqrt(radius); }

NormalForce normalForce(const Pair& pair, double damping, double overlap, double approachSpeed)
{
	const double contactRadius = std::sqrt(pair.radius * overlap);
	const double viscosity = std::sqrt(8 * pair.mass * pair.modulus * contactRadius); // A of equation (8)
	NormalForce force;
	force.stiffness = 2 * pair.modulus * contactRadius;
	force.elastic = 2. / 3 * force.stiffness * overlap;
	force.viscous = std::max(damping * viscosity * approachSpeed, -force.elastic);
	return force;
}

double normalEnergy(double hertz, double overlap) { return 2. / 5 * hertz * overlap * overlap * std::sqrt(overlap); }

TangentialForce tangentialForce(
        const Friction& friction, double normalForce, double overlap, const Vector3& displacement, const Vector3& velocity)
{
	TangentialForce force;
	const double limit = friction.coefficient * normalForce; // Mohr-Coulomb
	const double longest = friction.coefficient * friction.stiffnessRatio * overlap; // dtmax
	if (!(limit > 0 && longest > 0)) return force;

	const double length = displacement.norm();
	force.slip = std::max(0., length - longest);
	force.displacement = force.slip > 0 ? Vector3(displacement * (longest / length)) : displacement;

	const double left = 1 - std::min(1., length / longest); // 1 - min(dt, dtmax)/dtmax
	if (length > 0) force.elastic = displacement * (-limit * (1 - left * std::sqrt(left)) / length);
	force.energy = limit * longest * (1 - left - 2. / 5 * (1 - left * left * std::sqrt(left)));

	const double viscosity = friction.damping * std::sqrt(6 * limit * friction.mass * std::sqrt(left) / longest);
	const Vector3 viscous = -viscosity * velocity;
	force.viscous = partUpTo(limit, force.elastic, viscous) * viscous;
	return force;
}

Vector3 rollingCouple(double coefficient, double radius, double normalForce, const Vector3& spin, double effectiveInertia, double step)
{
	const double speed = spin.norm();
	if (speed == 0) return Vector3::Zero();
	const double magnitude = std::min(coefficient * radius * std::abs(normalForce), effectiveInertia * speed / step);
	return spin * (-magnitude / speed);
}

double criticalTimeStep(double smallestHalfSize, double young, double poisson, double density)
{
	return pi * smallestHalfSize / (0.163 * poisson + 0.8766) * std::sqrt(density / shearModulus(young, poisson));
}

} // namespace superquadric::hertzMindlin
