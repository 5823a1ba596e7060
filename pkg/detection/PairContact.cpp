#include "PairContact.hpp"

#include <pkg/geometry/Bounds.hpp>
#include "EllipsoidMethod.hpp"
#include "PairProblem.hpp"
#include "Processor.hpp"
#include "RayExit.hpp"

#include <algorithm>
#include <array>

namespace superquadric {

namespace {

	class PairSolver {
	public:
		PairSolver(const Placement& body1, const Placement& body2, WarmStart& warm, SolverCounters& counters, Contact& contact)
		        : problem_(body1, body2)
		        , warm_(warm)
		        , counters_(counters)
		        , contact_(contact)
		{
		}

		void solve()
		{
			++counters_.solves;
			if (warm_.kind == WarmStart::Point) {
				carried_ = carriedPoint();
				if (newton(carried_ + problem_.body1().toWorld(warm_.drift))) return;
			}
			if (warm_.kind == WarmStart::Direction && apartByRememberedDirection()) return;
			solveCold();
		}

	private:
		// Half way between where either body has carried the last point.
		Vector3 carriedPoint() const
		{
			const Vector3 with1 = problem_.centre1() + problem_.body1().toWorld(warm_.value);
			const Vector3 with2 = problem_.centre2() + problem_.body2().toWorld(warm_.seenBy2);
			return warm_.inBothFrames ? Vector3(0.5 * (with1 + with2)) : with1;
		}

		__attribute__((noinline)) void solveCold()
		{
			if (problem_.concentric()) return engulfed(problem_.centre1());
			if (apartBySpheres() || apartByBoxes()) return;
			++counters_.coldStarts;
			if (newton(problem_.balancedStart())) return;
			fallback();
		}

		// The sum of the supports is known for the directions in which either body saw it last; the plane follows body 1, and as body 2
		// turns under it, its support changes by its bounding radius times the change at most. Only when that does not suffice is the
		// support computed anew.
		bool apartByRememberedDirection()
		{
			const Placement &body1 = problem_.body1(), &body2 = problem_.body2();
			const Vector3 direction = body1.toWorld(warm_.value);
			const double distance = direction.dot(problem_.between());
			const double turned = (body2.toBody(direction) - warm_.seenBy2).norm();
			const double reach = (warm_.supports + turned * body2.shape.boundingRadius()) * (1 + tolerances::supportRounding);
			if (warm_.inBothFrames && warm_.shapes == shapes() && distance > reach) {
				contact_.status = Status::Apart;
				contact_.normal = direction;
				contact_.lower = distance / reach;
				contact_.overlap = reach - distance;
			} else if (!proveApart(direction))
				return false;
			++counters_.rejectedByDirection;
			return true;
		}

		// Doubled without its sign: a negative number must not be shifted.
		long shapes() const { return problem_.body1().shape.fingerprint() ^ long(2 * static_cast<unsigned long>(problem_.body2().shape.fingerprint())); }

		bool apartBySpheres()
		{
			const Shape &shape1 = problem_.body1().shape, &shape2 = problem_.body2().shape;
			if (!boundingSpheresApart(shape1, shape2, problem_.between())) return false;
			++counters_.rejectedBySphere;
			const double distance = problem_.between().norm(), radii = shape1.boundingRadius() + shape2.boundingRadius();
			setApart(problem_.between() / distance, distance, radii);
			return true;
		}

		bool apartByBoxes()
		{
			Vector3 direction;
			if (warm_.kind == WarmStart::Point || !orientedBoxesApart(problem_.body1(), problem_.body2(), problem_.between(), direction)) return false;
			// The boxes hold the bodies, so their axis proves the bodies apart too.
			++counters_.rejectedByBox;
			const double distance = direction.dot(problem_.between());
			setApart(direction, distance, std::min(problem_.supports(direction), distance));
			return true;
		}

		bool proveApart(const Vector3& direction)
		{
			const double length = direction.norm(), distance = direction.dot(problem_.between()) / length, supports = problem_.supports(direction) / length;
			if (!(distance > supports)) return false;
			setApart(direction / length, distance, supports);
			return true;
		}

		// The bodies' centres are `distance` apart along a unit vector, and their supports along it are no more than `supports`.
		void setApart(const Vector3& direction, double distance, double supports)
		{
			contact_.status = Status::Apart;
			contact_.normal = direction;
			contact_.lower = distance / supports;
			contact_.overlap = supports - distance;
			warm_.kind = WarmStart::Direction;
			warm_.value = problem_.body1().toBody(direction);
			warm_.seenBy2 = problem_.body2().toBody(direction);
			warm_.inBothFrames = true;
			warm_.supports = supports;
			warm_.shapes = shapes();
		}

		// What a step must lower, one of two: the scaling, or the scaling with a balance of unlike bodies. Of bodies that overlap the scaling is
		// that of the contact centre's objective, made to be 1 where t is.
		struct Merits {
			double upper, balanced;
		};
		Merits meritsOf(const PairPoint& point) const
		{
			const double drawn = std::exp(-tolerances::centring * (point.offCentre() - offCentreAtStart_));
			const auto objective = [&](double t) { return t < 1 ? 1 - (1 - t) * drawn : t; };
			return { objective(point.upper()), objective(point.balancedScaling()) };
		}

		// True when it ended with a verdict, kept in contact_.
		bool newton(const Vector3& start)
		{
			PairPoint point = problem_.at(start);
			if (!(point.slope > 0)) return false;
			const NewtonStep step = problem_.newtonStep(point, 0);
			if (isLast(step) && point.upper() < 1) return accept(point, step);
			return iterate(point);
		}

		static bool isLast(const NewtonStep& step) { return step.length <= tolerances::lastStep; }

		bool iterate(PairPoint point)
		{
			offCentreAtStart_ = point.offCentre();
			// A step is compared with the worst of the last three: the conditions balance the gauges to second order only, so a good step may
			// raise the scaling a little.
			std::array<Merits, 3> recent;
			recent.fill(meritsOf(point));
			double regularisation = 0;
			for (int i = 0; i < tolerances::newtonIterations; ++i) {
				if (!(point.slope > 0)) return false;
				if (point.upper() > 1 && proveApart(point.axis)) return true;
				const NewtonStep step = problem_.newtonStep(point, regularisation);
				if (regularisation == 0 && isLast(step)) {
					if (point.upper() < 1) return accept(point, step);
					if (touching(point)) return true;
				}
				++counters_.iterations;
				const PairPoint next = problem_.at(point.x + step.step);
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

		__attribute__((noinline)) void fallback()
		{
			++counters_.fallbacks;
			const ScalingBounds bounds = minimiseScaling(problem_);
			if (newton(bounds.x)) return;
			PairPoint point = problem_.at(bounds.x);
			for (const Vector3& direction : { point.axis, point.at1.gradient, Vector3(-point.at2.gradient) })
				if (proveApart(direction)) return;
			if (point.upper() < 1) {
				const Vector3 centre = contactCentre(problem_, bounds);
				if (newton(centre)) return;
				engulfed(centre);
			} else if (!touching(point, bounds.lower))
				++counters_.uncertified;
		}

		// What is within rounding of contact.
		bool touching(PairPoint& point, double lower = 0)
		{
			lower = std::max(lower, problem_.lowerBound(point.axis));
			if (!(point.upper() - 1 <= tolerances::touching && 1 - lower <= tolerances::touching)) return false;
			accept(point, still());
			contact_.status = Status::Touching;
			contact_.lower = lower;
			return true;
		}

		static NewtonStep still() { return { Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), 0 }; }

		// The contact at the end of a last step: normal, surface points along it, overlap and curvatures (Wang & Ji, the text below their equation (3)).
		bool accept(PairPoint& point, const NewtonStep& last)
		{
			const Placement &body1 = problem_.body1(), &body2 = problem_.body2();
			const double guess1 = firstGuess(body1, point.at1, point.axis), guess2 = firstGuess(body2, point.at2, -point.axis);
			advanceInside(point, last);
			describe(point, guess1, guess2);
			return true;
		}

		// The point is the overlap's proof: where the overlap is as shallow as the step is long, the step must not leave it.
		void advanceInside(PairPoint& point, const NewtonStep& last)
		{
			if (1 - point.upper() > 2 * tolerances::lastStep) return problem_.advance(point, last);
			const PairPoint before = point;
			problem_.advance(point, last);
			if (!(point.upper() < 1)) point = before;
		}

		void describe(const PairPoint& point, double guess1, double guess2)
		{
			const Placement &body1 = problem_.body1(), &body2 = problem_.body2();
			const SurfacePoint surface1 = surfaceAlong(body1, point.at1, point.axis, guess1), surface2 = surfaceAlong(body2, point.at2, -point.axis, guess2);
			const Vector3 from1 = point.x - problem_.centre1();
			contact_.status = Status::Overlap;
			contact_.upper = point.upper();
			contact_.point = body1.position + from1;
			contact_.normal = point.axis;
			contact_.overlap = surface1.distance + surface2.distance;
			contact_.surface1 = contact_.point + surface1.distance * point.axis;
			contact_.surface2 = contact_.point - surface2.distance * point.axis;
			contact_.curvature1 = surface1.curvature;
			contact_.curvature2 = surface2.curvature;
			warm_.drift = warm_.kind == WarmStart::Point ? body1.toBody(point.x - carried_) : Vector3(Vector3::Zero());
			warm_.kind = WarmStart::Point;
			warm_.value = body1.toBody(from1);
			warm_.seenBy2 = body2.toBody(point.x - problem_.centre2());
			warm_.inBothFrames = true;
		}

		// One body has swallowed the other's middle, far beyond what any contact model is for: no common normal is to be had, and the line of
		// centres gives one, or when the centres coincide, the first axis of body 1.
		void engulfed(const Vector3& x)
		{
			const Placement &body1 = problem_.body1(), &body2 = problem_.body2();
			const bool concentric = problem_.concentric();
			PairPoint point = problem_.at(x);
			point.axis = concentric ? Vector3(body1.rotation.col(0)) : Vector3(problem_.between().stableNormalized());
			describe(point, 2 * body1.shape.boundingRadius(), 2 * body2.shape.boundingRadius());
			if (concentric) warm_ = WarmStart();
		}

		PairProblem problem_;
		WarmStart& warm_;
		SolverCounters& counters_;
		Contact& contact_;
		Vector3 carried_ = Vector3::Zero();
		double offCentreAtStart_ = 0;
	};

} // namespace

SUPERQUADRIC_FOR_EACH_PROCESSOR
Contact contactPair(const Placement& body1, const Placement& body2, WarmStart& warm, SolverCounters& counters)
{
	Contact contact;
	PairSolver(body1, body2, warm, counters, contact).solve();
	return contact;
}

} // namespace superquadric
