// A surface as points and triangles of their numbers: what is read from a file, and what bounds a region.
#pragma once

#include <pkg/geometry/Types.hpp>

#include <array>
#include <vector>

namespace superquadric {

struct TriangleMesh {
	std::vector<Vector3> points; // [m]
	std::vector<std::array<int, 3>> triangles;

	const Vector3& corner(std::size_t triangle, int i) const { return points[std::size_t(triangles[triangle][std::size_t(i)])]; }
};

} // namespace superquadric
