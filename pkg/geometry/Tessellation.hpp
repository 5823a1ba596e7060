// Triangles in place of the surface, for views, files and meshes.
//
// The points form a grid, as on a globe: rings at heights c z_k, each the section (a C_j, b S_j) scaled by s_k, where |s|^n1 + |z|^n1 = 1 and
// |C|^n2 + |S|^n2 = 1 put all of them on the surface. Two neighbours on one ring and the two below them lie in one plane, because
// their chords are parallel; and the solid they bound is { |x, y|_Q <= s(z) }, with the convex polygon Q of the section for a norm and the concave
// polygon s of the profile. So the tessellation is convex: the convex hull of its points.
#pragma once

#include "Shape.hpp"

#include <array>
#include <vector>

namespace superquadric {

struct Tessellation {
	std::vector<Vector3> points; // on the surface [m]
	std::vector<Vector3> normals; // of the surface, at the points: outward unit vectors
	std::vector<std::array<int, 3>> triangles; // indices of points, counterclockwise seen from outside; closed
	double error; // upper bound of the largest (Hausdorff) distance between the surface and the triangles [m]
};

// A tessellation with `error` at most the one given [m], of about as few points as that takes. The coarsest there is is an octahedron.
// Throws std::invalid_argument when `error` is not finite and positive, or takes more than tolerances::tessellationPoints.
Tessellation tessellate(const Shape& shape, double error);

} // namespace superquadric
