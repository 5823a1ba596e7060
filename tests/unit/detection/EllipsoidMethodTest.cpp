// The fallback alone: it must end with true bounds on any pair, also those that Newton never hands over.
#include <pkg/detection/EllipsoidMethod.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <tests/oracle/CommonScaling.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

void expectBounds(const ScalingBounds& bounds, const ScalingInterval& reference)
{
	const Real t = reference.middle();
	EXPECT_LE(bounds.lower, t * (1 + 1e-13));
	EXPECT_GE(bounds.upper, t * (1 - 1e-13));
	EXPECT_LE(bounds.upper - bounds.lower, 1e-10 * t);
}

} // namespace

TEST(EllipsoidMethod, BoundsTheScalingOfRandomPairs)
{
	RandomBodies random(91);
	for (int i = 0; i < 300; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape(random.logarithmic(0.01, 1));
		const Matrix3 rotation1 = random.rotation();
		// A third with parallel axes, where faces meet.
		const Placement body1 { shape1, random.direction(), rotation1 }, body2 { shape2, body1.position + random.direction(), i % 3 ? random.rotation() : rotation1 };
		const PairProblem problem(body1, body2);
		const ScalingBounds bounds = minimiseScaling(problem);
		expectBounds(bounds, commonScaling(body1, body2));
		// The point found is worth what is said of it.
		const double g1 = body1.gauge(bounds.x - problem.centre1()), g2 = body2.gauge(bounds.x - problem.centre2());
		EXPECT_NEAR(std::max(g1, g2), bounds.upper, 1e-13 * bounds.upper);
	}
}

TEST(EllipsoidMethod, OfSpheresIsTheDistanceOverTheRadii)
{
	const Shape small(Vector3::Constant(0.01), 2, 2), large(Vector3::Constant(1), 2, 2);
	for (double distance : { 0.5, 1.01, 2.0 }) {
		const Placement body1 { large, Vector3::Zero(), Matrix3::Identity() }, body2 { small, distance * Vector3(1, 2, 2) / 3, Matrix3::Identity() };
		const ScalingBounds bounds = minimiseScaling(PairProblem(body1, body2));
		EXPECT_NEAR(bounds.upper, distance / 1.01, 1e-11);
		EXPECT_NEAR(bounds.lower, distance / 1.01, 1e-11);
	}
}

TEST(EllipsoidMethod, DoesNotKnowTheMetre)
{
	RandomBodies random(92);
	for (int i = 0; i < 50; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape();
		const Matrix3 rotation1 = random.rotation(), rotation2 = random.rotation();
		const Vector3 between = random.direction();
		double first = 0;
		for (double size : { 1.0, 1e-6, 1e-3, 10.0 }) {
			const Shape copy1(size * shape1.halfSizes(), shape1.n1(), shape1.n2()), copy2(size * shape2.halfSizes(), shape2.n1(), shape2.n2());
			const Placement body1 { copy1, Vector3::Zero(), rotation1 }, body2 { copy2, size * between, rotation2 };
			const ScalingBounds bounds = minimiseScaling(PairProblem(body1, body2));
			EXPECT_LE(bounds.upper - bounds.lower, 1e-10 * bounds.upper);
			if (size == 1) first = bounds.upper;
			EXPECT_NEAR(bounds.upper, first, 1e-10 * first);
		}
	}
}
