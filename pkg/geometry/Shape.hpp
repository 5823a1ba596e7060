// The superquadric of Wang & Ji, Acta Phys. Sin. 67, 094501 (2018), eq. (1):
//   f(x) = (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1,   surface f = 1, inside f < 1.
// It is worked with through its gauge g = f^(1/n1): convex, homogeneous of degree one, and well scaled at any exponent.
// All points and directions here are in the body's own frame.
#pragma once

#include "Exponent.hpp"
#include "Types.hpp"

namespace superquadric {

// Gauge with its derivatives at one point.
struct GaugeValue {
	double value;
	Vector3 gradient; // [1/m]
	Matrix3 hessian; // [1/m^2]
};

class Shape {
public:
	// Throws std::invalid_argument naming the parameter and its value: half sizes must be finite and positive,
	// exponents within [2, 20].
	Shape(const Vector3& halfSizes, double n1, double n2);

	const Vector3& halfSizes() const { return halfSizes_; }
	double n1() const { return n1_.value(); }
	double n2() const { return n2_.value(); }

	// f of eq. (1).
	double function(const Vector3& x) const;
	Vector3 functionGradient(const Vector3& x) const;
	Matrix3 functionHessian(const Vector3& x) const;

	// g = f^(1/n1): the factor by which the body must be scaled for its surface to pass through x.
	double gauge(const Vector3& x) const;
	// The gradient at the centre, where the gauge has a corner, is given as zero.
	GaugeValue gaugeWithGradient(const Vector3& x) const; // leaves the Hessian unset
	GaugeValue gaugeWithHessian(const Vector3& x) const;

	// h(d) = max over the body of d.x, by the dual exponents n/(n-1).
	double support(const Vector3& direction) const;
	// The surface point where that maximum is reached; direction must not be zero.
	Vector3 supportPoint(const Vector3& direction) const;

	double smallestHalfSize() const { return smallest_; }
	// Radius of the exact bounding sphere about the centre.
	double boundingRadius() const { return boundingRadius_; }

private:
	struct Ratios;
	Ratios ratiosAt(const Vector3& x) const;
	Vector3 gradientOf(const Ratios& r) const;

	Vector3 halfSizes_, inverse_;
	Exponent n1_, n2_;
	double smallest_, boundingRadius_;
};

} // namespace superquadric
