#include <pkg/geometry/Curvature.hpp>
#include "Processor.hpp"
#include "WallCentre.hpp"
#include "WallContact.hpp"

namespace superquadric {

namespace {

	// In the body's frame the wall is the plane towards.x = height.
	class PlaneSolver {
	public:
		PlaneSolver(const Placement& body, const Vector3& origin, const Vector3& outward, WarmStart& warm, SolverCounters& counters)
		        : body_(body)
		        , normal_(-outward)
		        , towards_(body.toBody(normal_))
		        , height_((body.position - origin).dot(outward))
		        , warm_(warm)
		        , counters_(counters)
		{
		}

		Contact solve()
		{
			++counters_.solves;
			const double bounding = body_.shape.boundingRadius();
			if (height_ > bounding) {
				++counters_.rejectedBySphere;
				return apart(bounding);
			}
			if (warm_.kind == WarmStart::Point) {
				const CentredPoint centre = centreFrom(warm_.value + (height_ - warm_.value.dot(towards_)) * towards_);
				if (centre.within()) return at(centre);
			}
			return cold();
		}

	private:
		Contact cold()
		{
			const Vector3 deepest = body_.shape.supportPoint(towards_);
			const double reach = deepest.dot(towards_);
			if (height_ >= reach) return apart(reach);
			// The plane's point of smallest gauge lies on the line through the body's own deepest point.
			const CentredPoint centre = centreFrom(height_ / reach * deepest);
			if (!centre.within()) return atSupport(deepest, reach);
			++counters_.coldStarts;
			return at(centre);
		}

		// From a point of the plane, in the body's frame.
		CentredPoint centreFrom(const Vector3& start)
		{
			const Shape& shape = body_.shape;
			return centreOnPlane(shape, start.cwiseProduct(shape.inverseHalfSizes()), towards_.cwiseProduct(shape.halfSizes()), counters_);
		}

		Contact at(const CentredPoint& centre)
		{
			warm_.kind = WarmStart::Point;
			warm_.value = centre.u.cwiseProduct(body_.shape.halfSizes());
			return contactAtCentre(body_, centre, normal_);
		}

		Contact apart(double reach)
		{
			Contact contact;
			contact.status = Status::Apart;
			contact.normal = normal_;
			contact.lower = height_ / reach;
			contact.overlap = reach - height_;
			warm_ = WarmStart();
			return contact;
		}

		// The wall lies within rounding of the body's surface, or beyond the body.
		Contact atSupport(const Vector3& deepest, double reach)
		{
			Contact contact;
			contact.normal = normal_;
			contact.lower = contact.upper = height_ / reach;
			contact.overlap = reach - height_;
			contact.status = contact.overlap > 0 ? Status::Overlap : Status::Uncertified;
			contact.surface1 = body_.position + body_.toWorld(deepest);
			contact.surface2 = contact.point = contact.surface1 - contact.overlap * normal_;
			contact.curvature1 = meanCurvature(body_.shape, deepest);
			warm_ = WarmStart();
			if (contact.status == Status::Uncertified) ++counters_.uncertified;
			return contact;
		}

		const Placement& body_;
		Vector3 normal_, towards_;
		double height_; // of the body's centre over the wall [m]
		WarmStart& warm_;
		SolverCounters& counters_;
	};

} // namespace

SUPERQUADRIC_FOR_EACH_PROCESSOR Contact contactPlane(const Placement& body, const Vector3& origin, const Vector3& outward, WarmStart& warm, SolverCounters& counters)
{
	return PlaneSolver(body, origin, outward, warm, counters).solve();
}

} // namespace superquadric
