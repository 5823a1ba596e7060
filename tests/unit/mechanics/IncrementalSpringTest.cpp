// The spring of tangential force and rolling couple: slip, changing stiffness, and the energy of both on random paths.
#include <pkg/mechanics/IncrementalSpring.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace superquadric;

namespace {
constexpr double stiffness = 2e5, limit = 3, longest = limit / stiffness;
const Vector3 along(0.6, 0.8, 0);

// What the leap-frog integrator does in a step: the work of the mean force, from outside on the spring.
double workOf(const Spring& before, const Spring& after, const Vector3& displacement) { return -(before.force + after.force).dot(displacement) / 2; }

// A path of changing stiffness, limit and direction, and what became of the work.
struct Path {
	double work = 0, slipWork = 0, softening = 0, stored = 0, largest = 0;

	double imbalance() const { return work - slipWork - softening - stored; }
};

Path smoothPath(int steps)
{
	Path path;
	Spring spring;
	double lastTime = 0;
	const auto place = [](double t) -> Vector3 { return longest * Vector3(2 * std::sin(7 * t), 1.5 * std::cos(5 * t) - 1.5, 0); };
	for (int i = 1; i <= steps; ++i) {
		const double time = 1. * i / steps, pressed = 1 + 0.8 * std::sin(11 * time);
		const Vector3 displacement = place(time) - place(lastTime);
		const SpringStep step = follow(spring, stiffness * std::cbrt(pressed), limit * pressed, displacement);
		path.work += workOf(spring, step.spring, displacement);
		path.slipWork += step.slipWork;
		path.softening += step.softening;
		path.largest = std::max(path.largest, step.spring.energy());
		spring = step.spring;
		lastTime = time;
	}
	path.stored = spring.energy();
	return path;
}

class RandomPath {
public:
	explicit RandomPath(int seed)
	        : random_(seed)
	{
	}
	double factor(double largest) { return std::pow(largest, unit_(random_)); } // from its inverse to `largest`
	Vector3 displacement(double largest) { return largest * Vector3(unit_(random_), unit_(random_), 0) / 2; }

private:
	std::mt19937 random_;
	std::uniform_real_distribution<double> unit_ { -1, 1 };
};
}

TEST(IncrementalSpring, WithinTheLimitItIsASpring)
{
	Spring spring;
	Vector3 displacement = Vector3::Zero();
	for (const Vector3& move : { Vector3(0.5, 0, 0), Vector3(-0.2, 0.6, 0), Vector3(-0.9, 0, 0) }) {
		const SpringStep step = follow(spring, stiffness, limit, longest * move);
		displacement += longest * move;
		EXPECT_NEAR((step.spring.force + stiffness * displacement).norm(), 0, 1e-14 * limit);
		EXPECT_NEAR((step.spring.stretch() - displacement).norm(), 0, 1e-14 * longest);
		EXPECT_NEAR(step.spring.energy(), stiffness / 2 * displacement.squaredNorm(), 1e-14 * limit * longest);
		EXPECT_FALSE(step.slips);
		EXPECT_EQ(step.slipWork + step.softening, 0);
		spring = step.spring;
	}
}

TEST(IncrementalSpring, SlipDissipatesTheLimitTimesItsWay)
{
	Spring spring;
	double slipWork = 0, work = 0;
	for (int i = 0; i < 400; ++i) { // one length until it slips, three of slip
		const Vector3 displacement = longest / 100 * along;
		const SpringStep step = follow(spring, stiffness, limit, displacement);
		EXPECT_TRUE(step.slips || i < 100);
		EXPECT_TRUE(!step.slips || i > 98); // in step 99 by rounding
		EXPECT_EQ(step.softening, 0);
		slipWork += step.slipWork;
		work += workOf(spring, step.spring, displacement);
		spring = step.spring;
	}
	EXPECT_NEAR((spring.force + limit * along).norm(), 0, 1e-13 * limit);
	EXPECT_NEAR(slipWork, limit * 3 * longest, 1e-11 * limit * longest);
	EXPECT_NEAR(work, slipWork + spring.energy(), 1e-12 * limit * longest);
}

// Cut from F to L at rest: F^2/(2k) - L^2/(2k), which is the slip times the mean force.
TEST(IncrementalSpring, ALimitThatFallsDissipatesWhatTheSpringLoses)
{
	const Spring before { -0.9 * limit * along, stiffness };
	const SpringStep step = follow(before, stiffness, 0.3 * limit, Vector3::Zero());
	EXPECT_TRUE(step.slips);
	EXPECT_NEAR(step.spring.force.norm(), 0.3 * limit, 1e-14 * limit);
	EXPECT_NEAR(step.slipWork, before.energy() - step.spring.energy(), 1e-14 * limit * longest);
}

TEST(IncrementalSpring, AChangeOfStiffnessNeverGivesEnergy)
{
	const Spring before { limit / 2 * along, stiffness };
	for (double factor : { 0.1, 0.7, 1., 1.5, 20. }) {
		const SpringStep step = follow(before, factor * stiffness, limit, Vector3::Zero());
		const double expected = std::min(factor, 1.) * limit / 2; // F k/k_old, or F
		EXPECT_NEAR((step.spring.force - expected * along).norm(), 0, 1e-15 * limit);
		EXPECT_LE(step.spring.energy(), before.energy());
		EXPECT_EQ(step.slipWork, 0);
		EXPECT_NEAR(step.softening, before.energy() - step.spring.energy(), 1e-14 * limit * longest);
		EXPECT_EQ(step.softening > 0, factor != 1);
	}
}

TEST(IncrementalSpring, WithoutStiffnessOrLimitTheForceEnds)
{
	const Spring before { limit / 2 * along, stiffness };
	for (const SpringStep& step : { follow(before, 0, limit, along), follow(before, stiffness, 0, along), follow(before, 0, 0, along) }) {
		EXPECT_EQ(step.spring.force.norm(), 0);
		EXPECT_EQ(step.spring.energy(), 0);
		EXPECT_EQ(step.slipWork + step.softening, before.energy());
		// And begins anew.
		EXPECT_NEAR((follow(step.spring, stiffness, limit, longest / 2 * along).spring.force + limit / 2 * along).norm(), 0, 1e-15 * limit);
	}
	EXPECT_EQ(follow({}, 0, 0, along).softening, 0);
}

TEST(IncrementalSpring, TheBalanceClosesWithTheSquareOfTheStep)
{
	double last = smoothPath(500).imbalance();
	for (int steps : { 1000, 2000, 4000 }) {
		const Path path = smoothPath(steps);
		EXPECT_LT(std::abs(path.imbalance()), 0.3 * std::abs(last));
		EXPECT_GT(path.slipWork, path.largest);
		EXPECT_GT(path.softening, path.largest / 10);
		last = path.imbalance();
	}
	EXPECT_LT(std::abs(last), 1e-6 * smoothPath(4000).work);
}

// Within a step the stiffness changes first, then the body moves: no step stores or gives more than is put in. Steps of the size of the
// stretch, factors up to 20.
TEST(IncrementalSpring, NoRandomPathGivesEnergy)
{
	for (int seed = 0; seed < 200; ++seed) {
		RandomPath path(seed);
		Spring spring;
		double work = 0;
		for (int i = 0; i < 500; ++i) {
			const double k = stiffness * path.factor(20), most = limit * path.factor(20);
			const Vector3 displacement = path.displacement(std::min(longest, most / k));
			const Spring changed = follow(spring, k, 1e9 * limit, Vector3::Zero()).spring;
			const SpringStep step = follow(spring, k, most, displacement);
			ASSERT_LE(step.spring.force.norm(), most * (1 + 1e-14));
			const double added = workOf(changed, step.spring, displacement);
			ASSERT_GE(added, step.spring.energy() - spring.energy() - 1e-13 * limit * longest);
			work += added;
			spring = step.spring;
		}
		ASSERT_GE(work, spring.energy());
	}
}

TEST(IncrementalSpring, WhatIsBookedIsTheWorkUpToTheThirdOrder)
{
	for (int seed = 0; seed < 200; ++seed) {
		RandomPath path(seed);
		Spring spring;
		for (int i = 0; i < 500; ++i) {
			const double k = spring.stiffness > 0 ? spring.stiffness * path.factor(1.2) : stiffness, most = limit * path.factor(3);
			const Vector3 displacement = path.displacement(longest / 5);
			const SpringStep step = follow(spring, k, most, displacement);
			ASSERT_GE(step.slipWork, 0);
			ASSERT_GE(step.softening, 0);
			const double known = std::max(0., spring.stiffness - k) / 4 * (step.spring.stretch() - spring.stretch()).squaredNorm();
			const double expected = workOf(spring, step.spring, displacement) + spring.energy() + known;
			if (spring.force.dot(step.spring.force) >= 0) { // not reversed
				ASSERT_NEAR(step.spring.energy() + step.slipWork + step.softening, expected, 1e-12 * (limit * longest + expected));
			}
			spring = step.spring;
		}
	}
}

TEST(IncrementalSpring, LossesOfHugeStepsAreNotNegative)
{
	RandomPath path(3);
	Spring spring;
	for (int i = 0; i < 10000; ++i) {
		const double k = stiffness * path.factor(1e6), most = limit * path.factor(1e6);
		const SpringStep step = follow(spring, k, most, path.displacement(longest * path.factor(1e6)));
		ASSERT_GE(step.slipWork, 0);
		ASSERT_GE(step.softening, 0);
		ASSERT_TRUE(std::isfinite(step.slipWork + step.softening) && step.spring.force.allFinite());
		spring = step.spring;
	}
}

// m x'' + c x' + k x = 0 with c = 2 sqrt(m k) does not swing over, with less it does.
TEST(IncrementalSpring, ADashpotOfRatioOneIsCritical)
{
	const double mass = 1e-3, period = std::sqrt(mass / stiffness);
	for (double ratio : { 0.5, 0.99, 1.01, 1.5 }) {
		Vector3 place = longest * along, velocity = Vector3::Zero();
		bool swingsOver = false;
		for (int i = 0; i < 500000; ++i) {
			velocity += 1e-4 * period / mass * (-stiffness * place + dashpot(ratio, mass, stiffness, velocity));
			place += 1e-4 * period * velocity;
			swingsOver = swingsOver || place.dot(along) < 0;
		}
		EXPECT_EQ(swingsOver, ratio < 1);
	}
}

// By hand.
TEST(IncrementalSpring, RollingStiffnessAndInertia)
{
	EXPECT_DOUBLE_EQ(rollingStiffness(1e6, 0.1, 2e-3), 2.25 * 1e6 * 4e-8);
	EXPECT_DOUBLE_EQ(1 / inverseRollingInertia(1 / 3., 1 / 5., 2), 5 + 3 * 4.);
	EXPECT_EQ(inverseRollingInertia(0, 1, 2), 0);
	EXPECT_EQ(inverseRollingInertia(1, 0, 2), 0);
}
