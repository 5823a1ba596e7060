// Whether a surface can serve as a container or a region.
#pragma once

#include "TriangleMesh.hpp"

#include <string>

namespace superquadric {

// To which side the triangles' normals (right-handed, in the order of the corners) point: out of the enclosed volume, into it, or the surface is not
// closed.
enum class Facing {
	outward,
	inward,
	open,
};

// Throws std::invalid_argument that names all of what is wrong, how often, and where it is first. Numbers must be finite and each triangle have an
// area; each edge joins two triangles that go round it in opposite senses, with `closed` exactly two; the triangles of each corner are one fan; no
// triangle goes through another or touches it elsewhere than in shared edges and corners; and a closed surface bounds a volume, so that its parts
// face one way. What is wrong is decided exactly, without tolerances (CGAL).
Facing checkMesh(const TriangleMesh& mesh, const std::string& name, bool closed);

} // namespace superquadric
