// The convex problem behind the contact of two superquadrics: min over x of t(x) = max(g1(x), g2(x)), the common scaling t* at
// which they touch. Its optimality conditions are Wang & Ji's equation (2) with the gauges g in place of F: the same point when the exponents n1
// are equal, the same verdict always.
//
// Where flat faces meet, many points are nearly as deep, and the deepest jumps over the face at the slightest tilt. So of bodies that
// overlap the contact is put at their contact centre,
//   X0 = argmin over t(x) < 1 of  -ln(1 - t(x)) + c q(x),   q = (e1^2 + e2^2)/2,
// with e_i the distance from centre i in half sizes: the deepest point, drawn to the middle of both bodies as far as the depth
// allows. It is convex like t, so X0 is unique and moves smoothly. On the ridge g1 = g2 its conditions are those of t*
// with c (1 - t) grad q added to the gradients. (Of bodies that have half swallowed each other the minimum lies beside the ridge; the
// solver then still takes a point on it, which is no longer unique.) Where surfaces curve, X0 is the deepest point up to the order of the overlap.
#pragma once

#include <pkg/geometry/Placement.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace superquadric {

// Everything the solvers need at one trial point.
struct PairPoint {
	Vector3 x; // from the problem's origin [m]
	BodyPoint at1, at2;
	Vector3 axis; // unit vector along grad g1 - grad g2: the contact normal
	double slope; // |grad g1 - grad g2| [1/m]
	double perSlope; // 1/slope

	double upper() const { return std::max(at1.jet.value, at2.jet.value); }
	// Weight of body 2 in the combination of the gradients that vanishes along the axis; body 1 has the rest.
	double weight() const { return slope > 0 ? std::clamp(at1.gradient.dot(axis) * perSlope, 0.0, 1.0) : 0.5; }
	double scaling() const { return scaling(weight()); }
	double scaling(double weight) const { return (1 - weight) * at1.jet.value + weight * at2.jet.value; }
	// The scaling with the imbalance of the gauges counted by the smaller weight: of unlike bodies the small one's gauge changes fast
	// along a step while its weight is small, and upper() alone would allow only tiny steps.
	double balancedScaling() const
	{
		const double w = weight();
		return scaling(w) + std::min(w, 1 - w) * std::abs(at1.jet.value - at2.jet.value);
	}
	double offCentre() const { return 0.5 * (at1.local.squaredNorm() + at2.local.squaredNorm()); } // q
};

struct NewtonStep {
	Vector3 step; // [m]
	Vector3 local1, local2; // the same in the half sizes of either body
	double length; // before it was limited, relative to the smallest half size
};

// The origin of x is the centre of the smaller body, where a small body's gauge is not blurred by the rounding of a long way.
class PairProblem {
public:
	PairProblem(const Placement& body1, const Placement& body2)
	        : body1_(body1)
	        , body2_(body2)
	        , between_(body2.position - body1.position)
	        , smallest_(std::min(body1.shape.smallestHalfSize(), body2.shape.smallestHalfSize()))
	{
		const bool firstIsSmaller = body1.shape.boundingRadius() <= body2.shape.boundingRadius();
		centre1_ = firstIsSmaller ? Vector3(Vector3::Zero()) : Vector3(-between_);
		centre2_ = firstIsSmaller ? between_ : Vector3(Vector3::Zero());
	}

	const Placement& body1() const { return body1_; }
	const Placement& body2() const { return body2_; }
	const Vector3& between() const { return between_; } // centre 2 minus centre 1 [m]
	bool concentric() const { return between_.cwiseAbs().maxCoeff() <= tolerances::concentric * smallest_; }
	// The two centres seen from the origin [m].
	const Vector3& centre1() const { return centre1_; }
	const Vector3& centre2() const { return centre2_; }

	PairPoint at(const Vector3& x) const;
	// Moves the point by a step so short that the gauges' second derivatives tell what is there.
	void advance(PairPoint& point, const NewtonStep& step) const;
	// The point of the line of centres where the gauges are equal; the centres must not coincide.
	Vector3 balancedStart() const;
	// Lower bound of t* that a direction proves: d.r / (h1(d) + h2(d)).
	double lowerBound(const Vector3& direction) const { return direction.dot(between_) / supports(direction); }
	double supports(const Vector3& direction) const { return body1_.support(direction) + body2_.support(direction); }
	// Newton step towards the contact centre, or outside of the overlap towards t*, with the tangential system regularised, its
	// length limited.
	NewtonStep newtonStep(const PairPoint& from, double regularisation) const;

private:
	static void findAxis(PairPoint& point);
	void limit(NewtonStep& step) const;

	const Placement& body1_;
	const Placement& body2_;
	Vector3 between_, centre1_, centre2_;
	double smallest_;
};

inline void PairProblem::findAxis(PairPoint& point)
{
	point.axis = point.at1.gradient - point.at2.gradient;
	point.slope = point.axis.norm();
	point.perSlope = 1 / point.slope;
	if (point.slope > 0) point.axis *= point.perSlope;
}

inline PairPoint PairProblem::at(const Vector3& x) const
{
	PairPoint point;
	point.x = x;
	point.at1 = body1_.at(x - centre1_);
	point.at2 = body2_.at(x - centre2_);
	findAxis(point);
	return point;
}

inline void PairProblem::advance(PairPoint& point, const NewtonStep& step) const
{
	const auto move = [](BodyPoint& at, const Vector3& local) {
		const Vector3 change = at.jet.hessianTimes(local);
		at.local += local;
		at.jet.value += at.jet.gradient.dot(local) + 0.5 * change.dot(local);
		at.jet.gradient += change;
		return change;
	};
	const Vector3 change1 = body1_.frame * move(point.at1, step.local1), change2 = body2_.frame * move(point.at2, step.local2);
	point.x += step.step;
	point.at1.gradient += change1;
	point.at2.gradient += change2;
	// The axis turns by so little that its length is 1 to second order, and the third does not matter; except near a centre.
	const Vector3 turned = (change1 - change2) * point.perSlope, across = turned - turned.dot(point.axis) * point.axis;
	const double square = across.squaredNorm();
	if (square > tolerances::smallTurn * tolerances::smallTurn) return findAxis(point);
	point.axis = (point.axis + across) * (1 - 0.5 * square);
}

inline Vector3 PairProblem::balancedStart() const
{
	// Both gauges are linear along the line of centres.
	const double g1 = body1_.gauge(between_), g2 = body2_.gauge(between_);
	return centre1_ + between_ * (g2 / (g1 + g2));
}

namespace detail {
	// Two unit vectors across a unit vector (Duff et al., J. Computer Graphics Techniques 6, 1, 2017).
	struct Across {
		Vector3 first, second;

		explicit Across(const Vector3& axis)
		{
			const double sign = std::copysign(1.0, axis.z()), a = -1 / (sign + axis.z()), b = axis.x() * axis.y() * a;
			first = Vector3(1 + sign * axis.x() * axis.x() * a, sign * b, -sign * axis.x());
			second = Vector3(b, sign + axis.y() * axis.y() * a, -axis.y());
		}
	};
} // namespace detail

// With the multiplier eliminated, the conditions split: along the axis the step balances the gauges; across it, it solves a 2 x 2
// system of the weighted Hessians, which is positive semidefinite because the gauges are convex, with the pull's derivatives, which
// make it definite: of kappa = c (1 - t), kappa' = -c grad t, and grad t = -kappa grad q at the solution.
inline NewtonStep PairProblem::newtonStep(const PairPoint& from, double regularisation) const
{
	const detail::Across across(from.axis);
	const BodyPoint &p1 = from.at1, &p2 = from.at2;
	const double pull = tolerances::centring * std::max(0.0, 1 - from.scaling());
	const double balance = (p2.jet.value - p1.jet.value) * from.perSlope;

	const Vector3 a1 = body1_.toHalfSizes(across.first), b1 = body1_.toHalfSizes(across.second), n1 = body1_.toHalfSizes(from.axis);
	const Vector3 a2 = body2_.toHalfSizes(across.first), b2 = body2_.toHalfSizes(across.second), n2 = body2_.toHalfSizes(from.axis);
	// The weight with which the gradients and the pull together vanish along the axis.
	const double w2 = std::clamp((p1.gradient.dot(from.axis) + pull * (p1.local.dot(n1) + p2.local.dot(n2))) * from.perSlope, 0.0, 1.0), w1 = 1 - w2;
	const double offA = p1.local.dot(a1) + p2.local.dot(a2), offB = p1.local.dot(b1) + p2.local.dot(b2); // grad q
	const auto form = [&](const Vector3& u1, const Vector3& v1, const Vector3& u2, const Vector3& v2) {
		return w1 * p1.jet.form(u1, v1) + w2 * p2.jet.form(u2, v2) + pull * (u1.dot(v1) + u2.dot(v2));
	};
	const double restA = p1.gradient.dot(across.first) + pull * offA, restB = p1.gradient.dot(across.second) + pull * offB;
	const double rA = -restA - balance * form(a1, n1, a2, n2), rB = -restB - balance * form(b1, n1, b2, n2);

	const double second = tolerances::centring * pull;
	const double extra = (tolerances::smallestRegularisation + regularisation) * from.slope * from.slope;
	const double mAA = form(a1, a1, a2, a2) + second * offA * offA + extra;
	const double mBB = form(b1, b1, b2, b2) + second * offB * offB + extra;
	const double mAB = form(a1, b1, a2, b2) + second * offA * offB;
	const double determinant = mAA * mBB - mAB * mAB;
	// Where flat faces all but touch and the conditions across the axis are met to rounding, a step across would be made of it.
	const double met = tolerances::normalRounding * from.slope;
	const bool blurred = pull < tolerances::blurredPull && restA * restA + restB * restB <= met * met;
	const double scale = determinant > 0 && !blurred ? 1 / determinant : 0;
	const double a = (rA * mBB - rB * mAB) * scale, b = (rB * mAA - rA * mAB) * scale;

	NewtonStep result;
	result.step = balance * from.axis + a * across.first + b * across.second;
	result.local1 = balance * n1 + a * a1 + b * b1;
	result.local2 = balance * n2 + a * a2 + b * b2;
	result.length = std::sqrt(balance * balance + a * a + b * b) / smallest_;
	if (!(result.length <= tolerances::longestStep)) limit(result);
	return result;
}

inline void PairProblem::limit(NewtonStep& step) const
{
	// Measured by the gauges, so that a long body may be walked along its length.
	const double size = std::max(body1_.shape.jet(step.local1).value, body2_.shape.jet(step.local2).value);
	if (size <= tolerances::longestStep) return;
	const double factor = tolerances::longestStep / size;
	step.step *= factor;
	step.local1 *= factor;
	step.local2 *= factor;
}

} // namespace superquadric
