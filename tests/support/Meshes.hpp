// Closed surfaces for the tests.
#pragma once

#include <pkg/mesh/TriangleMesh.hpp>

#include <cmath>

namespace superquadric::testing {

// The prism over a polygon that is seen whole from the origin, between two heights; it faces outward where the polygon goes round counterclockwise.
inline TriangleMesh prism(const std::vector<Eigen::Vector2d>& polygon, double low, double high)
{
	const int n = int(polygon.size());
	TriangleMesh mesh;
	for (double z : { low, high })
		for (const auto& x : polygon)
			mesh.points.emplace_back(x.x(), x.y(), z);
	mesh.points.emplace_back(0, 0, low);
	mesh.points.emplace_back(0, 0, high);
	for (int i = 0; i < n; ++i) {
		const int k = (i + 1) % n;
		mesh.triangles.insert(mesh.triangles.end(), { { i, k, n + k }, { i, n + k, n + i }, { k, i, 2 * n }, { n + i, n + k, 2 * n + 1 } });
	}
	return mesh;
}

// Points on circles of two radii in turn: a star, a circle where the radii are equal.
inline TriangleMesh star(double outer, double inner, int points, double low, double high)
{
	std::vector<Eigen::Vector2d> polygon;
	for (int i = 0; i < 2 * points; ++i) {
		const double angle = 3.14159265358979323846 * i / points;
		polygon.push_back((i % 2 ? inner : outer) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
	}
	return prism(polygon, low, high);
}

inline TriangleMesh box(const Vector3& low, const Vector3& high)
{
	TriangleMesh mesh;
	for (int i = 0; i < 8; ++i)
		mesh.points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
	mesh.triangles = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 },
		{ 0, 1, 4 }, { 1, 5, 4 }, { 2, 6, 3 }, { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
	return mesh;
}

inline TriangleMesh turned(TriangleMesh mesh)
{
	for (auto& triangle : mesh.triangles)
		std::swap(triangle[1], triangle[2]);
	return mesh;
}

inline TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other)
{
	const int before = int(mesh.points.size());
	mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
	for (const auto& t : other.triangles)
		mesh.triangles.push_back({ t[0] + before, t[1] + before, t[2] + before });
	return mesh;
}

} // namespace superquadric::testing
