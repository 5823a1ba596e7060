// The shape function, gauge and support function against eq. (1) in long double, complex steps and searches over the surface.
#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <limits>
#include <string>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr int shapes = 200;

// Points in, on and outside a body, also on its coordinate planes and axes.
Vector3 randomPoint(RandomBodies& random, const Shape& shape)
{
	Vector3 ratios = random.direction() * random.uniform(0.2, 2);
	switch (random.index(4)) {
		case 0: ratios[random.index(3)] = 0; break;
		case 1: {
			const int kept = random.index(3);
			for (int axis = 0; axis < 3; ++axis)
				if (axis != kept) ratios[axis] = 0;
		}
	}
	return ratios.cwiseProduct(shape.halfSizes());
}

// Derivatives are compared without units, in half sizes.
Vector3 unitless(const Shape& shape, const Vector3& gradient) { return gradient.cwiseProduct(shape.halfSizes()); }

std::string messageOf(const Vector3& halfSizes, double n1, double n2)
{
	try {
		Shape shape(halfSizes, n1, n2);
	} catch (const std::invalid_argument& error) {
		return error.what();
	}
	return "";
}

void expectRefused(const Vector3& halfSizes, double n1, double n2, const std::string& parameter, const std::string& value)
{
	const std::string message = messageOf(halfSizes, n1, n2);
	EXPECT_NE(message.find(parameter), std::string::npos) << "message: " << message;
	EXPECT_NE(message.find(value), std::string::npos) << "message: " << message;
}

} // namespace

TEST(Shape, FunctionIsEquationOne)
{
	RandomBodies random(11);
	for (int i = 0; i < shapes; ++i) {
		const Shape shape = random.shape();
		const ReferenceShape reference(shape);
		for (int k = 0; k < 20; ++k) {
			const Vector3 x = randomPoint(random, shape);
			const double f = reference.function(x);
			EXPECT_NEAR(shape.function(x), f, 2e-14 * shape.n1() * f);
			EXPECT_NEAR(std::pow(shape.gauge(x), shape.n1()), f, 2e-14 * shape.n1() * f);
		}
	}
}

TEST(Shape, GradientIsThatOfEquationOne)
{
	RandomBodies random(12);
	for (int i = 0; i < shapes; ++i) {
		const Shape shape = random.shape();
		const ReferenceShape reference(shape);
		for (int k = 0; k < 20; ++k) {
			const Vector3 x = randomPoint(random, shape);
			const Vector3 expected = unitless(shape, reference.gradient(x.cast<Real>()).cast<double>());
			EXPECT_LT((unitless(shape, shape.functionGradient(x)) - expected).norm(), 1e-12 * expected.norm());
		}
	}
}

// Reference: fourth-order central differences of the complex-step gradient. Across a coordinate plane they need the fifth derivative
// of |x|^n, so points on a plane are left to exponents that have it.
TEST(Shape, HessianIsThatOfEquationOne)
{
	RandomBodies random(13);
	double worst = 0;
	for (int i = 0; i < shapes; ++i) {
		const bool onPlanes = i % 2;
		const Vector3 sizes = random.halfSizes();
		const double even[] = { 2, 6, 8, 20 };
		const double n1 = onPlanes ? even[random.index(4)] : random.exponent();
		const double n2 = onPlanes ? even[random.index(4)] : random.exponent();
		const Shape shape(sizes, n1, n2);
		const ReferenceShape reference(shape);
		for (int k = 0; k < 10; ++k) {
			Vector3 ratios = random.direction() * random.uniform(0.2, 2);
			if (onPlanes) ratios[random.index(3)] = 0;
			if (!onPlanes && ratios.cwiseAbs().minCoeff() < 0.02) continue;
			const RealVector x = ratios.cwiseProduct(sizes).cast<Real>();
			Matrix3 expected;
			for (int column = 0; column < 3; ++column) {
				RealVector step = RealVector::Zero();
				step[column] = 1e-4L * sizes[column];
				const RealVector difference = 8 * (reference.gradient(x + step) - reference.gradient(x - step))
				        - (reference.gradient(x + 2 * step) - reference.gradient(x - 2 * step));
				expected.col(column) = (difference / (12 * step[column])).cast<double>();
			}
			const Matrix3 scale = sizes * sizes.transpose();
			const Matrix3 expectedUnitless = expected.cwiseProduct(scale), actual = shape.functionHessian(x.cast<double>()).cwiseProduct(scale);
			worst = std::max(worst, (actual - expectedUnitless).norm() / expectedUnitless.norm());
		}
	}
	EXPECT_LT(worst, 1e-7);
	RecordProperty("worstRelativeError", std::to_string(worst));
}

// Where exponents are at their ends, on an axis: Hessians in closed form.
TEST(Shape, HessianOnTheAxes)
{
	const Vector3 sizes(0.5, 1, 2);
	const Matrix3 ellipsoid = 2 * sizes.cwiseAbs2().cwiseInverse().asDiagonal();
	for (int axis = 0; axis < 3; ++axis) {
		const Vector3 x = Vector3::Unit(axis) * 0.7 * sizes[axis];
		EXPECT_LT((Shape(sizes, 2, 2).functionHessian(x) - ellipsoid).norm(), 1e-13 * ellipsoid.norm());
		Matrix3 block = Matrix3::Zero();
		block(axis, axis) = 20 * 19 * std::pow(0.7, 18) / (sizes[axis] * sizes[axis]);
		EXPECT_LT((Shape(sizes, 20, 20).functionHessian(x) - block).norm(), 1e-12 * block.norm());
	}
}

TEST(Shape, GaugeIsHomogeneousAndItsDerivativesObeyEuler)
{
	RandomBodies random(14);
	for (int i = 0; i < shapes; ++i) {
		const Shape shape = random.shape();
		const Vector3 x = randomPoint(random, shape);
		const GaugeValue g = shape.gaugeWithHessian(x);
		const double factor = random.logarithmic(1e-6, 1e6);
		EXPECT_NEAR(shape.gauge(factor * x), factor * g.value, 1e-13 * factor * g.value);
		EXPECT_NEAR(g.gradient.dot(x), g.value, 1e-13 * g.value);
		EXPECT_LT((g.hessian * x).cwiseProduct(shape.halfSizes()).norm(), 1e-12 * shape.n1());
		const Matrix3 squares = shape.halfSizes() * shape.halfSizes().transpose(); // of units
		const GaugeValue scaled = shape.gaugeWithHessian(factor * x);
		EXPECT_LT(unitless(shape, scaled.gradient - g.gradient).norm(), 1e-12);
		EXPECT_LE((factor * scaled.hessian - g.hessian).cwiseProduct(squares).norm(), 1e-11 * g.hessian.cwiseProduct(squares).norm() + 1e-14 * shape.n1() * shape.n1());
		EXPECT_EQ(shape.gaugeWithGradient(x).gradient, g.gradient);
	}
}

// The dual norm of a gradient of the gauge is one, and the support point of that gradient is the point scaled to the surface.
TEST(Shape, SupportIsDualToTheGauge)
{
	RandomBodies random(15);
	for (int i = 0; i < shapes; ++i) {
		const Shape shape = random.shape();
		for (int k = 0; k < 20; ++k) {
			const GaugeValue g = shape.gaugeWithGradient(randomPoint(random, shape));
			EXPECT_NEAR(shape.support(g.gradient), 1, 1e-13);
		}
		const Vector3 x = random.direction().cwiseProduct(shape.halfSizes());
		const GaugeValue g = shape.gaugeWithGradient(x);
		const Vector3 back = shape.supportPoint(g.gradient) - x / g.value;
		EXPECT_LT(back.cwiseQuotient(shape.halfSizes()).norm(), 1e-12);
	}
}

TEST(Shape, SupportPointLiesOnTheSurfaceAndIsFarthest)
{
	RandomBodies random(16);
	for (int i = 0; i < shapes; ++i) {
		const Shape shape = random.shape();
		const ReferenceShape reference(shape);
		Vector3 direction = random.direction();
		if (i % 5 == 0) direction[random.index(3)] = 0;
		if (i % 7 == 0) direction = Vector3::Unit(random.index(3)) * (i % 2 ? 1 : -1);
		const Vector3 point = shape.supportPoint(direction);
		EXPECT_NEAR(reference.function(point), 1, 1e-13 * shape.n1());
		EXPECT_NEAR(point.dot(direction), shape.support(direction), 1e-14 * shape.boundingRadius());
		EXPECT_NEAR(shape.support(direction), reference.searchedSupport(direction), 1e-14 * shape.boundingRadius());
		for (int k = 0; k < 500; ++k) {
			const RealVector other = reference.surfacePoint(random.uniform(-pi / 2, pi / 2), random.uniform(-pi, pi));
			EXPECT_LE(other.cast<double>().dot(direction), shape.support(direction) + 1e-14 * shape.boundingRadius());
		}
	}
}

TEST(Shape, SupportOfTheEndsOfTheRange)
{
	// n = 2: an ellipsoid. A block's h tends to |a dx| + |b dy| + |c dz| from below.
	const Vector3 sizes(0.5, 1, 2), direction = Vector3(3, -2, 1).normalized();
	EXPECT_NEAR(Shape(sizes, 2, 2).support(direction), sizes.cwiseProduct(direction).norm(), 1e-15);
	const double box = sizes.dot(direction.cwiseAbs()), block = Shape(sizes, 20, 20).support(direction);
	EXPECT_LT(block, box);
	EXPECT_GT(block, std::pow(3.0, -1.0 / 20) * box); // the scaled box with its corner on the surface lies inside
}

TEST(Shape, BoundingRadiusIsTheFarthestSurfacePoint)
{
	RandomBodies random(17);
	for (int i = 0; i < shapes; ++i) {
		const Shape shape = random.shape();
		const RealVector farthest = ReferenceShape(shape).largestPoint(RealVector::Ones(), 2);
		EXPECT_NEAR(shape.boundingRadius(), farthest.norm(), 1e-14 * shape.boundingRadius());
		for (int k = 0; k < 200; ++k) {
			const Vector3 direction = random.direction();
			EXPECT_LE(1 / shape.gauge(direction), shape.boundingRadius() * (1 + 1e-14));
		}
	}
}

// Physics does not know the metre: a body and its copy of another size have the same gauge at the same relative point.
TEST(Shape, SizesFromMicrometresToMetres)
{
	RandomBodies random(18);
	for (double size : { 1e-6, 1e-3, 10.0 })
		for (int i = 0; i < shapes; ++i) {
			const Shape shape = random.shape(), scaled(size * shape.halfSizes(), shape.n1(), shape.n2());
			const Vector3 x = randomPoint(random, shape), direction = random.direction();
			EXPECT_NEAR(scaled.gauge(size * x), shape.gauge(x), 1e-14 * shape.gauge(x));
			EXPECT_NEAR(scaled.support(direction), size * shape.support(direction), 1e-14 * size * shape.support(direction));
			EXPECT_NEAR(scaled.boundingRadius(), size * shape.boundingRadius(), 1e-14 * scaled.boundingRadius());
			EXPECT_LT((size * scaled.gaugeWithGradient(size * x).gradient - shape.gaugeWithGradient(x).gradient).norm(),
			        1e-13 * shape.gaugeWithGradient(x).gradient.norm());
		}
}

TEST(Shape, CentreHasGaugeZeroAndNoDirection)
{
	const Shape shape(Vector3(1, 2, 3), 3.3, 5);
	EXPECT_EQ(shape.gauge(Vector3::Zero()), 0);
	EXPECT_EQ(shape.gaugeWithGradient(Vector3::Zero()).gradient, Vector3::Zero());
	EXPECT_THROW(shape.supportPoint(Vector3::Zero()), std::invalid_argument);
}

TEST(Shape, RefusesBadInputNamingParameterAndValue)
{
	const double infinite = std::numeric_limits<double>::infinity(), undefined = std::numeric_limits<double>::quiet_NaN();
	expectRefused(Vector3(0, 1, 1), 2, 2, "extents[0]", "0");
	expectRefused(Vector3(1, -0.25, 1), 2, 2, "extents[1]", "-0.25");
	expectRefused(Vector3(1, 1, infinite), 2, 2, "extents[2]", "inf");
	expectRefused(Vector3(1, undefined, 1), 2, 2, "extents[1]", "nan");
	expectRefused(Vector3(1, 1, 1), 1.5, 2, "n1", "1.5");
	expectRefused(Vector3(1, 1, 1), 2, 20.5, "n2", "20.5");
	expectRefused(Vector3(1, 1, 1), 2, undefined, "n2", "nan");
	expectRefused(Vector3(1, 1, 1), infinite, 2, "n1", "inf");
	// Products of sizes beyond would overflow or vanish.
	expectRefused(Vector3(1, 1, 9e-31), 2, 2, "extents[2]", "9e-31");
	expectRefused(Vector3(1.1e30, 1, 1), 2, 2, "extents[0]", "1.1e+30");
	EXPECT_EQ(messageOf(Vector3(1, 1, 1), 2, 20), "");
	EXPECT_EQ(messageOf(Vector3(1e-6, 10, 1), 20, 2), "");
}

TEST(Shape, RefusedAssignmentLeavesTheOldShape)
{
	Shape shape(Vector3(1, 2, 3), 4, 5);
	EXPECT_THROW(shape = Shape(Vector3(1, 2, -3), 6, 7), std::invalid_argument);
	EXPECT_EQ(shape.halfSizes(), Vector3(1, 2, 3));
	EXPECT_EQ(shape.n1(), 4);
	EXPECT_EQ(shape.n2(), 5);
}
