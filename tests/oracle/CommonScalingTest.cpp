// The oracle itself, where the answer is known otherwise.
#include "CommonScaling.hpp"

#include <tests/unit/RandomBodies.hpp>

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
