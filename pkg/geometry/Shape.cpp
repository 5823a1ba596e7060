#include "Shape.hpp"

#include "Tolerances.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace superquadric {

namespace {

	double requireWithin(double low, double high, const char* name, double value)
	{
		if (value >= low && value <= high) return value;
		std::ostringstream message;
		message << name << " must lie within [" << low << ", " << high << "], got " << value;
		throw std::invalid_argument(message.str());
	}

	double requireExponent(const char* name, double value)
	{
		return requireWithin(tolerances::smallestExponent, tolerances::largestExponent, name, value);
	}

	// (p^m + q^m)^(1/m) for p, q >= 0; the maximum when m is infinite.
	double norm(double p, double q, double m)
	{
		const double large = std::max(p, q), small = std::min(p, q);
		if (large == 0 || std::isinf(m)) return large;
		if (m == 2) return std::hypot(p, q);
		return large * std::pow(1 + std::pow(small / large, m), 1 / m);
	}

	// (p^m + q^m)^(1/m) for p, q >= 0 with the dual exponent m = n/(n-1), and its derivatives. With r the smaller over the larger and
	// s = r^(1/(n-1)), r^m is r s: one power and one root make all three.
	struct DualNorm {
		double value, byFirst, bySecond;
	};
	DualNorm dualNorm(double p, double q, const Exponent& n)
	{
		const double large = std::max(p, q), small = std::min(p, q);
		if (large == 0) return { 0, 0, 0 };
		const double ratio = small / large, power = n.value() == 2 || ratio == 0 ? ratio : std::pow(ratio, 1 / (n.value() - 1));
		const double sum = 1 + ratio * power, byLarge = 1 / n.root(sum), bySmall = power * byLarge;
		return { large * sum * byLarge, p >= q ? byLarge : bySmall, p >= q ? bySmall : byLarge };
	}

	// The farthest point from the centre: with X = x^2 ... the squared distance is linear and the shape function a norm with the exponents
	// n/2, so the maximum is the dual norm, of exponents n/(n-2), of the squared half sizes.
	double farthestPoint(const Vector3& h, double n1, double n2)
	{
		const auto halved = [](double n) { return n == 2 ? std::numeric_limits<double>::infinity() : n / (n - 2); };
		const double scale = h.maxCoeff();
		const Vector3 squares = (h / scale).cwiseAbs2();
		return scale * std::sqrt(norm(norm(squares.x(), squares.y(), halved(n2)), squares.z(), halved(n1)));
	}

	// FNV-1a over the bits (Fowler, Noll & Vo), with a shift so that the high bits of a double reach the low ones.
	std::uint64_t fingerprintOf(const std::array<double, 5>& values)
	{
		std::uint64_t result = 14695981039346656037u;
		for (const double value : values) {
			std::uint64_t bits;
			std::memcpy(&bits, &value, sizeof bits);
			result = (result ^ bits) * 1099511628211u;
			result ^= result >> 29;
		}
		return result;
	}

} // namespace

Shape::Shape(const Vector3& halfSizes, double n1, double n2)
        : halfSizes_(halfSizes)
        , n1_(requireExponent("n1", n1))
        , n2_(requireExponent("n2", n2))
        , side_(n1 / n2 - 1)
{
	const char* names[] = { "extents[0]", "extents[1]", "extents[2]" };
	for (int axis = 0; axis < 3; ++axis)
		requireWithin(tolerances::smallestHalfSize, tolerances::largestHalfSize, names[axis], halfSizes[axis]);
	inverse_ = halfSizes.cwiseInverse();
	smallest_ = halfSizes.minCoeff();
	boundingRadius_ = farthestPoint(halfSizes, n1, n2);
	fingerprint_ = long(fingerprintOf({ halfSizes.x(), halfSizes.y(), halfSizes.z(), n1, n2 }));
}

double Shape::gauge(const Vector3& x) const
{
	const Vector3 u = x.cwiseProduct(inverse_).cwiseAbs();
	return n1_.norm(n2_.norm(u.x(), u.y()), u.z());
}

GaugeValue Shape::gaugeWithGradient(const Vector3& x) const
{
	const GaugeJet local = jet(x.cwiseProduct(inverse_));
	GaugeValue result;
	result.value = local.value;
	result.gradient = local.gradient.cwiseProduct(inverse_);
	return result;
}

GaugeValue Shape::gaugeWithHessian(const Vector3& x) const
{
	const GaugeJet local = jet(x.cwiseProduct(inverse_));
	return { local.value, local.gradient.cwiseProduct(inverse_), inverse_.asDiagonal() * local.hessian() * inverse_.asDiagonal() };
}

double Shape::function(const Vector3& x) const { return n1_.power(gauge(x)); }

Vector3 Shape::functionGradient(const Vector3& x) const
{
	const GaugeValue g = gaugeWithGradient(x);
	return n1() * n1_.powerLessTwo(g.value) * g.value * g.gradient;
}

Matrix3 Shape::functionHessian(const Vector3& x) const
{
	const GaugeValue g = gaugeWithHessian(x);
	const double power = n1() * n1_.powerLessTwo(g.value);
	return power * ((n1() - 1) * g.gradient * g.gradient.transpose() + g.value * g.hessian);
}

double Shape::support(const Vector3& direction) const
{
	const Vector3 p = direction.cwiseProduct(halfSizes_).cwiseAbs();
	return dualNorm(dualNorm(p.x(), p.y(), n2_).value, p.z(), n1_).value;
}

Vector3 Shape::supportPoint(const Vector3& direction) const
{
	const Vector3 p = direction.cwiseProduct(halfSizes_).cwiseAbs();
	const DualNorm side = dualNorm(p.x(), p.y(), n2_), whole = dualNorm(side.value, p.z(), n1_);
	if (whole.value == 0) throw std::invalid_argument("direction must not be zero");
	const Vector3 size = halfSizes_.cwiseProduct(Vector3(whole.byFirst * side.byFirst, whole.byFirst * side.bySecond, whole.bySecond));
	return { std::copysign(size.x(), direction.x()), std::copysign(size.y(), direction.y()), std::copysign(size.z(), direction.z()) };
}

} // namespace superquadric
