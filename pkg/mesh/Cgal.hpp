// What the files of this folder use of CGAL. No header of the project includes this one, and the library hides all its symbols (CMakeLists.txt), so
// that a YADE with a CGAL of its own never meets ours.
#pragma once

#include "TriangleMesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace superquadric::cgal {

// Its predicates are exact: what they say of the points as they are in the file is true.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

inline Point pointOf(const Vector3& x) { return { x.x(), x.y(), x.z() }; }

inline std::vector<Point> pointsOf(const TriangleMesh& mesh)
{
	std::vector<Point> points;
	points.reserve(mesh.points.size());
	for (const Vector3& x : mesh.points)
		points.push_back(pointOf(x));
	return points;
}

// Of a mesh whose edges are in order. Points of no triangle are left out: CGAL would look for the triangles round them, past the end of its lists.
inline SurfaceMesh surfaceOf(const TriangleMesh& mesh)
{
	constexpr int unseen = -1;
	std::vector<int> places(mesh.points.size(), unseen);
	TriangleMesh used;
	for (std::array<int, 3> triangle : mesh.triangles) {
		for (int& corner : triangle) {
			int& place = places[std::size_t(corner)];
			if (place == unseen) {
				place = int(used.points.size());
				used.points.push_back(mesh.points[std::size_t(corner)]);
			}
			corner = place;
		}
		used.triangles.push_back(triangle);
	}
	SurfaceMesh surface;
	CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(pointsOf(used), used.triangles, surface);
	return surface;
}

} // namespace superquadric::cgal
