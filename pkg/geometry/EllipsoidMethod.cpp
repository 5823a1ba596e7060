#include "EllipsoidMethod.hpp"

#include "Tolerances.hpp"

#include <algorithm>

namespace superquadric {

namespace {

	// Kept by its axes rather than by the matrix axes * axes': the solution lies in a narrow valley of the two gauges, where the squared
	// matrix would lose its short axis to rounding, and with it the truth of the bounds.
	struct Ellipsoid {
		Vector3 centre;
		Matrix3 axes; // { centre + axes * u : |u| <= 1 }

		// Keeps the part where gradient.(x - centre) <= -depth * |axes' gradient|.
		void cut(const Vector3& gradient, double depth)
		{
			constexpr double n = 3;
			const Vector3 along = (axes.transpose() * gradient).normalized();
			const Vector3 b = axes * along;
			centre -= (1 + n * depth) / (n + 1) * b;
			const double shrink = 2 * (1 + n * depth) / ((n + 1) * (1 + depth));
			axes = n * std::sqrt((1 - depth * depth) / (n * n - 1)) * (axes - (1 - std::sqrt(1 - shrink)) * b * along.transpose());
		}
	};

	// The ellipsoid around the smaller body's box, scaled so that it holds the solution: there its gauge is t* <= upper.
	Ellipsoid enclosing(const PairProblem& problem, double upper)
	{
		const Placement& body = problem.centre1().isZero(0) ? problem.body1() : problem.body2();
		return { Vector3::Zero(), body.rotation * (std::sqrt(3.0) * upper * body.shape.halfSizes()).asDiagonal() };
	}

} // namespace

ScalingBounds minimiseScaling(const PairProblem& problem)
{
	const Vector3 start = problem.balancedStart();
	ScalingBounds best { start, 0, problem.at(start).upper() };
	Ellipsoid ellipsoid = enclosing(problem, best.upper);
	for (int i = 0; i < tolerances::fallbackIterations && best.upper - best.lower > tolerances::fallbackGap; ++i) {
		const Vector3 x = ellipsoid.centre;
		const GaugeValue g1 = problem.body1().gaugeWithGradient(x - problem.centre1()), g2 = problem.body2().gaugeWithGradient(x - problem.centre2());
		const GaugeValue& active = g1.value > g2.value ? g1 : g2;
		if (active.value < best.upper) {
			best.upper = active.value;
			best.x = x;
		}
		const double reach = (ellipsoid.axes.transpose() * active.gradient).norm();
		if (!(reach > 0)) break;
		best.lower = std::max(best.lower, active.value - reach);
		const double depth = (active.value - best.upper) / reach;
		if (depth >= 1) break;
		ellipsoid.cut(active.gradient, depth);
	}
	return best;
}

} // namespace superquadric
