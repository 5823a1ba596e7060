#include <pkg/geometry/Tolerances.hpp>
#include "WallCentre.hpp"
#include "WallContact.hpp"

#include <algorithm>
#include <limits>

namespace superquadric {

namespace {

	using Triangle = std::array<Vector3, 3>;

	// The triangle's border, in the body's frame.
	class Border {
	public:
		Border(const Placement& body, const Triangle& vertices, SolverCounters& counters)
		        : body_(body)
		        , counters_(counters)
		{
			for (int i = 0; i < 3; ++i)
				v_[i] = body.toBody(vertices[i] - body.position);
		}

		// The contact where the objective of the centre is smallest, when `beyond` tells on which edges' outer sides the plane's own
		// centre lies: by convexity it is on one of those, if the triangle reaches into the body at all.
		Contact contact(const std::array<bool, 3>& beyond, const Vector3& planeNormal)
		{
			CentredPoint best;
			best.objective = std::numeric_limits<double>::infinity();
			best.depth = 0;
			for (int i = 0; i < 3; ++i) {
				if (!beyond[i]) continue;
				const CentredPoint centre = centreOnEdge(i);
				if (centre.within() && centre.objective < best.objective) best = centre;
			}
			if (!best.within()) return outside();
			// In the body's own centre the gauge has no gradient; the plane's normal will do.
			return contactAtCentre(body_, best, best.slope.isZero(0) ? planeNormal : Vector3((body_.frame * best.slope).normalized()));
		}

	private:
		Vector3 edge(int i) const { return v_[(i + 1) % 3] - v_[i]; }

		CentredPoint centreOnEdge(int i) const
		{
			const Vector3 &unit = body_.shape.inverseHalfSizes(), from = v_[i].cwiseProduct(unit), along = edge(i).cwiseProduct(unit);
			const CentredPoint onLine = centreOnLine(body_.shape, from + lowestOnEdge(i) * along, along, counters_);
			const double t = (onLine.u - from).dot(along) / along.squaredNorm();
			return t > 0 && t < 1 ? onLine : centreAt(body_.shape, t > 0 ? from + along : from);
		}

		// The place [0, 1] of the edge with the smallest gauge: Newton on the slope, which grows along it, kept within a bracket.
		double lowestOnEdge(int i) const
		{
			const Vector3 &from = v_[i], along = edge(i);
			if (body_.shape.gaugeWithGradient(from).gradient.dot(along) >= 0) return 0;
			if (body_.shape.gaugeWithGradient(from + along).gradient.dot(along) <= 0) return 1;
			double low = 0, high = 1, t = std::clamp(-from.dot(along) / along.squaredNorm(), tolerances::edgeMargin, 1 - tolerances::edgeMargin);
			for (int k = 0; k < tolerances::edgeIterations && high - low > tolerances::edgeStep; ++k) {
				const GaugeValue g = body_.shape.gaugeWithHessian(from + t * along);
				const double first = g.gradient.dot(along), second = along.dot(g.hessian * along);
				if (first == 0) break;
				(first > 0 ? high : low) = t;
				const double next = second > 0 ? t - first / second : low;
				const double step = next > low && next < high ? next : 0.5 * (low + high);
				if (std::abs(step - t) <= tolerances::edgeStep) break;
				t = step;
			}
			return t;
		}

		// No point lies within the body: the plane through the lowest point, across the gauge's gradient there, is the proof.
		Contact outside()
		{
			double lowest = std::numeric_limits<double>::infinity();
			Vector3 point = Vector3::Zero(), direction = Vector3::Zero();
			for (int i = 0; i < 3; ++i) {
				const double t = lowestOnEdge(i);
				const Vector3 candidate = v_[i] + t * edge(i);
				const GaugeValue gauge = body_.shape.gaugeWithGradient(candidate);
				if (!(gauge.value < lowest)) continue;
				lowest = gauge.value;
				point = candidate;
				direction = gauge.gradient;
				// Across a long edge the gradient stands only as well as the place on it is known.
				if (t > 0 && t < 1) direction -= edge(i) * (direction.dot(edge(i)) / edge(i).squaredNorm());
			}
			Contact contact;
			contact.upper = lowest;
			contact.lower = std::min({ direction.dot(v_[0]), direction.dot(v_[1]), direction.dot(v_[2]) }) / body_.shape.support(direction);
			contact.normal = body_.toWorld(direction.normalized());
			contact.overlap = (1 - lowest) / direction.norm();
			contact.point = contact.surface2 = body_.position + body_.toWorld(point);
			contact.surface1 = contact.surface2 + contact.overlap * contact.normal;
			contact.status = verdict(contact);
			if (contact.status == Status::Uncertified) ++counters_.uncertified;
			return contact;
		}

		Status verdict(const Contact& contact) const
		{
			if (contact.upper < 1) return Status::Overlap;
			if (contact.lower > 1) return Status::Apart;
			// The body's place is known to the rounding of the way to the farthest vertex.
			const double way = std::max({ v_[0].norm(), v_[1].norm(), v_[2].norm() }) / body_.shape.smallestHalfSize();
			const double rounding = tolerances::touching + tolerances::gaugeRounding * way;
			return contact.upper - 1 <= rounding && 1 - contact.lower <= rounding ? Status::Touching : Status::Uncertified;
		}

		const Placement& body_;
		SolverCounters& counters_;
		Triangle v_;
	};

} // namespace

Contact contactTriangle(const Placement& body, const Triangle& v, WarmStart& warm, SolverCounters& counters)
{
	const Vector3 normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
	const bool above = (body.position - v[0]).dot(normal) >= 0;
	Contact plane = contactPlane(body, v[0], above ? normal : Vector3(-normal), warm, counters);
	if (!plane.overlapping()) return plane;
	std::array<bool, 3> beyond;
	for (int i = 0; i < 3; ++i)
		beyond[i] = (v[(i + 1) % 3] - v[i]).cross(plane.point - v[i]).dot(normal) < 0;
	if (!beyond[0] && !beyond[1] && !beyond[2]) return plane;
	return Border(body, v, counters).contact(beyond, plane.normal);
}

} // namespace superquadric
