// The first loading of an elastoplastic contact, Li et al. (2018), equations (8)-(10): force, slope, energy and residual overlap.
#include "ElastoplasticCases.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

using namespace superquadric::elastoplastic;

namespace {
// The last kink of the loading curve, where it comes back to (10) in units of dy; 1 if it never left it.
double lastKink(const Pair& pair)
{
	const LoadingCurve curve(pair);
	const YieldPoint point = yieldOf(pair);
	const Hardening& hardening = pair.material.hardening;
	const auto away = [&](double part) {
		const double fitted = 1 + hardening.m0 * std::pow(std::sqrt(part) - 1, hardening.exponent);
		return fitted * point.force > curve.force(part * point.overlap) * (1 + 1e-12);
	};
	double low = 1e6, high = low;
	while (low > 1.001 && !away(low)) {
		high = low;
		low /= 1.001;
	}
	if (!away(low)) return 1;
	for (int i = 0; i < 60; ++i)
		(away((low + high) / 2) ? low : high) = (low + high) / 2;
	return high;
}
}

TEST(Elastoplastic, LoadingFollowsEquation10)
{
	const YieldPoint point = yieldOf(aluminium);
	const LoadingCurve curve(aluminium);
	for (double part : { 0.1, 0.9, 1.1, 3., 100. }) {
		const double d = part * point.overlap, a = std::sqrt(radius * d);
		const double fitted = point.force * (1 + 2.6 * std::pow((a - point.contactRadius) / point.contactRadius, 1.8));
		const double expected = part < 1 ? hertzForce(aluminium, d) : fitted;
		EXPECT_NEAR(curve.force(d), expected, 1e-13 * expected);
	}
}

TEST(Elastoplastic, LoadingIsContinuousAndGrowsAndIsNoStrongerThanHertz)
{
	for (const Pair& pair : pairs) {
		const LoadingCurve curve(pair);
		const double dy = yieldOf(pair).overlap, fy = yieldOf(pair).force;
		EXPECT_NEAR(curve.force(dy * (1 + 1e-14)), fy, 1e-4 * fy); // a power H < 1 rises at once
		double last = 0, lastResidual = 0, lastDissipation = 0;
		for (double d = dy / 2; d < 1e6 * dy; d *= 1.001) {
			const double f = curve.force(d), length = d - curve.residual(d);
			ASSERT_GT(f, last);
			ASSERT_LE(f, hertzForce(pair, d) * (1 + 1e-14));
			// No jump: the slope bounds what is gained in a step, but where a power H < 1 or the end of a pause is near.
			ASSERT_LT(f, std::max(last, fy / 2) * 1.01);
			ASSERT_GE(curve.residual(d), lastResidual * (1 - 1e-13));
			const double dissipation = curve.energy(d) - 2. / 5 * f * length;
			ASSERT_GE(dissipation, lastDissipation - 1e-14 * curve.energy(d));
			// (10) meets the unloading branch with the disc that loading has left.
			ASSERT_NEAR(f, 4. / 3 * pair.modulus * std::sqrt(pair.radius * d) * length, 1e-12 * d / length * f);
			last = f;
			lastResidual = curve.residual(d);
			lastDissipation = dissipation;
		}
		EXPECT_GT(lastResidual, 0);
		EXPECT_GT(lastDissipation, 0);
	}
}

TEST(Elastoplastic, SlopeIsTheDerivativeOfTheForce)
{
	for (const Pair& pair : pairs)
		for (double part : { 0.3, 1.7, 5., 37., 1e4 }) {
			const LoadingCurve curve(pair);
			const double d = part * yieldOf(pair).overlap, h = 1e-5 * d;
			EXPECT_NEAR(curve.slope(d), (curve.force(d + h) - curve.force(d - h)) / (2 * h), 1e-7 * curve.force(d) / d);
		}
}

TEST(Elastoplastic, EnergyIsTheIntegralOfTheForce)
{
	for (const Pair& pair : pairs) {
		const LoadingCurve curve(pair);
		const double dy = yieldOf(pair).overlap;
		// With d = dy (1 + s^10) the integrand is smooth enough at yield for any exponent.
		for (double part : { 1.01, 1.5, 4., 50., 1e4 }) {
			const double top = std::pow(part - 1, 0.1);
			const auto f = [&](double s) { return curve.force(dy * (1 + std::pow(s, 10))) * 10 * std::pow(s, 9) * dy; };
			const double kink = std::min(top, std::pow(lastKink(pair) - 1, 0.1)), error = 1e-14 * curve.energy(part * dy);
			const double expected = curve.energy(dy) + integral(f, 0, kink, error, 50) + integral(f, kink, top, error, 50);
			EXPECT_NEAR(curve.energy(part * dy), expected, 1e-12 * expected);
		}
		EXPECT_NEAR(curve.energy(dy), 2. / 5 * yieldOf(pair).force * dy, 1e-14 * curve.energy(dy));
	}
}

// By hand: without the rule, 1 + 30 w^2 lies above Hertz's (1 + w)^3 at w = 1, and the residual overlap would be negative.
TEST(Elastoplastic, WhereTheFitIsTooSteepTheContactYieldsNoFurther)
{
	const Pair pair = pairOf(50e6, 30, 2);
	const LoadingCurve curve(pair);
	const double d = 4 * yieldOf(pair).overlap, fy = yieldOf(pair).force;
	EXPECT_LT(curve.force(d), fy * 8);
	EXPECT_GT(curve.residual(d), 0);
	EXPECT_EQ(curve.residual(d), curve.residual(1.1 * d));
	EXPECT_GT(curve.residual(1e4 * d), 100 * curve.residual(d));
	// Above Hertz from yield on: Hertz until both meet, at 1 + 12 w = (1 + w)^3.
	const Pair steep = pairOf(100e6, 12, 1);
	const double meeting = std::pow(1 + (-3 + std::sqrt(45)) / 2, 2) * yieldOf(steep).overlap;
	EXPECT_EQ(LoadingCurve(steep).residual(0.999 * meeting), 0);
	EXPECT_GT(LoadingCurve(steep).residual(1.001 * meeting), 0);
	EXPECT_EQ(followed(steep, { 0.999 * meeting, 0.5 * meeting }).history.dissipated, 0);
}

TEST(Elastoplastic, TheResidualNeverShrinksForAnyFit)
{
	std::mt19937 random(3);
	std::uniform_real_distribution<double> unit(0, 1);
	for (int i = 0; i < 2000; ++i) {
		const Pair pair = pairOf(100e6, std::pow(10, 4 * unit(random) - 2), 0.05 + 2.9 * unit(random));
		const LoadingCurve curve(pair);
		const double dy = yieldOf(pair).overlap;
		double last = 0;
		for (double d = dy; d < 1e8 * dy; d *= 1.05) {
			ASSERT_GE(curve.residual(d), last - 1e-14 * d);
			ASSERT_LT(curve.residual(d), d);
			last = curve.residual(d);
		}
	}
}
