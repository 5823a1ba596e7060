#include "EllipsoidMethod.hpp"

#include "Tolerances.hpp"

#include <algorithm>

namespace superquadric {

namespace {

	struct Ellipsoid {
		Vector3 centre;
		Matrix3 matrix; // { x : (x - centre)' matrix^-1 (x - centre) <= 1 }

		// Keeps the part where gradient.(x - centre) <= -depth * reach, with reach the half width along the gradient.
		void cut(const Vector3& gradient, double reach, double depth)
		{
			constexpr double n = 3;
			const Vector3 b = matrix * gradient / reach;
			centre -= (1 + n * depth) / (n + 1) * b;
			const double shrink = 2 * (1 + n * depth) / ((n + 1) * (1 + depth));
			matrix = (1 - depth * depth) * n * n / (n * n - 1) * (matrix - shrink * b * b.transpose());
		}
	};

	// The ellipsoid around the smaller body's box, scaled so that it holds the solution: there its gauge is t* <= upper.
	Ellipsoid enclosing(const PairProblem& problem, double upper)
	{
		const Placement& body = problem.centre1().isZero(0) ? problem.body1() : problem.body2();
		const Vector3 squares = 3 * upper * upper * body.shape.halfSizes().cwiseAbs2();
		return { Vector3::Zero(), body.rotation * squares.asDiagonal() * body.rotation.transpose() };
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
		const double reach = std::sqrt(active.gradient.dot(ellipsoid.matrix * active.gradient));
		if (!(reach > 0)) break;
		best.lower = std::max(best.lower, active.value - reach);
		const double depth = (active.value - best.upper) / reach;
		if (depth >= 1) break;
		ellipsoid.cut(active.gradient, reach, depth);
	}
	return best;
}

} // namespace superquadric
