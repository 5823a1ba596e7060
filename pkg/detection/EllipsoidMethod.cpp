#include "EllipsoidMethod.hpp"

#include <pkg/geometry/Tolerances.hpp>

#include <algorithm>
#include <limits>

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

	// The ellipsoid around the smaller body's box, scaled so that it holds all points with a scaling of at most `upper`.
	Ellipsoid enclosing(const PairProblem& problem, double upper)
	{
		const Placement& body = problem.centre1().isZero(0) ? problem.body1() : problem.body2();
		return { Vector3::Zero(), body.rotation * (std::sqrt(3.0) * upper * body.shape.halfSizes()).asDiagonal() };
	}

	// A convex function at one point, with a subgradient; outside of its domain the value is infinite and the subgradient points out of it.
	struct Sample {
		double value;
		Vector3 gradient;
		double depth; // how far the point lies outside of the domain, in the values of the subgradient
	};

	// Cuts the ellipsoid down to where the function may still be lower than at the best point known.
	template <class Function> void minimise(const Function& function, Ellipsoid ellipsoid, double gap, ScalingBounds& best)
	{
		for (int i = 0; i < tolerances::fallbackIterations && best.upper - best.lower > gap; ++i) {
			const Vector3 x = ellipsoid.centre;
			const Sample sample = function(x);
			const double reach = (ellipsoid.axes.transpose() * sample.gradient).norm();
			if (sample.value < best.upper) {
				best.upper = sample.value;
				best.x = x;
			}
			if (!(reach > 0)) break;
			if (std::isfinite(sample.value)) best.lower = std::max(best.lower, sample.value - reach);
			const double depth = (std::isfinite(sample.value) ? sample.value - best.upper : sample.depth) / reach;
			if (depth >= 1) break;
			ellipsoid.cut(sample.gradient, depth);
		}
	}

	struct Gauges {
		BodyPoint at1, at2;

		Gauges(const PairProblem& problem, const Vector3& x)
		        : at1(problem.body1().at(x - problem.centre1()))
		        , at2(problem.body2().at(x - problem.centre2()))
		{
		}
		const BodyPoint& active() const { return at1.jet.value > at2.jet.value ? at1 : at2; }
	};

} // namespace

ScalingBounds minimiseScaling(const PairProblem& problem)
{
	const Vector3 start = problem.balancedStart();
	ScalingBounds best { start, 0, problem.at(start).upper() };
	const auto scaling = [&](const Vector3& x) {
		const Gauges gauges(problem, x);
		return Sample { gauges.active().jet.value, gauges.active().gradient, 0 };
	};
	minimise(scaling, enclosing(problem, best.upper), tolerances::fallbackGap, best);
	return best;
}

Vector3 contactCentre(const PairProblem& problem, const ScalingBounds& bounds)
{
	const auto objective = [&](const Vector3& x) {
		const Gauges gauges(problem, x);
		const double t = gauges.active().jet.value;
		if (!(t < 1)) return Sample { std::numeric_limits<double>::infinity(), gauges.active().gradient, t - 1 };
		const double offCentre = 0.5 * (gauges.at1.local.squaredNorm() + gauges.at2.local.squaredNorm());
		const Vector3 pull = problem.body1().frame * gauges.at1.local + problem.body2().frame * gauges.at2.local;
		return Sample { -std::log(1 - t) + tolerances::centring * offCentre, gauges.active().gradient / (1 - t) + tolerances::centring * pull, 0 };
	};
	ScalingBounds best { bounds.x, -std::numeric_limits<double>::infinity(), objective(bounds.x).value };
	minimise(objective, enclosing(problem, 1), tolerances::centreGap, best);
	return best.x;
}

} // namespace superquadric
