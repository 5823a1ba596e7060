// The mean curvature of 200 random shapes against half the divergence of their unit normal, differenced numerically.
#include <pkg/geometry/Curvature.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

// Fourth-order differences of the unit normal of eq. (1), normals by complex steps. With the step at 1e-4 of the smallest half size and
// edges of 1/20 of it or rounder the error is below 1e-8 of the curvature's scale, away from the coordinate planes.
Real divergenceOfNormal(const ReferenceShape& shape, const RealVector& x)
{
	const Real step = 1e-4L * shape.sizes.minCoeff();
	Real sum = 0;
	for (int axis = 0; axis < 3; ++axis) {
		const RealVector h = step * RealVector::Unit(axis);
		sum += 8 * (shape.normal(x + h)[axis] - shape.normal(x - h)[axis]) - (shape.normal(x + 2 * h)[axis] - shape.normal(x - 2 * h)[axis]);
	}
	return sum / (12 * step);
}

Vector3 onSurface(const ReferenceShape& reference, RandomBodies& random)
{
	RealVector ray = random.direction().cwiseProduct(reference.sizes.cast<double>()).cast<Real>();
	while (ray.cwiseQuotient(reference.sizes).cwiseAbs().minCoeff() < 0.02L)
		ray = random.direction().cwiseProduct(reference.sizes.cast<double>()).cast<Real>();
	return (ray / std::pow(reference.function(ray), 1 / reference.n1)).cast<double>();
}

} // namespace

TEST(Curvature, OfRandomShapesAgainstTheDivergenceOfTheNormal)
{
	RandomBodies random(31);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape(i % 2 ? 1 : 1e-3);
		const ReferenceShape reference(shape);
		for (int k = 0; k < 5; ++k) {
			const Vector3 x = onSurface(reference, random);
			const double expected = divergenceOfNormal(reference, x.cast<Real>()) / 2;
			const double scale = std::max(expected, 1 / shape.boundingRadius());
			EXPECT_NEAR(meanCurvature(shape, x), expected, 1e-6 * scale) << shape.halfSizes().transpose() << " " << shape.n1() << " " << shape.n2();
			EXPECT_GE(meanCurvature(shape, x), 0); // convex
			// Anywhere on the ray through the point, and of the gauge's own level surface there.
			EXPECT_NEAR(meanCurvature(shape, 0.3 * x), expected, 1e-6 * scale);
			EXPECT_NEAR(meanCurvature(shape.jet((0.5 * x).cwiseProduct(shape.inverseHalfSizes())), shape.inverseHalfSizes()), 2 * expected, 2e-6 * scale);
		}
	}
}

TEST(Curvature, OfASphereIsOneOverItsRadius)
{
	RandomBodies random(32);
	for (double radius : { 1e-6, 1e-3, 1.0, 10.0 }) {
		const Shape sphere(Vector3::Constant(radius), 2, 2);
		for (const Vector3& x : { Vector3(random.direction()), Vector3(Vector3::UnitX()), Vector3(-Vector3::UnitZ()), Vector3(0, 1, -1) })
			EXPECT_NEAR(meanCurvature(sphere, radius * x) * radius, 1, 1e-13);
	}
}

// Eq. (10) in F itself, sign turned, is the same number: the gauge is a matter of conditioning only.
TEST(Curvature, IsEquationTen)
{
	RandomBodies random(33);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape();
		const Vector3 x = onSurface(ReferenceShape(shape), random);
		const Vector3 G = shape.functionGradient(x);
		const Matrix3 H = shape.functionHessian(x);
		const double kMean = (G.dot(H * G) - G.squaredNorm() * H.trace()) / (2 * std::pow(G.norm(), 3));
		EXPECT_NEAR(meanCurvature(shape, x), -kMean, 1e-9 * std::max(-kMean, 1 / shape.boundingRadius()));
	}
}

// Found by the fuzz tests: at the pole it came out as -1e-18, by rounding.
TEST(Curvature, OfAFaceIsNotNegative)
{
	const Shape slender(Vector3(9.99976974414163, 9.99976974414163, 99.99539493585037), 8, 2);
	EXPECT_EQ(meanCurvature(slender, Vector3(0, 0, 99.99539493585037)), 0);
}

TEST(Curvature, OfFlatFacesAndOfTheBarrelOfACylinder)
{
	const Shape block(Vector3(1, 2, 3), 20, 20), cylinder(Vector3(2, 2, 3), 8, 2);
	for (int axis = 0; axis < 3; ++axis)
		EXPECT_EQ(meanCurvature(block, block.halfSizes()[axis] * Vector3::Unit(axis)), 0);
	EXPECT_EQ(meanCurvature(cylinder, Vector3(0, 0, 3)), 0);
	EXPECT_NEAR(meanCurvature(cylinder, Vector3(0, 2, 0)), 0.25, 1e-14); // half of 1/R: straight along z
	EXPECT_NEAR(meanCurvature(cylinder, Vector3(1, 1, 0)), 0.25, 1e-14);
}
