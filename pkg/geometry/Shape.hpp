// The superquadric of Wang & Ji, Acta Phys. Sin. 67, 094501 (2018), eq. (1):
//   f(x) = (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1,   surface f = 1, inside f < 1.
// It is worked with through its gauge g = f^(1/n1): convex, homogeneous of degree one, and well scaled at any exponent.
// All points and directions here are in the body's own frame.
#pragma once

#include "Exponent.hpp"
#include "GaugeJet.hpp"

#include <algorithm>

namespace superquadric {

// Gauge with its derivatives at one point.
struct GaugeValue {
	double value;
	Vector3 gradient; // [1/m]
	Matrix3 hessian; // [1/m^2]
};

class Shape {
public:
	// Throws std::invalid_argument naming the parameter and its value: half sizes must lie within [1e-30, 1e30] m,
	// exponents within [2, 20].
	Shape(const Vector3& halfSizes, double n1, double n2);

	const Vector3& halfSizes() const { return halfSizes_; }
	// 1/a, 1/b, 1/c [1/m]
	const Vector3& inverseHalfSizes() const { return inverse_; }
	double n1() const { return n1_.value(); }
	double n2() const { return n2_.value(); }

	// The same for equal shapes, different for others for all practical purposes.
	long fingerprint() const { return fingerprint_; }
	bool operator==(const Shape& other) const { return halfSizes_ == other.halfSizes_ && n1() == other.n1() && n2() == other.n2(); }

	// The shape function f.
	double function(const Vector3& x) const;
	Vector3 functionGradient(const Vector3& x) const;
	Matrix3 functionHessian(const Vector3& x) const;

	// g = f^(1/n1): the factor by which the body must be scaled for its surface to pass through x.
	double gauge(const Vector3& x) const;
	// The gradient at the centre, where the gauge has a corner, is given as zero.
	GaugeValue gaugeWithGradient(const Vector3& x) const; // leaves the Hessian unset
	GaugeValue gaugeWithHessian(const Vector3& x) const;
	// The same where the time goes, at y = (x/a, y/b, z/c).
	GaugeJet jet(const Vector3& y) const;

	// h(d) = max over the body of d.x, by the dual exponents n/(n-1).
	double support(const Vector3& direction) const;
	// The surface point where that maximum is reached; direction must not be zero.
	Vector3 supportPoint(const Vector3& direction) const;

	double smallestHalfSize() const { return smallest_; }
	// Radius of the exact bounding sphere about the centre.
	double boundingRadius() const { return boundingRadius_; }

private:
	GaugeJet jetOf(const Vector3& unit, double scale) const { return n1() == n2() ? jetOfEqualExponents(unit, scale) : jetOfNestedNorms(unit, scale); }
	GaugeJet jetOfEqualExponents(const Vector3& unit, double scale) const;
	GaugeJet jetOfNestedNorms(const Vector3& unit, double scale) const;

	Vector3 halfSizes_, inverse_;
	Exponent n1_, n2_, side_; // side_: n1/n2 - 1, of the inner sum's power in the derivatives of f
	double smallest_, boundingRadius_;
	long fingerprint_;
};

inline GaugeJet Shape::jet(const Vector3& y) const
{
	const Vector3 size = y.cwiseAbs();
	const double scale = std::max(std::max(size.x(), size.y()), size.z());
	if (scale == 0) return { 0, Vector3::Zero(), 0, 0, 0, 0, 0 };
	// Relative to the largest coordinate no power overflows. Near the surface, where most questions are asked, none does anyway.
	const bool near = scale > 1 / tolerances::nearSurface && scale < tolerances::nearSurface;
	GaugeJet result = near ? jetOf(size, 1) : jetOf(size * (1 / scale), scale);
	for (int axis = 0; axis < 3; ++axis)
		result.gradient[axis] = std::copysign(result.gradient[axis], y[axis]);
	result.h12 = (y.x() < 0) != (y.y() < 0) ? -result.h12 : result.h12;
	return result;
}

// f = x^n + y^n + z^n. With g = f^(1/n): grad g = (g/f) x^(n-1), and the Hessian is (n - 1)(g/f) x^(n-2) on the diagonal less
// (n - 1)/g grad g grad g'.
inline GaugeJet Shape::jetOfEqualExponents(const Vector3& unit, double scale) const
{
	const Vector3 less2(n1_.powerLessTwo(unit.x()), n1_.powerLessTwo(unit.y()), n1_.powerLessTwo(unit.z()));
	const Vector3 less1 = less2.cwiseProduct(unit);
	const double f = less1.dot(unit), g = n1_.root(f), ratio = g / f;
	const double curved = (n1() - 1) / (scale * g), diagonal = curved * g * ratio;
	return { scale * g, ratio * less1, diagonal * less2.x(), 0, diagonal * less2.y(), diagonal * less2.z(), curved };
}

// f = s^n1 + z^n1 with the inner norm s = (x^n2 + y^n2)^(1/n2). Near the z axis x and y are taken relative to the larger of them, `side`,
// so that nothing underflows or is divided by zero; on it the even split between x and y is taken, which any direction may claim.
inline GaugeJet Shape::jetOfNestedNorms(const Vector3& unit, double scale) const
{
	const double larger = std::max(unit.x(), unit.y()), side = larger > tolerances::nearAxis ? 1 : larger;
	const double x = side > 0 ? unit.x() / side : 1, y = side > 0 ? unit.y() / side : 1;
	const double xLess2 = n2_.powerLessTwo(x), yLess2 = n2_.powerLessTwo(y), xLess1 = xLess2 * x, yLess1 = yLess2 * y;
	const double sum = xLess1 * x + yLess1 * y;
	const double inner = n1_.powerLessTwo(side) * side_.power(sum); // side^(n1-2) sum^(n1/n2-1)
	const double zLess2 = n1_.powerLessTwo(unit.z()), zLess1 = zLess2 * unit.z();
	const double f = inner * side * side * sum + zLess1 * unit.z(), g = n1_.root(f), ratio = g / f;
	const double outer = ratio / scale, mixed = outer * inner * (n1() - n2()) / sum, pure = outer * inner * (n2() - 1);
	return { scale * g,
		ratio * Vector3(inner * side * xLess1, inner * side * yLess1, zLess1),
		mixed * xLess1 * xLess1 + pure * xLess2,
		mixed * xLess1 * yLess1,
		mixed * yLess1 * yLess1 + pure * yLess2,
		outer * (n1() - 1) * zLess2,
		(n1() - 1) / (scale * g) };
}

} // namespace superquadric
