#include "FacetMesh.hpp"

#include <pkg/geometry/Tolerances.hpp>
#include "WallCentre.hpp"
#include "WallContact.hpp"

#include <algorithm>
#include <optional>

namespace superquadric {

namespace {

	using Triangle = std::array<Vector3, 3>;

	// Distances of a point of the triangle's plane from the three edges, positive on the triangle's side.
	Vector3 insideEdges(const Triangle& v, const Vector3& x)
	{
		const Vector3 normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
		Vector3 result;
		for (int i = 0; i < 3; ++i)
			result[i] = normal.cross((v[(i + 1) % 3] - v[i]).normalized()).dot(x - v[i]);
		return result;
	}

	double distanceFromSegment(const Vector3& from, const Vector3& to, const Vector3& x)
	{
		const Vector3 along = to - from;
		const double t = std::clamp((x - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
		return (x - from - t * along).norm();
	}

	double distanceFrom(const Triangle& v, const Vector3& x)
	{
		if (insideEdges(v, x).minCoeff() >= 0) return std::abs((v[1] - v[0]).cross(v[2] - v[0]).normalized().dot(x - v[0]));
		return std::min({ distanceFromSegment(v[0], v[1], x), distanceFromSegment(v[1], v[2], x), distanceFromSegment(v[2], v[0], x) });
	}

	double seamOf(const Placement& body) { return tolerances::seam * body.shape.smallestHalfSize(); }

	// A point of a facet with the objective's slope there, both in the world's frame.
	struct Minimiser {
		Vector3 x, slope;
		double depth;
	};

	Minimiser minimiserAt(const Placement& body, const Vector3& x)
	{
		const CentredPoint centre = centreAt(body.shape, body.toHalfSizes(x - body.position));
		return { x, body.frame * centre.slope, centre.depth };
	}

	// What every facet that looks at this one finds, bit for bit.
	std::optional<Minimiser> minimiserOn(const Placement& body, const MeshFacet& facet, SolverCounters& counters)
	{
		WarmStart cold;
		const Contact contact = contactTriangle(body, facet.vertices, cold, counters);
		if (!contact.overlapping()) return std::nullopt;
		return minimiserAt(body, contact.point);
	}

	// The way into the neighbour from a point that belongs to it, too, leads down far more steeply than rounding could.
	bool clearlyDownInto(const Placement& body, const MeshFacet& neighbour, const Minimiser& own)
	{
		const double steep = tolerances::clearlyDown * tolerances::centring * own.depth / body.shape.boundingRadius();
		return std::any_of(neighbour.vertices.begin(), neighbour.vertices.end(), [&](const Vector3& vertex) {
			const Vector3 way = vertex - own.x;
			return own.slope.dot(way) < -steep * way.norm();
		});
	}

	// One of the facets that meet near a point, with its own centre.
	struct Rival {
		const MeshFacet* facet;
		Minimiser centre;
	};

	// No other rival leads farther down from the facet's centre.
	bool isLowest(const Placement& body, const Rival& one, const std::vector<Rival>& rivals)
	{
		const double seam = seamOf(body);
		return std::none_of(rivals.begin(), rivals.end(), [&](const Rival& other) {
			const Vector3 way = other.centre.x - one.centre.x;
			return way.norm() > seam && one.centre.slope.dot(way) < 0 && distanceFrom(other.facet->vertices, one.centre.x) <= seam;
		});
	}

} // namespace

bool farFromBorder(const Placement& body, const MeshFacet& facet, const Vector3& point)
{
	return insideEdges(facet.vertices, point).minCoeff() > 4 * seamOf(body);
}

bool pushesAmong(const Placement& body, const MeshFacet& facet, const Contact& contact, const std::vector<MeshFacet>& neighbours, SolverCounters& counters)
{
	const Minimiser found = minimiserAt(body, contact.point);
	std::vector<Rival> rivals;
	for (const MeshFacet& neighbour : neighbours) {
		const double distance = distanceFrom(neighbour.vertices, found.x);
		if (distance > 5 * seamOf(body)) continue;
		if (distance <= seamOf(body) && clearlyDownInto(body, neighbour, found)) return false;
		if (const auto centre = minimiserOn(body, neighbour, counters)) rivals.push_back({ &neighbour, *centre });
	}
	if (rivals.empty()) return true;
	const auto own = minimiserOn(body, facet, counters);
	if (!own) return true;
	rivals.push_back({ &facet, *own });
	if (!isLowest(body, rivals.back(), rivals)) return false;
	// All that are lowest at the same place lie within a seam's width of it.
	return std::none_of(rivals.begin(), rivals.end(), [&](const Rival& other) {
		return other.facet->id < facet.id && (other.centre.x - own->x).norm() <= 2 * seamOf(body) && isLowest(body, other, rivals);
	});
}

} // namespace superquadric
