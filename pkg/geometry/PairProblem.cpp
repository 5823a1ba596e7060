#include "PairProblem.hpp"

#include "Tolerances.hpp"

namespace superquadric {

PairProblem::PairProblem(const Placement& body1, const Placement& body2)
        : body1_(body1)
        , body2_(body2)
        , between_(body2.position - body1.position)
        , smallest_(std::min(body1.shape.smallestHalfSize(), body2.shape.smallestHalfSize()))
{
	const bool firstIsSmaller = body1.shape.boundingRadius() <= body2.shape.boundingRadius();
	centre1_ = firstIsSmaller ? Vector3(Vector3::Zero()) : Vector3(-between_);
	centre2_ = firstIsSmaller ? between_ : Vector3(Vector3::Zero());
}

PairPoint PairProblem::at(const Vector3& x) const
{
	PairPoint p;
	p.x = x;
	p.gauge1 = body1_.gaugeWithHessian(x - centre1_);
	p.gauge2 = body2_.gaugeWithHessian(x - centre2_);
	p.axis = p.gauge1.gradient - p.gauge2.gradient;
	p.slope = p.axis.norm();
	if (p.slope > 0) p.axis /= p.slope;
	p.skew = p.gauge1.gradient - p.gauge1.gradient.dot(p.axis) * p.axis;
	return p;
}

Vector3 PairProblem::balancedStart() const
{
	// Both gauges are linear along the line of centres.
	const double g1 = body1_.gauge(between_), g2 = body2_.gauge(between_);
	return centre1_ + between_ * (g2 / (g1 + g2));
}

double PairProblem::lowerBound(const Vector3& direction) const
{
	return direction.dot(between_) / (body1_.support(direction) + body2_.support(direction));
}

bool PairProblem::converged(const PairPoint& point) const
{
	return std::abs(point.gauge1.value - point.gauge2.value) <= tolerances::gaugeBalance && point.misalignment() <= tolerances::normalAngle;
}

// With the multiplier eliminated, eq. (3) splits: along the axis the step balances the gauges; across it, it solves a 2 x 2
// system of the weighted Hessians, which is positive semidefinite because the gauges are convex.
Vector3 PairProblem::newtonStep(const PairPoint& from, double regularisation) const
{
	const double weight = from.weight();
	const Matrix3 H = (1 - weight) * from.gauge1.hessian + weight * from.gauge2.hessian;
	const Vector3 balance = (from.gauge2.value - from.gauge1.value) / from.slope * from.axis;

	const Vector3 across1 = from.axis.unitOrthogonal(), across2 = from.axis.cross(across1);
	const Vector3 H1 = H * across1, H2 = H * across2, rest = from.skew + H * balance;
	const double extra = (tolerances::smallestRegularisation + regularisation) * from.slope * from.slope;
	const double m11 = across1.dot(H1) + extra, m12 = across1.dot(H2), m22 = across2.dot(H2) + extra;
	const double r1 = -across1.dot(rest), r2 = -across2.dot(rest);
	const double determinant = m11 * m22 - m12 * m12;
	if (!(determinant > 0)) return limited(balance);
	const double y1 = (r1 * m22 - r2 * m12) / determinant, y2 = (r2 * m11 - r1 * m12) / determinant;
	return limited(balance + y1 * across1 + y2 * across2);
}

Vector3 PairProblem::limited(const Vector3& step) const
{
	if (step.norm() <= tolerances::longestStep * smallest_) return step;
	// Measured by the gauges, so that a long body may be walked along its length.
	const double size = std::max(body1_.gauge(step), body2_.gauge(step));
	return size <= tolerances::longestStep ? step : Vector3(step * (tolerances::longestStep / size));
}

} // namespace superquadric
