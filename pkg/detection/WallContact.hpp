// A superquadric (body 1) against rigid walls (body 2): plane, triangle and the inside of a cylinder.
#pragma once

#include "Contact.hpp"
#include <pkg/geometry/Placement.hpp>

#include <array>

namespace superquadric {

// Walls do not yield: the contact's point and its second surface point are X0 on the wall, the overlap is the distance from there to
// the body's surface against the wall. All three remember X0 (in the body's frame) in the warm start, and count what they do.

// Half space behind the plane through `origin`; `outward` is its unit normal on the free side. The verdict is the support
// function's, closed form, or a point of the wall in the body; X0 is the contact centre (WallCentre.hpp). `lower` and `upper` bound the
// smallest gauge on the plane.
Contact contactPlane(const Placement& body, const Vector3& origin, const Vector3& outward, WarmStart& warm, SolverCounters& counters);

// A triangle as a two-sided sheet without thickness: it pushes towards the side on which the body's centre is. X0 is the minimiser of
// the same objective on the triangle: inside it the plane's. On its border the normal is the objective's gradient, which turns on
// from the plane's without a jump. The vertices must not lie on a line. What of it counts on a
// mesh is told by FacetMesh.hpp.
Contact contactTriangle(const Placement& body, const std::array<Vector3, 3>& vertices, WarmStart& warm, SolverCounters& counters);

// The inside of a cylinder of the given radius about the line through `origin` along the unit vector `axis`, without end. The
// contact is at the body's farthest point from the axis, where the normals agree as in Wang & Ji's equation (4). The normal is radial, outwards;
// `lower` and `upper` bound the ratio of the wall's radius to that distance, over the directions in which the body's
// bounding sphere reaches the wall.
Contact contactHollowCylinder(
        const Placement& body, const Vector3& origin, const Vector3& axis, double radius, WarmStart& warm, SolverCounters& counters);

} // namespace superquadric
