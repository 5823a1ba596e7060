#include "PairContact.hpp"

#include "Bounds.hpp"
#include "Curvature.hpp"
#include "EllipsoidMethod.hpp"
#include "PairProblem.hpp"
#include "Surface.hpp"
#include "Tolerances.hpp"

#include <algorithm>
#include <array>

namespace superquadric {

namespace {

	class PairSolver {
	public:
		PairSolver(const Placement& body1, const Placement& body2, WarmStart& warm, SolverCounters& counters)
		        : problem_(body1, body2)
		        , warm_(warm)
		        , counters_(counters)
		{
		}

		Contact solve()
		{
			++counters_.solves;
			if (problem_.between().isZero(0)) return concentric();
			if (apartByRememberedDirection() || apartBySpheres() || apartByBoxes()) return contact_;
			const bool cold = warm_.kind != WarmStart::Point;
			if (cold) ++counters_.coldStarts;
			if (newton(cold ? problem_.balancedStart() : problem_.centre1() + problem_.body1().toWorld(warm_.value))) return contact_;
			return fallback();
		}

	private:
		bool apartByRememberedDirection()
		{
			if (warm_.kind != WarmStart::Direction) return false;
			if (!proveApart(problem_.body1().toWorld(warm_.value))) return false;
			++counters_.rejectedByDirection;
			return true;
		}

		bool apartBySpheres()
		{
			const Shape &shape1 = problem_.body1().shape, &shape2 = problem_.body2().shape;
			if (!boundingSpheresApart(shape1, shape2, problem_.between())) return false;
			++counters_.rejectedBySphere;
			const double distance = problem_.between().norm();
			setApart(problem_.between() / distance, distance / (shape1.boundingRadius() + shape2.boundingRadius()));
			return true;
		}

		bool apartByBoxes()
		{
			Vector3 direction;
			if (warm_.kind == WarmStart::Point || !orientedBoxesApart(problem_.body1(), problem_.body2(), problem_.between(), direction)) return false;
			// The boxes hold the bodies, so their axis proves the bodies apart too.
			++counters_.rejectedByBox;
			setApart(direction, std::max(problem_.lowerBound(direction), 1.0));
			return true;
		}

		bool proveApart(const Vector3& direction)
		{
			const double lower = problem_.lowerBound(direction);
			if (!(lower > 1)) return false;
			setApart(direction, lower);
			return true;
		}

		void setApart(const Vector3& direction, double lower)
		{
			contact_.status = Status::Apart;
			contact_.normal = direction.normalized();
			contact_.lower = lower;
			warm_.kind = WarmStart::Direction;
			warm_.value = problem_.body1().toBody(contact_.normal);
		}

		// What a step must lower, one of two: the scaling, or the scaling with a balance of unlike bodies.
		struct Merits {
			double upper, balanced;
		};
		static Merits meritsOf(const PairPoint& point) { return { point.upper(), point.balancedScaling() }; }

		// True when it ended with a verdict, kept in contact_.
		bool newton(const Vector3& start)
		{
			PairPoint point = problem_.at(start);
			// A step is compared with the worst of the last three: eq. (3) balances the gauges to second order only, so a good step may
			// raise the scaling a little.
			std::array<Merits, 3> recent;
			recent.fill(meritsOf(point));
			double regularisation = 0;
			for (int i = 0; i < tolerances::newtonIterations; ++i) {
				if (!(point.slope > 0)) return false;
				if (point.upper() > 1 && proveApart(point.axis)) return true;
				if (problem_.converged(point)) return accept(point);
				++counters_.iterations;
				const PairPoint next = problem_.at(point.x + problem_.newtonStep(point, regularisation));
				const Merits merits = meritsOf(next);
				if (noWorse(merits, recent)) {
					point = next;
					recent[i % 3] = merits;
					regularisation = regularisation > tolerances::firstRegularisation ? regularisation / 10 : 0;
				} else {
					regularisation = std::max(10 * regularisation, tolerances::firstRegularisation);
					if (regularisation > tolerances::largestRegularisation) return false;
				}
			}
			return false;
		}

		static bool noWorse(const Merits& merits, const std::array<Merits, 3>& recent)
		{
			Merits worst = recent[0];
			for (const Merits& m : recent)
				worst = { std::max(worst.upper, m.upper), std::max(worst.balanced, m.balanced) };
			return merits.upper <= worst.upper + tolerances::gaugeRounding || merits.balanced <= worst.balanced + tolerances::gaugeRounding;
		}

		Contact fallback()
		{
			++counters_.fallbacks;
			const ScalingBounds bounds = minimiseScaling(problem_);
			if (newton(bounds.x)) return contact_;
			const PairPoint point = problem_.at(bounds.x);
			for (const Vector3& direction : { point.axis, point.gauge1.gradient, Vector3(-point.gauge2.gradient) })
				if (proveApart(direction)) return contact_;
			if (!accept(point, bounds.lower)) ++counters_.uncertified;
			return contact_;
		}

		// An overlap is proved by the point; what is within rounding of contact is called touching.
		bool accept(const PairPoint& point, double lower = 0)
		{
			contact_.upper = point.upper();
			contact_.lower = lower;
			contact_.status = Status::Overlap;
			if (!(point.upper() < 1)) {
				contact_.lower = std::max(lower, problem_.lowerBound(point.axis));
				const bool close = point.upper() - 1 <= tolerances::touching && 1 - contact_.lower <= tolerances::touching;
				contact_.status = close ? Status::Touching : Status::Uncertified;
			}
			describe(point);
			return contact_.status != Status::Uncertified;
		}

		// Normal, surface points along it, overlap and curvatures: the text below eq. (3).
		void describe(const PairPoint& point)
		{
			const double alpha = distanceToSurface(problem_.body1(), point.x - problem_.centre1(), point.axis, point.gauge1);
			const double beta = -distanceToSurface(problem_.body2(), point.x - problem_.centre2(), -point.axis, point.gauge2);
			contact_.point = problem_.body1().position + (point.x - problem_.centre1());
			contact_.normal = point.axis;
			contact_.overlap = alpha - beta;
			contact_.surface1 = contact_.point + alpha * point.axis;
			contact_.surface2 = contact_.point + beta * point.axis;
			contact_.curvature1 = meanCurvature(point.gauge1) * point.gauge1.value;
			contact_.curvature2 = meanCurvature(point.gauge2) * point.gauge2.value;
			warm_.kind = WarmStart::Point;
			warm_.value = problem_.body1().toBody(point.x - problem_.centre1());
		}

		// No direction is marked when the centres coincide: the first axis of body 1 is taken.
		Contact concentric()
		{
			const Placement &body1 = problem_.body1(), &body2 = problem_.body2();
			const Vector3 axis = body1.rotation.col(0);
			contact_.status = Status::Overlap;
			contact_.point = body1.position;
			contact_.normal = axis;
			contact_.surface1 = body1.position + distanceToSurface(body1, Vector3::Zero(), axis) * axis;
			contact_.surface2 = body2.position - distanceToSurface(body2, Vector3::Zero(), -axis) * axis;
			contact_.overlap = (contact_.surface1 - contact_.surface2).dot(axis);
			contact_.curvature1 = meanCurvature(body1.shape, body1.toBody(contact_.surface1 - body1.position));
			contact_.curvature2 = meanCurvature(body2.shape, body2.toBody(contact_.surface2 - body2.position));
			warm_ = WarmStart();
			return contact_;
		}

		PairProblem problem_;
		WarmStart& warm_;
		SolverCounters& counters_;
		Contact contact_;
	};

} // namespace

Contact contactPair(const Placement& body1, const Placement& body2, WarmStart& warm, SolverCounters& counters)
{
	return PairSolver(body1, body2, warm, counters).solve();
}

} // namespace superquadric
