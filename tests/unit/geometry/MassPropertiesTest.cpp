// Volume and inertia of 200 random shapes against integrals over their sections, done numerically. The sections at height z are
// copies of the one at z = 0 scaled by s = (1 - |z/c|^n1)^(1/n1). The quadrature (tanh-sinh, made for the infinite slopes at the ends)
// is good to 1e-15: halving its step changes nothing above that, which is part of the test.
#include <pkg/geometry/MassProperties.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

// Integral over u in [0, 1] of f(u, 1 - u): the distance from the end comes apart, so that no digits of it are lost.
template <class Function> Real integral(const Function& f, Real step)
{
	Real sum = 0;
	for (Real t = -6; t <= 6; t += step) {
		const Real argument = realPi * std::sinh(t);
		const Real u = 1 / (1 + std::exp(-argument)), rest = 1 / (1 + std::exp(argument));
		sum += f(u, rest) * realPi * std::cosh(t) * u * rest;
	}
	return sum * step;
}

// (1 - u^n)^power.
Real remainder(Real u, Real rest, Real n, Real power)
{
	const Real logarithm = rest < 0.5L ? std::log1p(-rest) : std::log(u);
	return std::pow(-std::expm1(n * logarithm), power);
}

struct Moments {
	Real volume, xx, yy, zz; // of 1, x^2, y^2 and z^2
};

Moments integrated(const ReferenceShape& shape, Real step)
{
	const Real a = shape.sizes[0], b = shape.sizes[1], c = shape.sizes[2];
	const auto section = [&](int power) { return integral([&](Real u, Real rest) { return std::pow(u, power) * remainder(u, rest, shape.n2, 1 / shape.n2); }, step); };
	const auto heights = [&](int power, int scaling) {
		return integral([&](Real u, Real rest) { return std::pow(u, power) * remainder(u, rest, shape.n1, scaling / shape.n1); }, step);
	};
	const Real octants = 8 * a * b * c, area = section(0), second = section(2);
	return { octants * area * heights(0, 2), octants * a * a * second * heights(0, 4), octants * b * b * second * heights(0, 4), octants * c * c * area * heights(2, 2) };
}

} // namespace

TEST(MassProperties, OfRandomShapesAgainstIntegrals)
{
	RandomBodies random(21);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape(i % 2 ? 1 : 1e-3);
		const Moments m = integrated(ReferenceShape(shape), 1.0L / 32), coarse = integrated(ReferenceShape(shape), 1.0L / 16);
		ASSERT_NEAR(m.volume / coarse.volume, 1, 1e-15);
		ASSERT_NEAR(m.zz / coarse.zz, 1, 1e-15);
		EXPECT_NEAR(volume(shape) / m.volume, 1, 1e-13);
		const Vector3 inertia = inertiaOfUnitDensity(shape);
		EXPECT_NEAR(inertia.x() / (m.yy + m.zz), 1, 1e-13);
		EXPECT_NEAR(inertia.y() / (m.xx + m.zz), 1, 1e-13);
		EXPECT_NEAR(inertia.z() / (m.xx + m.yy), 1, 1e-13);
	}
}

// The references themselves, on bodies everyone knows.
TEST(MassProperties, OfAnEllipsoid)
{
	const Shape shape(Vector3(1, 2, 3), 2, 2);
	const double expected = 4 * pi / 3 * 6;
	EXPECT_NEAR(volume(shape), expected, 1e-14 * expected);
	EXPECT_LT((inertiaOfUnitDensity(shape) - expected / 5 * Vector3(13, 10, 5)).norm(), 1e-13 * expected);
	EXPECT_NEAR(integrated(ReferenceShape(shape), 1.0L / 32).volume, expected, 1e-14 * expected);
}

// Blocks fill their box, cylinders theirs, as the exponent grows; a count of random points needs no formula at all.
TEST(MassProperties, AgainstACountOfRandomPoints)
{
	RandomBodies random(22);
	for (const auto& [n1, n2] : { std::pair(8.0, 8.0), std::pair(20.0, 2.0), std::pair(2.0, 5.0) }) {
		const Shape shape(Vector3(1, 2, 0.5), n1, n2);
		const ReferenceShape reference(shape);
		constexpr int points = 100000;
		int inside = 0;
		double squares = 0; // of x and y
		for (int i = 0; i < points; ++i) {
			const Vector3 x = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).cwiseProduct(shape.halfSizes());
			if (reference.function(x) > 1) continue;
			++inside;
			squares += x.head<2>().squaredNorm();
		}
		const double box = 8 * shape.halfSizes().prod();
		// Five standard deviations of the count, and as much of the sum, whose terms spread less than their largest value.
		const double share = double(inside) / points, tolerance = 5 * std::sqrt(share * (1 - share) / points);
		EXPECT_NEAR(volume(shape) / box, share, tolerance);
		EXPECT_NEAR(inertiaOfUnitDensity(shape).z() / box, squares / points, 5 * tolerance + 5 * 2.5 / std::sqrt(double(points)));
	}
}
