#include "WallContact.hpp"

#include "Curvature.hpp"
#include "Tolerances.hpp"

#include <algorithm>

namespace superquadric {

namespace {
	Status verdict(double overlap) { return overlap > 0 ? Status::Overlap : overlap <= 0 ? Status::Apart : Status::Uncertified; }
} // namespace

Contact contactPlane(const Placement& body, const Vector3& origin, const Vector3& outward)
{
	const Vector3 deepest = body.supportPoint(-outward);
	const double reach = -deepest.dot(outward), distance = (body.position - origin).dot(outward);
	Contact contact;
	contact.normal = -outward;
	contact.lower = contact.upper = distance / reach;
	contact.overlap = reach - distance;
	contact.status = verdict(contact.overlap);
	contact.point = body.position + contact.upper * deepest;
	contact.surface1 = body.position + deepest;
	contact.surface2 = contact.surface1 + contact.overlap * outward;
	contact.curvature1 = meanCurvature(body.shape, body.toBody(deepest));
	return contact;
}

namespace {

	bool insideTriangle(const Vector3& point, const std::array<Vector3, 3>& v, const Vector3& normal)
	{
		for (int i = 0; i < 3; ++i)
			if ((v[(i + 1) % 3] - v[i]).cross(point - v[i]).dot(normal) < 0) return false;
		return true;
	}

	// The point of the segment with the smallest gauge: Newton on its slope, which grows along the segment, kept within a bracket.
	Vector3 lowestOnEdge(const Placement& body, const Vector3& from, const Vector3& to)
	{
		const Vector3 along = to - from, start = from - body.position;
		const auto slope = [&](double t) { return body.gaugeWithGradient(start + t * along).gradient.dot(along); };
		if (slope(0) >= 0) return from;
		if (slope(1) <= 0) return to;
		double low = 0, high = 1, t = 0.5;
		for (int i = 0; i < tolerances::edgeIterations && high - low > tolerances::edgeStep; ++i) {
			const GaugeValue g = body.gaugeWithHessian(start + t * along);
			const double first = g.gradient.dot(along), second = along.dot(g.hessian * along);
			if (first == 0) break;
			(first > 0 ? high : low) = t;
			const double next = second > 0 ? t - first / second : low;
			const double step = next > low && next < high ? next : 0.5 * (low + high);
			if (std::abs(step - t) <= tolerances::edgeStep) break;
			t = step;
		}
		return from + t * along;
	}

	Vector3 lowestOnBoundary(const Placement& body, const std::array<Vector3, 3>& v)
	{
		Vector3 best = v[0];
		for (int i = 0; i < 3; ++i) {
			const Vector3 candidate = lowestOnEdge(body, v[i], v[(i + 1) % 3]);
			if (body.gauge(candidate - body.position) < body.gauge(best - body.position)) best = candidate;
		}
		return best;
	}

	// The contact at a wall's point, by the relations in the header.
	Contact contactAtWallPoint(const Placement& body, const Vector3& wallPoint, double lower)
	{
		const Vector3 fromCentre = wallPoint - body.position;
		const GaugeValue g = body.gaugeWithHessian(fromCentre);
		const double steepness = g.gradient.norm();
		Contact contact;
		contact.point = wallPoint;
		contact.normal = g.gradient / steepness;
		contact.lower = lower;
		contact.upper = g.value;
		contact.overlap = (1 - g.value) / steepness;
		contact.surface1 = body.position + fromCentre / g.value;
		contact.surface2 = contact.surface1 - contact.overlap * contact.normal;
		contact.curvature1 = meanCurvature(g) * g.value;
		return contact;
	}

} // namespace

Contact contactTriangle(const Placement& body, const std::array<Vector3, 3>& v, bool border)
{
	const Vector3 normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
	const bool above = (body.position - v[0]).dot(normal) >= 0;
	const Contact plane = contactPlane(body, v[0], above ? normal : Vector3(-normal));
	if (!plane.overlapping() || insideTriangle(plane.point, v, normal)) return plane;
	if (!border) {
		Contact outside = plane;
		outside.status = Status::Apart;
		outside.overlap = -std::abs(plane.overlap);
		return outside;
	}

	const Vector3 lowest = lowestOnBoundary(body, v);
	const Vector3 gradient = body.gaugeWithGradient(lowest - body.position).gradient;
	// A gradient of the gauge has support 1, so it proves separation from every vertex beyond 1, thus from the triangle.
	double lower = gradient.dot(v[0] - body.position);
	for (const Vector3& vertex : v)
		lower = std::min(lower, gradient.dot(vertex - body.position));
	Contact contact = contactAtWallPoint(body, lowest, lower);
	// Between the two lies what the search along a long edge leaves to rounding; there is no overlap in it.
	contact.status = contact.upper < 1 ? Status::Overlap : lower > 1 ? Status::Apart : Status::Touching;
	return contact;
}

} // namespace superquadric
