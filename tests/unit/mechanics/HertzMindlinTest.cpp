// The contact law (6)-(14): closed forms, limits, and forces as derivatives of their energies.
#include <pkg/mechanics/HertzMindlin.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::hertzMindlin;

namespace {
constexpr double young = 1e9, poisson = 0.2, overlapLimit = 0.1;
const Pair pair { 0.5e9, 2e-3, 1e-3 };

// Rebound of one body of mass m* off a wall, integrated by half steps so that the error is of second order.
double restitution(double damping, double speed)
{
	const double scale = std::pow(pair.mass / (pair.modulus * std::sqrt(pair.radius)), 0.4) * std::pow(speed, -0.2);
	const double step = 1e-4 * scale;
	double overlap = 1e-12, velocity = speed;
	while (overlap > 0) {
		overlap += step / 2 * velocity;
		if (overlap > 0) velocity -= step / pair.mass * normalForce(pair, damping, overlap, velocity).total();
		overlap += step / 2 * velocity;
	}
	return -velocity / speed;
}

Friction frictionOf(double coefficient, double damping = 0) { return { coefficient, stiffnessRatio(young, poisson, young, poisson), damping, 1e-3 }; }
}

TEST(HertzMindlin, EqualMaterialsGiveThePapersModulus)
{
	EXPECT_NEAR(effectiveModulus(young, poisson, young, poisson), young / (2 * (1 - poisson * poisson)), 1e-15 * young);
}

TEST(HertzMindlin, ModulusOfARigidPartnerIsThatOfOneSide)
{
	EXPECT_NEAR(effectiveModulus(young, poisson, 1e30, 0.4), young / (1 - poisson * poisson), 1e-12 * young);
}

TEST(HertzMindlin, StiffnessRatioIsThePapersFactorForEqualMaterials)
{
	for (double nu : { 0., 0.2, 0.35, 0.49 })
		EXPECT_NEAR(stiffnessRatio(young, nu, young, nu), (2 - nu) / (2 * (1 - nu)), 1e-14);
}

TEST(HertzMindlin, StiffnessRatioDoesNotDependOnTheOrder)
{
	EXPECT_DOUBLE_EQ(stiffnessRatio(1e9, 0.2, 7e10, 0.35), stiffnessRatio(7e10, 0.35, 1e9, 0.2));
}

TEST(HertzMindlin, CurvatureIsBoundedOnFacesAndEdgesOnly)
{
	const double half = 4e-3, section = 5e-3;
	EXPECT_DOUBLE_EQ(boundedCurvature({ 1 / half, half, half }, overlapLimit), 1 / half);
	// On a face: at the largest overlap the disc of contact is as wide as the section.
	const double flat = boundedCurvature({ 0, section, half }, overlapLimit);
	EXPECT_NEAR(std::sqrt(1 / flat * overlapLimit * half), section, 1e-15);
	// At an edge: the radius is the largest overlap.
	EXPECT_DOUBLE_EQ(1 / boundedCurvature({ 1e9, section, half }, overlapLimit), overlapLimit * half);
	EXPECT_EQ(boundedCurvature({ 0, 0, 0 }, overlapLimit), 0);
}

TEST(HertzMindlin, NormalForceIsTheDerivativeOfItsEnergy)
{
	const double overlap = 1e-5, h = 1e-9;
	const NormalForce force = normalForce(pair, 0, overlap, 0);
	const double slope = (normalEnergy(pair.hertz(), overlap + h) - normalEnergy(pair.hertz(), overlap - h)) / (2 * h);
	EXPECT_NEAR(force.elastic, slope, 1e-8 * slope);
	EXPECT_NEAR(force.elastic, pair.hertz() * std::pow(overlap, 1.5), 1e-14 * slope);
	const double rate
	        = (normalForce(pair, 0, overlap + h, 0).elastic - normalForce(pair, 0, overlap - h, 0).elastic) / (2 * h);
	EXPECT_NEAR(force.stiffness, rate, 1e-8 * rate);
}

TEST(HertzMindlin, ViscousPartFollowsEquation8)
{
	const double overlap = 1e-5, damping = 0.1, speed = 0.3;
	const double A = std::sqrt(8 * pair.mass * pair.modulus * std::sqrt(pair.radius * overlap));
	EXPECT_NEAR(normalForce(pair, damping, overlap, speed).viscous, damping * A * speed, 1e-12 * A);
}

TEST(HertzMindlin, NormalForceIsNeverAttractive)
{
	EXPECT_EQ(normalForce(pair, 0.1, 1e-9, -10).total(), 0);
	EXPECT_GT(normalForce(pair, 0.1, 1e-9, 10).viscous, 0);
}

// The paper: 0.85 for 0.05. The other two were integrated from (6)-(8) with another program.
TEST(HertzMindlin, RestitutionDoesNotDependOnSpeed)
{
	for (double speed : { 0.01, 1., 5.558 }) {
		EXPECT_NEAR(restitution(0, speed), 1, 1e-6);
		EXPECT_NEAR(restitution(0.05, speed), 0.847, 1e-3);
		EXPECT_NEAR(restitution(0.06, speed), 0.820, 1e-3);
		EXPECT_NEAR(restitution(0.1, speed), 0.725, 1e-3);
	}
}

TEST(HertzMindlin, TangentialForceIsTheDerivativeOfItsEnergy)
{
	const Friction friction = frictionOf(0.4);
	const double normal = 3, overlap = 1e-5, longest = 0.4 * friction.stiffnessRatio * overlap, h = 1e-6 * longest;
	for (double part : { 0.1, 0.5, 0.9 }) {
		const Vector3 along(0.6, 0.8, 0);
		const auto at = [&](double length) { return tangentialForce(friction, normal, overlap, length * along, Vector3::Zero()); };
		const double slope = (at(part * longest + h).energy - at(part * longest - h).energy) / (2 * h);
		const TangentialForce force = at(part * longest);
		EXPECT_NEAR(force.elastic.dot(along), -slope, 1e-6 * slope);
		EXPECT_NEAR(-force.elastic.dot(along), 0.4 * normal * (1 - std::pow(1 - part, 1.5)), 1e-14 * normal);
		EXPECT_NEAR(force.elastic.cross(along).norm(), 0, 1e-15 * normal);
		EXPECT_EQ(force.slip, 0);
	}
}

TEST(HertzMindlin, SlipKeepsTheForceAtCoulombsLimit)
{
	const Friction friction = frictionOf(0.4, 0.1);
	const double normal = 3, overlap = 1e-5, longest = 0.4 * friction.stiffnessRatio * overlap;
	const TangentialForce force = tangentialForce(friction, normal, overlap, Vector3(0, 0, 3 * longest), Vector3(0, 0, 1));
	EXPECT_NEAR(force.elastic.z(), -0.4 * normal, 1e-14 * normal);
	EXPECT_EQ(force.viscous.norm(), 0);
	EXPECT_NEAR(force.displacement.z(), longest, 1e-15 * longest);
	EXPECT_NEAR(force.slip, 2 * longest, 1e-14 * longest);
}

TEST(HertzMindlin, TangentialViscosityFollowsEquation12)
{
	const Friction friction = frictionOf(0.4, 0.1);
	const double normal = 3, overlap = 1e-5, longest = 0.4 * friction.stiffnessRatio * overlap, part = 0.3;
	const Vector3 velocity(0, 1e-4, 0);
	const TangentialForce force = tangentialForce(friction, normal, overlap, Vector3(part * longest, 0, 0), velocity);
	const double viscosity = 0.1 * std::sqrt(6 * 0.4 * friction.mass * normal * std::sqrt(1 - part) / longest);
	EXPECT_NEAR(force.viscous.y(), -viscosity * velocity.y(), 1e-14 * viscosity);
	EXPECT_EQ(force.viscous.x(), 0);
}

TEST(HertzMindlin, TangentialForceStaysWithinCoulombsLimit)
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> unit(-1, 1);
	const double normal = 3, overlap = 1e-5;
	for (int i = 0; i < 1000; ++i) {
		const Friction friction = frictionOf(0.5 + 0.5 * unit(random), 0.5);
		const Vector3 displacement = 2 * overlap * Vector3(unit(random), unit(random), 0);
		const Vector3 velocity = std::pow(10., 3 * unit(random)) * Vector3(unit(random), unit(random), 0);
		const TangentialForce force = tangentialForce(friction, normal, overlap, displacement, velocity);
		const double limit = friction.coefficient * normal;
		EXPECT_LE(force.total().norm(), limit * (1 + 1e-12));
		EXPECT_LE(force.viscous.dot(velocity), 0);
	}
}

TEST(HertzMindlin, NoFrictionNoTangentialForce)
{
	const TangentialForce force = tangentialForce(frictionOf(0, 0.1), 3, 1e-5, Vector3(1e-6, 0, 0), Vector3(1, 1, 0));
	EXPECT_EQ(force.total().norm(), 0);
	EXPECT_EQ(force.displacement.norm(), 0);
	EXPECT_EQ(force.energy, 0);
}

TEST(HertzMindlin, VanishingOverlapGivesFiniteForces)
{
	const double overlap = 1e-300;
	const NormalForce normal = normalForce(pair, 0.1, overlap, 1);
	EXPECT_GT(normal.stiffness, 0);
	const TangentialForce force = tangentialForce(frictionOf(0.4, 0.1), normal.elastic, overlap, Vector3(1e-6, 0, 0), Vector3(1, 0, 0));
	EXPECT_TRUE(force.total().allFinite());
	EXPECT_TRUE(std::isfinite(force.energy));
}

TEST(HertzMindlin, RollingCoupleOpposesTheSpinAndCannotReverseIt)
{
	const Vector3 spin(0, 3, 4);
	const Vector3 couple = rollingCouple(0.002, 5e-3, -7, spin, 1, 1e-6);
	EXPECT_NEAR((couple + 0.002 * 5e-3 * 7 * spin / 5).norm(), 0, 1e-18);
	const double inertia = 1e-9, step = 1e-6;
	EXPECT_NEAR((rollingCouple(0.5, 1, 1e6, spin, inertia, step) * step / inertia + spin).norm(), 0, 1e-14);
	EXPECT_EQ(rollingCouple(0.5, 1, 1e6, Vector3::Zero(), inertia, step).norm(), 0);
}

// By hand: G = 1e9/2.4 Pa; pi * 5e-3/(0.0326 + 0.8766) * sqrt(2500 * 2.4e-9) = 4.2319e-5 s.
TEST(HertzMindlin, CriticalTimeStep) { EXPECT_NEAR(criticalTimeStep(5e-3, 1e9, 0.2, 2500), 4.2319e-5, 1e-9); }
