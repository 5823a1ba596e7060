// A superquadric written straight from eq. (1), in long double and without the gauge: what the tests hold pkg/geometry against.
#pragma once

#include <pkg/geometry/Shape.hpp>

#include <complex>

namespace superquadric::testing {

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;
using RealMatrix = Eigen::Matrix<Real, 3, 3>;

constexpr Real realPi = 3.14159265358979323846264338327950288L;

// Where a function that first grows and then falls is largest, by golden sections down to rounding.
template <class Function> Real largestAt(const Function& function, Real low, Real high)
{
	const Real golden = (std::sqrt(5.0L) - 1) / 2;
	Real left = high - golden * (high - low), right = low + golden * (high - low);
	Real atLeft = function(left), atRight = function(right);
	for (int i = 0; i < 100; ++i) {
		if (atLeft < atRight) {
			low = left, left = right, atLeft = atRight;
			right = low + golden * (high - low);
			atRight = function(right);
		} else {
			high = right, right = left, atRight = atLeft;
			left = high - golden * (high - low);
			atLeft = function(left);
		}
	}
	return (low + high) / 2;
}

class ReferenceShape {
public:
	explicit ReferenceShape(const Shape& shape)
	        : sizes(shape.halfSizes().cast<Real>())
	        , n1(shape.n1())
	        , n2(shape.n2())
	{
	}

	const RealVector sizes;
	const Real n1, n2;

	// Eq. (1), for real or complex coordinates.
	template <class Number> Number function(const Eigen::Matrix<Number, 3, 1>& x) const
	{
		using std::pow;
		const Number u = magnitude(Number(x[0] / sizes[0])), v = magnitude(Number(x[1] / sizes[1])), w = magnitude(Number(x[2] / sizes[2]));
		return pow(pow(u, n2) + pow(v, n2), n1 / n2) + pow(w, n1);
	}
	Real function(const Vector3& x) const { return function(RealVector(x.cast<Real>())); }

	// Exact to rounding: a complex step has no difference to lose digits in.
	RealVector gradient(const RealVector& x) const
	{
		RealVector result;
		for (int axis = 0; axis < 3; ++axis) {
			Eigen::Matrix<std::complex<Real>, 3, 1> moved = x.cast<std::complex<Real>>();
			const Real step = 1e-30L * sizes[axis];
			moved[axis] += std::complex<Real>(0, step);
			result[axis] = function(moved).imag() / step;
		}
		return result;
	}
	RealVector normal(const RealVector& x) const { return gradient(x).normalized(); }

	// The surface by its two angles, eta in [-pi/2, pi/2] from the x-y plane and omega in it.
	RealVector surfacePoint(Real eta, Real omega) const
	{
		const Real side = signedPower(std::cos(eta), 2 / n1);
		return { sizes[0] * side * signedPower(std::cos(omega), 2 / n2),
			sizes[1] * side * signedPower(std::sin(omega), 2 / n2),
			sizes[2] * signedPower(std::sin(eta), 2 / n1) };
	}

	// The surface point where a weighted sum of the |coordinates|^power is largest, searched over the two angles of the octant. Along
	// a section of the surface the sum first grows and then falls, for power 1 and 2 (n >= power makes the section convex).
	RealVector largestPoint(const RealVector& weights, int power) const
	{
		const auto weighed = [&](const RealVector& x) { return weights.dot(power == 1 ? x : RealVector(x.cwiseAbs2())); };
		const Real omega = largestAt([&](Real angle) { return weighed(surfacePoint(0, angle)); }, 0, realPi / 2);
		const Real eta = largestAt([&](Real angle) { return weighed(surfacePoint(angle, omega)); }, 0, realPi / 2);
		return surfacePoint(eta, omega);
	}
	Real searchedSupport(const Vector3& direction) const
	{
		const RealVector weights = direction.cast<Real>().cwiseAbs();
		return weights.dot(largestPoint(weights, 1));
	}

private:
	static Real magnitude(Real x) { return std::abs(x); }
	static std::complex<Real> magnitude(const std::complex<Real>& z) { return z.real() < 0 ? -z : z; }
	static Real signedPower(Real x, Real exponent) { return std::copysign(std::pow(std::abs(x), exponent), x); }
};

} // namespace superquadric::testing
