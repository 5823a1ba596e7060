// Which facet of a mesh pushes a body. On the mesh as one surface the contact centres are the local minimisers of the objective
// (WallCentre.hpp); a facet's own minimiser on an edge or a corner counts only if no facet that meets it there leads farther down,
// and of several facets that share it the one with the smallest id pushes. So a flat floor pushes as one plane however it is cut into
// triangles, a ridge pushes once, a hollow corner from both sides, a free rim as a single facet does.
#pragma once

#include "Contact.hpp"
#include <pkg/geometry/Placement.hpp>

#include <array>
#include <vector>

namespace superquadric {

struct MeshFacet {
	int id;
	std::array<Vector3, 3> vertices; // world frame [m]
};

// Whether the contact point is so far from the facet's border that the neighbours need not be asked.
bool farFromBorder(const Placement& body, const MeshFacet& facet, const Vector3& point);

// Whether a facet's overlap with the body is its own to push, among the facets that share a vertex with it. Facets near the same point decide
// from the same numbers, so that exactly one of them says yes; nothing of their warm starts enters.
bool pushesAmong(const Placement& body, const MeshFacet& facet, const Contact& contact, const std::vector<MeshFacet>& neighbours, SolverCounters& counters);

} // namespace superquadric
