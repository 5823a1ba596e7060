#include "MeshCheck.hpp"

#include "Cgal.hpp"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <map>
#include <sstream>
#include <stdexcept>

namespace superquadric {

namespace {

	namespace pmp = CGAL::Polygon_mesh_processing;

	// One kind of defect: what it is, how often it is found, and where first.
	struct Defect {
		const char* what;
		std::size_t number = 0;
		std::vector<Vector3> where;

		explicit Defect(const char* what)
		        : what(what)
		{
		}
		void add(const std::vector<Vector3>& place)
		{
			if (number++ == 0) where = place;
		}
	};

	class Findings {
	public:
		explicit Findings(const std::string& name)
		        : name_(name)
		{
		}
		void note(const Defect& defect)
		{
			if (defect.number == 0) return;
			text_ << (text_.tellp() > 0 ? "; " : "") << defect.number << " " << defect.what;
			const char* separator = ", first at (";
			for (const Vector3& x : defect.where) {
				text_ << separator << x.x() << ", " << x.y() << ", " << x.z() << ")";
				separator = " - (";
			}
		}
		bool any() { return text_.tellp() > 0; }
		void throwIfAny()
		{
			if (any()) throw std::invalid_argument(name_ + ": " + text_.str());
		}

	private:
		const std::string& name_;
		std::ostringstream text_;
	};

	std::vector<Vector3> cornersOf(const TriangleMesh& mesh, std::size_t triangle)
	{
		return { mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2) };
	}

	Defect notFinite(const TriangleMesh& mesh)
	{
		Defect found { "points with coordinates that are not finite" };
		for (const Vector3& x : mesh.points)
			if (!x.allFinite()) found.add({ x });
		return found;
	}

	Defect degenerate(const TriangleMesh& mesh)
	{
		Defect found { "triangles without an area" };
		for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
			if (CGAL::collinear(cgal::pointOf(mesh.corner(i, 0)), cgal::pointOf(mesh.corner(i, 1)), cgal::pointOf(mesh.corner(i, 2))))
				found.add(cornersOf(mesh, i));
		return found;
	}

	// How often the triangles go along an edge from its lower to its higher point, and back.
	struct EdgeUse {
		int forth = 0, back = 0;
	};

	// Returns whether there are no open edges.
	bool checkEdges(const TriangleMesh& mesh, bool closed, Findings& findings)
	{
		std::map<std::array<int, 2>, EdgeUse> edges;
		for (const auto& triangle : mesh.triangles)
			for (std::size_t i = 0; i < 3; ++i) {
				const int from = triangle[i], to = triangle[(i + 1) % 3];
				EdgeUse& use = edges[{ std::min(from, to), std::max(from, to) }];
				++(from < to ? use.forth : use.back);
			}
		Defect open { "edges with one triangle only (the surface is not closed)" }, crowded { "edges shared by more than two triangles" },
		        turned { "edges whose two triangles face opposite ways" };
		for (const auto& [ends, use] : edges) {
			const std::vector<Vector3> place { mesh.points[std::size_t(ends[0])], mesh.points[std::size_t(ends[1])] };
			if (use.forth + use.back > 2) crowded.add(place);
			else if (use.forth == 2 || use.back == 2) turned.add(place);
			else if (use.forth + use.back == 1) open.add(place);
		}
		if (closed) findings.note(open);
		findings.note(crowded);
		findings.note(turned);
		return open.number == 0;
	}

	// Of a surface whose edges are in order: the triangles round a point, each followed over its edge to the next, must be one fan.
	Defect pinched(const TriangleMesh& mesh)
	{
		struct Fans {
			std::map<int, int> next; // from the point before the corner, in the triangle, to the one after
			std::map<int, bool> follows;
		};
		std::vector<Fans> fans(mesh.points.size());
		for (const auto& triangle : mesh.triangles)
			for (std::size_t i = 0; i < 3; ++i) {
				Fans& of = fans[std::size_t(triangle[i])];
				of.next[triangle[(i + 1) % 3]] = triangle[(i + 2) % 3];
				of.follows[triangle[(i + 2) % 3]] = true;
			}
		Defect found { "points where parts of the surface meet in nothing but the point" };
		for (std::size_t point = 0; point < fans.size(); ++point) {
			const Fans& of = fans[point];
			if (of.next.empty()) continue;
			int at = of.next.begin()->first;
			for (const auto& [begin, end] : of.next)
				if (!of.follows.count(begin)) at = begin; // an open fan begins at its border
			std::size_t length = 0;
			for (auto step = of.next.find(at); step != of.next.end() && length < of.next.size(); step = of.next.find(step->second))
				if (++length > 0 && step->second == at) break;
			if (length < of.next.size()) found.add({ mesh.points[point] });
		}
		return found;
	}

	Defect selfIntersections(const TriangleMesh& mesh)
	{
		std::vector<std::pair<std::size_t, std::size_t>> pairs;
		pmp::triangle_soup_self_intersections(cgal::pointsOf(mesh), mesh.triangles, std::back_inserter(pairs));
		Defect found { "pairs of triangles that go through each other" };
		for (const auto& pair : pairs)
			found.add(cornersOf(mesh, pair.first));
		return found;
	}

	Facing facingOf(const TriangleMesh& mesh, Findings& findings)
	{
		const cgal::SurfaceMesh surface = cgal::surfaceOf(mesh);
		Defect unbounded { "closed surface whose parts do not bound a volume together (turn round the inner shells, or the parts that face the other way)" };
		if (!pmp::does_bound_a_volume(surface)) unbounded.add({});
		findings.note(unbounded);
		return pmp::volume(surface) > 0 ? Facing::outward : Facing::inward;
	}

} // namespace

Facing checkMesh(const TriangleMesh& mesh, const std::string& name, bool closed)
{
	if (mesh.triangles.empty()) throw std::invalid_argument(name + ": has no triangles");
	Findings findings(name);
	findings.note(notFinite(mesh));
	findings.throwIfAny();
	findings.note(degenerate(mesh));
	findings.throwIfAny();
	const bool isClosed = checkEdges(mesh, closed, findings);
	if (!findings.any()) findings.note(pinched(mesh));
	findings.note(selfIntersections(mesh));
	findings.throwIfAny();
	if (!isClosed) return Facing::open;
	const Facing facing = facingOf(mesh, findings);
	findings.throwIfAny();
	return facing;
}

} // namespace superquadric
