// The convex problem behind the contact of two superquadrics: min over x of max(g1(x), g2(x)), the common scaling t* at which
// they touch. Its optimality conditions are eq. (2) with the gauges g in place of F: the same point when the exponents n1 are
// equal, the same verdict always.
#pragma once

#include "Placement.hpp"

#include <algorithm>

namespace superquadric {

// Everything the solvers need at one trial point.
struct PairPoint {
	Vector3 x; // from the problem's origin [m]
	GaugeValue gauge1, gauge2;
	Vector3 axis; // unit vector along grad g1 - grad g2: the contact normal, once both gradients lie on it
	double slope; // |grad g1 - grad g2| [1/m]
	Vector3 skew; // part of either gradient across the axis [1/m]; zero at the solution

	double upper() const { return std::max(gauge1.value, gauge2.value); }
	// Weight of body 2 in the combination of the gradients that vanishes at the solution; body 1 has the rest.
	double weight() const { return slope > 0 ? std::clamp(gauge1.gradient.dot(axis) / slope, 0.0, 1.0) : 0.5; }
	// The scaling with the imbalance of the gauges counted by the smaller weight: of unlike bodies the small one's gauge changes fast
	// along a step while its weight is small, and upper() alone would allow only tiny steps.
	double balancedScaling() const
	{
		const double w = weight();
		return (1 - w) * gauge1.value + w * gauge2.value + std::min(w, 1 - w) * std::abs(gauge1.value - gauge2.value);
	}
	// Sine of the larger angle between a normal and the axis.
	double misalignment() const { return skew.norm() / std::sqrt(std::min(gauge1.gradient.squaredNorm(), gauge2.gradient.squaredNorm())); }
};

// The origin of x is the centre of the smaller body, where a small body's gauge is not blurred by the rounding of a long way.
class PairProblem {
public:
	PairProblem(const Placement& body1, const Placement& body2);

	const Placement& body1() const { return body1_; }
	const Placement& body2() const { return body2_; }
	const Vector3& between() const { return between_; } // centre 2 minus centre 1 [m]
	// The two centres seen from the origin [m].
	const Vector3& centre1() const { return centre1_; }
	const Vector3& centre2() const { return centre2_; }

	PairPoint at(const Vector3& x) const;
	// The point of the line of centres where the gauges are equal; the centres must not coincide.
	Vector3 balancedStart() const;
	// Lower bound of t* that a direction proves: d.r / (h1(d) + h2(d)).
	double lowerBound(const Vector3& direction) const;
	// Newton step on eq. (3) from a point, with the tangential system regularised, its length limited.
	Vector3 newtonStep(const PairPoint& from, double regularisation) const;
	bool converged(const PairPoint& point) const;

private:
	Vector3 limited(const Vector3& step) const;

	const Placement& body1_;
	const Placement& body2_;
	Vector3 between_, centre1_, centre2_;
	double smallest_;
};

} // namespace superquadric
