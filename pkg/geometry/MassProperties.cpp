#include "MassProperties.hpp"

#include <cmath>

namespace superquadric {

namespace {
	// std::lgamma is not safe among threads for the global sign it leaves, which nobody reads. NOLINTNEXTLINE(concurrency-mt-unsafe)
	double beta(double x, double y) { return std::exp(std::lgamma(x) + std::lgamma(y) - std::lgamma(x + y)); }
} // namespace

double volume(const Shape& shape)
{
	const double e1 = 2 / shape.n1(), e2 = 2 / shape.n2();
	return 2 * shape.halfSizes().prod() * e1 * e2 * beta(e1 / 2 + 1, e1) * beta(e2 / 2, e2 / 2);
}

Vector3 inertiaOfUnitDensity(const Shape& shape)
{
	const double e1 = 2 / shape.n1(), e2 = 2 / shape.n2();
	const Vector3 squares = shape.halfSizes().cwiseAbs2();
	const double factor = shape.halfSizes().prod() * e1 * e2 / 2;
	// Second moments of the section and along z: the integrals of x^2/a^2 (or y^2/b^2) and of z^2/c^2 over the body.
	const double section = factor * beta(1.5 * e2, e2 / 2) * beta(e1 / 2, 2 * e1 + 1);
	const double along = factor * 4 * beta(e2 / 2, e2 / 2 + 1) * beta(1.5 * e1, e1 + 1);
	return { squares.y() * section + squares.z() * along, squares.x() * section + squares.z() * along, (squares.x() + squares.y()) * section };
}

} // namespace superquadric
