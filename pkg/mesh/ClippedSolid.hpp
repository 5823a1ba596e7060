// A solid from which half spaces are cut. It is kept as a sum of oriented convex polygons whose borders cancel; cutting is done polygon by polygon
// and needs no topology: what the cut opens is covered by triangles from the cut edges to one point of the plane, wherever on it that lies. Where
// such triangles reach beyond the solid they do so twice, with opposite signs. So nothing can fail, whatever is degenerate, and the volume is that of
// the cut solid to rounding: it depends on the coordinates continuously.
#pragma once

#include "TriangleMesh.hpp"

namespace superquadric {

// The points x with normal.x <= offset; the normal is a unit vector.
struct HalfSpace {
	Vector3 normal;
	double offset; // [m]

	double outside(const Vector3& x) const { return normal.dot(x) - offset; }
	// The same as seen from another origin.
	HalfSpace seenFrom(const Vector3& origin) const { return { normal, -outside(origin) }; }
};

class ClippedSolid {
public:
	// Of a closed surface whose triangles face outward, turned about the origin.
	ClippedSolid(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles, const Matrix3& rotation);

	void clip(const HalfSpace& kept);
	bool empty() const { return ends_.empty(); }
	double volume() const; // [m^3]

private:
	void clipPolygon(std::size_t begin, std::size_t end);
	void cover();

	std::vector<Vector3> corners_; // of all polygons, one after the other
	std::vector<std::size_t> ends_; // where the corners of each end

	// While a half space is cut: each corner's distance from it, what is kept, and the edges that the cut makes, from where a polygon's border leaves
	// the half space to where it comes back.
	std::vector<double> outside_;
	std::vector<Vector3> keptCorners_;
	std::vector<std::size_t> keptEnds_;
	std::vector<std::array<Vector3, 2>> cuts_;
};

} // namespace superquadric
