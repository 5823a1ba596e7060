// The elastoplastic normal law: yield, unloading and reloading against closed forms, and what a contact remembers.
#include "ElastoplasticCases.hpp"

#include <pkg/mechanics/HertzMindlin.hpp>

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

using namespace superquadric::elastoplastic;

namespace {
std::string refusalOf(const Material& material)
{
	try {
		check(material);
	} catch (const std::invalid_argument& e) {
		return e.what();
	}
	return "";
}

Material changed(double Hardening::* member, double value)
{
	Material material = aluminium.material;
	material.hardening.*member = value;
	return material;
}
}

TEST(Elastoplastic, BadParametersAreNamedWithTheirValues)
{
	EXPECT_EQ(refusalOf(aluminium.material), "");
	EXPECT_EQ(refusalOf(elastic.material), "");
	EXPECT_EQ(refusalOf({ -1, aluminium.material.hardening }), "yieldStress must be positive, got -1");
	EXPECT_EQ(refusalOf({ NAN, aluminium.material.hardening }), "yieldStress must be positive, got nan");
	EXPECT_EQ(refusalOf(changed(&Hardening::referenceRadius, 0)), "referenceRadius must be finite and positive, got 0");
	EXPECT_EQ(refusalOf(changed(&Hardening::exponent, 3)), "exponent must be between 0 and 3, got 3");
	EXPECT_EQ(refusalOf(changed(&Hardening::exponent, 0)), "exponent must be between 0 and 3, got 0");
	EXPECT_EQ(refusalOf(changed(&Hardening::m1, infinity)), "m1 must be finite, got inf");
	EXPECT_EQ(refusalOf(changed(&Hardening::smallestRatio, -2)), "smallestRatio must be finite and positive, got -2");
	EXPECT_EQ(refusalOf(changed(&Hardening::largestRatio, 0.5)), "largestRatio must be at least smallestRatio, got 0.5");
	// 2.6 - r is negative at the largest radius; 2.6 - 3.3 r + r^2 only between both ends.
	EXPECT_EQ(refusalOf(changed(&Hardening::m1, -1)),
	        "m0 + m1 r + m2 r^2 must be positive for r from smallestRatio to largestRatio, got -1.4");
	Material dip = changed(&Hardening::m1, -3.3);
	dip.hardening.m2 = 1;
	EXPECT_NE(refusalOf(dip), "");
	dip.hardening.m1 = -3.1;
	EXPECT_EQ(refusalOf(dip), "");
}

TEST(Elastoplastic, HardeningIsTheParabolaWithinTheFitAndConstantOutside)
{
	const Hardening hardening { 2e-3, 3, -0.5, 0.25, 2 };
	EXPECT_DOUBLE_EQ(hardening.factor(5e-3), 3 - 0.5 * 2.5 + 0.25 * 6.25);
	EXPECT_DOUBLE_EQ(hardening.factor(1e-3), 3 - 0.5 + 0.25);
	EXPECT_DOUBLE_EQ(hardening.factor(1), 3 - 0.5 * 4 + 0.25 * 16);
}

TEST(Elastoplastic, TheSofterMaterialYieldsInAnyOrder)
{
	const Material soft { 50e6, aluminium.material.hardening };
	EXPECT_EQ(&softer(soft, aluminium.material), &soft);
	EXPECT_EQ(&softer(aluminium.material, soft), &soft);
	EXPECT_EQ(&softer(elastic.material, soft), &soft);
	const Material twin = changed(&Hardening::m0, 2);
	EXPECT_EQ(&softer(twin, aluminium.material), &softer(aluminium.material, twin));
}

TEST(Elastoplastic, YieldPointFollowsEquations5To7)
{
	const YieldPoint point = yieldOf(aluminium);
	const double p = 1.6 * 100e6;
	EXPECT_DOUBLE_EQ(point.pressure, p);
	EXPECT_NEAR(point.force, pi * pi * pi * radius * radius * p * p * p / (6 * modulus * modulus), 1e-14 * point.force);
	EXPECT_NEAR(point.overlap, std::pow(pi * p / (2 * modulus), 2) * radius, 1e-14 * point.overlap);
	EXPECT_NEAR(point.contactRadius, std::sqrt(radius * point.overlap), 1e-14 * point.contactRadius);
	EXPECT_NEAR(point.force, hertzForce(aluminium, point.overlap), 1e-14 * point.force);
	// The pressure in the middle of Hertz's contact is 3/2 of the mean.
	EXPECT_NEAR(1.5 * point.force / (pi * point.contactRadius * point.contactRadius), p, 1e-14 * p);
}

TEST(Elastoplastic, ANeverYieldingMaterialIsHertz)
{
	const superquadric::hertzMindlin::Pair hertz { modulus, radius, mass };
	for (double d : { 1e-300, 1e-9, 1e-5, 1e-3 }) {
		const State state = followed(elastic, { 2 * d, d / 2, d });
		const auto expected = superquadric::hertzMindlin::normalForce(hertz, 0, d, 0);
		EXPECT_NEAR(state.force, expected.elastic, 1e-15 * expected.elastic);
		EXPECT_NEAR(state.stiffness, expected.stiffness, 1e-15 * expected.stiffness);
		EXPECT_NEAR(state.elastic, superquadric::hertzMindlin::normalEnergy(hertz.hertz(), d), 1e-15 * expected.elastic * d);
		EXPECT_EQ(state.history.dissipated, 0);
		EXPECT_EQ(state.history.residual, 0);
	}
}

TEST(Elastoplastic, UnloadingIsHertzWithTheDiscOfLoading)
{
	const double largest = 40 * yieldOf(aluminium).overlap;
	const State top = followed(aluminium, { largest });
	const double residual = top.history.residual, flattened = radius * largest / (largest - residual);
	EXPECT_GT(flattened, radius);
	EXPECT_NEAR(top.force, LoadingCurve(aluminium).force(largest), 1e-13 * top.force);
	for (double part : { 0.1, 0.5, 0.9 }) {
		const double length = part * (largest - residual);
		const State state = followed(aluminium, { largest, residual + length });
		EXPECT_NEAR(state.force, 4. / 3 * modulus * std::sqrt(flattened * length) * length, 1e-13 * top.force);
		EXPECT_LT(state.force, LoadingCurve(aluminium).force(residual + length));
	}
	const double h = 1e-6 * largest, d = (largest + residual) / 2;
	const auto at = [&](double overlap) { return followed(aluminium, { largest, overlap }); };
	EXPECT_NEAR(at(d).stiffness, (at(d + h).force - at(d - h).force) / (2 * h), 1e-8 * at(d).stiffness);
	EXPECT_NEAR(at(d).force, (at(d + h).elastic - at(d - h).elastic) / (2 * h), 1e-8 * at(d).force);
	EXPECT_EQ(at(residual).force, 0);
	EXPECT_EQ(at(residual / 2).force, 0);
	EXPECT_EQ(at(-residual).elastic, 0);
	EXPECT_EQ(at(-residual).history.residual, residual);
}

TEST(Elastoplastic, UnloadingIsNeverStrongerThanLoadingAndAtLeastAsStiff)
{
	for (const Pair& pair : pairs)
		for (double part : { 1.001, 1.5, 2., 4., 30., 1e4 }) {
			const double largest = part * yieldOf(pair).overlap;
			const State top = followed(pair, { largest });
			ASSERT_LE(top.stiffness, top.unloadingStiffness * (1 + 1e-12));
			ASSERT_GE(top.history.dissipated, 0);
			const double rounding = 1e-14 * largest / (largest - top.history.residual) * top.force;
			for (int i = 0; i <= 1000; ++i) {
				const double d = largest * i / 1000;
				ASSERT_LE(normalForce(pair, top.history, d).force, LoadingCurve(pair).force(d) + rounding);
			}
		}
}

TEST(Elastoplastic, ReloadingRetracesTheBranchAndThenTheVirginCurve)
{
	for (const Pair& pair : pairs) {
		const double dy = yieldOf(pair).overlap, largest = 20 * dy;
		State state = followed(pair, { largest });
		const double dissipated = state.history.dissipated;
		std::vector<double> down;
		for (int i = 50; i >= 0; --i) {
			state = normalForce(pair, state.history, largest * i / 50);
			down.push_back(state.force);
		}
		for (int cycle = 0; cycle < 3; ++cycle)
			for (int i = 0; i <= 50; ++i) {
				state = normalForce(pair, state.history, largest * (cycle % 2 ? 50 - i : i) / 50);
				ASSERT_EQ(state.force, down[cycle % 2 ? i : 50 - i]);
				ASSERT_EQ(state.history.dissipated, dissipated);
			}
		const State further = normalForce(pair, state.history, 2 * largest), direct = followed(pair, { 2 * largest });
		EXPECT_EQ(further.force, direct.force);
		EXPECT_EQ(further.history.dissipated, direct.history.dissipated);
		EXPECT_GT(further.history.dissipated, dissipated);
	}
}

// Why the contact keeps R of its first touch: a cycle of overlap and R would give energy, whether the history were kept as overlaps
// (R grows while pressed, shrinks while apart) or as forces (the other way round).
TEST(Elastoplastic, AHardenedContactDoesNotFollowTheCurvature)
{
	const double largest = 40 * yieldOf(aluminium).overlap;
	const State top = followed(aluminium, { largest });
	Pair other = aluminium;
	other.radius *= 1.2;
	const State kept = normalForce(other, top.history, largest);
	EXPECT_EQ(kept.force, top.force);
	EXPECT_EQ(kept.elastic, top.elastic);

	History asOverlaps = top.history;
	asOverlaps.radius *= 1.2;
	EXPECT_GT(normalForce(other, asOverlaps, largest).elastic, 1.05 * top.elastic);

	History asForces = top.history;
	asForces.radius /= 1.2;
	asForces.residual = largest - (largest - top.history.residual) * std::sqrt(1.2);
	const State renewed = normalForce(other, asForces, largest);
	EXPECT_NEAR(renewed.force, top.force, 1e-12 * top.force);
	EXPECT_GT(renewed.elastic, 1.05 * top.elastic);
}

TEST(Elastoplastic, NothingHappensBeforeTheFirstTouch)
{
	for (double d : { -1e-3, 0. }) {
		const State state = normalForce(aluminium, {}, d);
		EXPECT_EQ(state.force, 0);
		EXPECT_EQ(state.stiffness, 0);
		EXPECT_EQ(state.history.radius, 0);
	}
	EXPECT_EQ(normalForce(aluminium, {}, 1e-9).history.radius, radius);
}
