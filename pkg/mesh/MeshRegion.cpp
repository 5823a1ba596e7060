// The part of a body that a closed surface encloses. Seen along any direction u, a point is inside when the triangles that lie ahead of it along u,
// counted with the signs of n.u, sum up to 1. So the volume is the sum over the triangles of that of the part of the body before each: what four half
// spaces leave of it, three of them along u through the triangle's edges. This needs neither convexity nor any decision that rounding could get
// wrong: every summand depends on the coordinates continuously, triangles along u count nothing.
#include "Region.hpp"

#include "Cgal.hpp"
#include "MeshCheck.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <pkg/geometry/Bounds.hpp>

#include <algorithm>
#include <numeric>

namespace superquadric {

namespace {

	namespace pmp = CGAL::Polygon_mesh_processing;
	using Primitive = CGAL::AABB_face_graph_triangle_primitive<cgal::SurfaceMesh>;
	using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<cgal::Kernel, Primitive>>;
	using Faces = std::vector<cgal::SurfaceMesh::Face_index>;
	using Triangle = std::array<Vector3, 3>;

	struct Box {
		Vector3 low, high;
	};

	Box boxOf(const Placement& body)
	{
		const Vector3 half = boxHalfExtents(body.shape, body.rotation);
		return { body.position - half, body.position + half };
	}

	cgal::Kernel::Iso_cuboid_3 cuboid(const Box& box) { return { cgal::pointOf(box.low), cgal::pointOf(box.high) }; }

	// The half space beside the edge that holds the triangle's interior, along u; none where the edge lies along u.
	bool besideEdge(const Vector3& from, const Vector3& to, const Vector3& u, double sign, HalfSpace& halfSpace)
	{
		const Vector3 normal = sign * (to - from).cross(u);
		if (normal.isZero(0)) return false;
		halfSpace.normal = normal.normalized();
		halfSpace.offset = halfSpace.normal.dot(from);
		return true;
	}

	// Signed volume of the part of the solid that lies before the triangle along u.
	double volumeBefore(const Triangle& triangle, const Vector3& u, const ClippedSolid& solid, ClippedSolid& work)
	{
		const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
		const double along = normal.dot(u);
		if (along == 0) return 0;
		const double sign = along > 0 ? 1 : -1;
		work = solid;
		for (std::size_t i = 0; i < 3; ++i) {
			HalfSpace halfSpace;
			if (!besideEdge(triangle[i], triangle[(i + 1) % 3], u, sign, halfSpace)) return 0;
			work.clip(halfSpace);
			if (work.empty()) return 0;
		}
		work.clip({ sign * normal, sign * normal.dot(triangle[0]) });
		return sign * work.volume();
	}

	bool reachesBelow(const Triangle& t, int axis, double at) { return std::min({ t[0][axis], t[1][axis], t[2][axis] }) < at; }
	bool reachesAbove(const Triangle& t, int axis, double at) { return std::max({ t[0][axis], t[1][axis], t[2][axis] }) > at; }

	// Signed volume of the part of the solid, which lies in the box, before all the triangles. Where they are many, the solid is halved across u,
	// each half with the triangles that are before it, until they are few or no fewer for the half.
	double volumeBefore(const std::vector<Triangle>& triangles, const Vector3& u, const ClippedSolid& solid, const Box& box)
	{
		constexpr std::size_t few = 4;
		Vector3 widths = box.high - box.low;
		widths -= widths.cwiseProduct(u.cwiseAbs());
		int axis;
		widths.maxCoeff(&axis);
		const double at = (box.low[axis] + box.high[axis]) / 2;
		std::vector<Triangle> below, above;
		std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(below), [&](const Triangle& t) { return reachesBelow(t, axis, at); });
		std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(above), [&](const Triangle& t) { return reachesAbove(t, axis, at); });
		if (triangles.size() <= few || std::max(below.size(), above.size()) == triangles.size()) {
			ClippedSolid work = solid;
			return std::accumulate(triangles.begin(), triangles.end(), 0.0,
			        [&](double sum, const Triangle& triangle) { return sum + volumeBefore(triangle, u, solid, work); });
		}
		ClippedSolid lower = solid, upper = solid;
		lower.clip({ Vector3::Unit(axis), at });
		upper.clip({ -Vector3::Unit(axis), -at });
		Box lowerBox = box, upperBox = box;
		lowerBox.high[axis] = upperBox.low[axis] = at;
		return volumeBefore(below, u, lower, lowerBox) + volumeBefore(above, u, upper, upperBox);
	}

} // namespace

struct MeshRegion::Search {
	cgal::SurfaceMesh surface;
	Tree tree;
	CGAL::Bbox_3 bounds;
	std::unique_ptr<CGAL::Side_of_triangle_mesh<cgal::SurfaceMesh, cgal::Kernel>> side;

	Vector3 point(cgal::SurfaceMesh::Vertex_index vertex) const
	{
		const cgal::Point& p = surface.point(vertex);
		return { p.x(), p.y(), p.z() };
	}

	Triangle corners(cgal::SurfaceMesh::Face_index face) const
	{
		const auto edge = surface.halfedge(face);
		return { point(surface.source(edge)), point(surface.target(edge)), point(surface.target(surface.next(edge))) };
	}

	// The triangles that lie ahead of the box, or in it, along a coordinate axis, up or down.
	Faces ahead(Box box, int axis, bool up) const
	{
		(up ? box.high : box.low)[axis] = up ? bounds.max(axis) : bounds.min(axis);
		Faces faces;
		if (box.low[axis] <= box.high[axis]) tree.all_intersected_primitives(cuboid(box), std::back_inserter(faces));
		return faces;
	}
};

MeshRegion::MeshRegion(const TriangleMesh& mesh, const std::string& name)
        : search_(std::make_unique<Search>())
{
	const Facing facing = checkMesh(mesh, name, /*closed*/ true);
	search_->surface = cgal::surfaceOf(mesh);
	if (facing == Facing::inward) pmp::reverse_face_orientations(search_->surface);
	search_->tree.insert(faces(search_->surface).first, faces(search_->surface).second, search_->surface);
	search_->tree.build();
	search_->bounds = pmp::bbox(search_->surface);
	search_->side = std::make_unique<CGAL::Side_of_triangle_mesh<cgal::SurfaceMesh, cgal::Kernel>>(search_->tree);
}

MeshRegion::~MeshRegion() = default;

double MeshRegion::volume() const { return pmp::volume(search_->surface); }

bool MeshRegion::contains(const Vector3& point) const { return (*search_->side)(cgal::pointOf(point)) != CGAL::ON_UNBOUNDED_SIDE; }

Region::Holds MeshRegion::holds(const Placement& body) const
{
	if (search_->tree.do_intersect(cuboid(boxOf(body)))) return Holds::part;
	return contains(body.position) ? Holds::all : Holds::nothing;
}

double MeshRegion::volumeWithin(const ClippedSolid& solid, const Placement& body) const
{
	// The direction with the fewest triangles ahead: from a body at the border, mostly the way out.
	Faces fewest;
	Vector3 u = Vector3::Zero();
	for (int axis = 0; axis < 3; ++axis)
		for (const bool up : { true, false }) {
			Faces faces = search_->ahead(boxOf(body), axis, up);
			if (u.isZero(0) || faces.size() < fewest.size()) {
				fewest.swap(faces);
				u = (up ? 1 : -1) * Vector3::Unit(axis);
			}
		}
	std::vector<Triangle> triangles;
	for (const auto face : fewest) {
		triangles.push_back(search_->corners(face));
		for (Vector3& corner : triangles.back())
			corner -= body.position;
	}
	const Vector3 half = boxHalfExtents(body.shape, body.rotation);
	return volumeBefore(triangles, u, solid, { -half, half });
}

} // namespace superquadric
