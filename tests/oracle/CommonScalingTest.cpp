// The oracle itself, where the answer is known otherwise.
#include "CommonScaling.hpp"
#include "RandomPairs.hpp"

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

TEST(CommonScaling, OfSpheresIsTheDistanceOverTheRadii)
{
	RandomBodies random(51);
	for (int i = 0; i < 50; ++i) {
		const Shape small(Vector3::Constant(random.uniform(0.01, 1)), 2, 2), large(Vector3::Constant(1), 2, 2);
		const Placement body1 { small, random.direction(), random.rotation() }, body2 { large, 3 * random.direction(), random.rotation() };
		const double expected = (body2.position - body1.position).norm() / (small.boundingRadius() + 1);
		const ScalingInterval t = commonScaling(body1, body2);
		EXPECT_NEAR(t.middle(), expected, 1e-14 * expected);
		EXPECT_LT(t.halfWidth(), 1e-14);
	}
}

// Parallel bodies of the same kind add up to one of the kind: t* is the gauge of the sum.
TEST(CommonScaling, OfScaledCopiesIsTheGaugeOfTheirSum)
{
	RandomBodies random(52);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape();
		const double ratio = random.logarithmic(0.01, 1);
		const Shape copy(ratio * shape.halfSizes(), shape.n1(), shape.n2());
		const Matrix3 rotation = random.rotation();
		const Placement body1 { shape, Vector3::Zero(), rotation }, body2 { copy, 2 * random.direction(), rotation };
		const Real f = ReferenceShape(shape).function(body1.toBody(body2.position));
		const double expected = std::pow(f, 1 / Real(shape.n1())) / (1 + ratio);
		const ScalingInterval t = commonScaling(body1, body2);
		EXPECT_NEAR(t.middle() / expected, 1, 1e-13);
		EXPECT_LT(t.halfWidth() / expected, 1e-13);
	}
}

// Both bounds against points: no point common to both bodies at a scaling below the lower bound, found by looking at many.
TEST(CommonScaling, NoPointUndercutsTheLowerBound)
{
	RandomBodies random(53);
	for (int i = 0; i < 50; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape(random.logarithmic(0.1, 1));
		const Placement body1 { shape1, Vector3::Zero(), random.rotation() }, body2 { shape2, 2 * random.direction(), random.rotation() };
		const ScalingInterval t = commonScaling(body1, body2);
		EXPECT_LT(t.halfWidth(), 1e-13 * t.upper);
		const ReferenceShape reference1(shape1), reference2(shape2);
		for (int k = 0; k < 2000; ++k) {
			const Vector3 x = random.uniform() * body2.position + random.uniform() * random.direction();
			const Real g1 = std::pow(reference1.function(body1.toBody(x)), 1 / reference1.n1);
			const Real g2 = std::pow(reference2.function(body2.toBody(x - body2.position)), 1 / reference2.n1);
			EXPECT_GE(std::max(g1, g2), t.lower);
		}
	}
}

// What the double's interval claims beyond its own rounding is checked by the long double's, three digits narrower.
TEST(CommonScaling, InDoubleEnclosesTheLongDoubles)
{
	Real worst = 0;
	for (int i = 0; i < 2000; ++i) {
		const RandomPair pair(54, i);
		const Shape shape1(pair.sizes1, pair.n11, pair.n12), shape2(pair.sizes2, pair.n21, pair.n22);
		const Placement body1 { shape1, Vector3::Zero(), pair.rotation1 }, body2 { shape2, pair.along, pair.rotation2 };
		const ScalingInterval coarse = commonScaling<double>(body1, body2), fine = commonScaling<Real>(body1, body2);
		ASSERT_LE(coarse.lower, fine.lower) << pair.kind << " pair " << i;
		ASSERT_GE(coarse.upper, fine.upper) << pair.kind << " pair " << i;
		EXPECT_LT(coarse.halfWidth(), 1e-13L * coarse.middle());
		EXPECT_LT(fine.halfWidth(), 1e-15L * fine.middle());
		worst = std::max(worst, std::abs(coarse.middle() / fine.middle() - 1));
	}
	// It stays well inside: no more than half of what is allowed for rounding.
	EXPECT_LT(worst, CommonScaling<double>::roundingSteps * std::numeric_limits<double>::epsilon() / 2);
}

// A part of a long run must ask the pairs that the whole would.
TEST(RandomPair, DependsOnSeedAndNumberOnly)
{
	const RandomPair one(61, 7), again(61, 7), next(61, 8), other(62, 7);
	EXPECT_EQ(one.sizes1, again.sizes1);
	EXPECT_EQ(one.rotation2, again.rotation2);
	EXPECT_EQ(one.scaling, again.scaling);
	EXPECT_NE(one.sizes1, next.sizes1);
	EXPECT_NE(one.sizes1, other.sizes1);
}
