// A superquadric (body 1) against rigid walls (body 2): plane, triangle and the inside of a cylinder.
#pragma once

#include "Contact.hpp"
#include "Placement.hpp"

#include <array>

namespace superquadric {

// Walls do not yield, so the overlap is measured to the body's support point across the wall's surface: where the gauge of the
// wall's point X0 is g with gradient G, the normal is G/|G|, the overlap (1 - g)/|G| and the surface point centre + (X0 - centre)/g.
// `lower` and `upper` bound g.

// Half space behind the plane through `origin`; `outward` is its unit normal on the free side. Closed form.
Contact contactPlane(const Placement& body, const Vector3& origin, const Vector3& outward);

// A triangle as a two-sided sheet without thickness: it pushes towards the side on which the body's centre is. X0 is the
// triangle's point with the smallest gauge: inside it the plane's closed form, else by a convex search along the edges.
// The vertices must not lie on a line. A triangle of a mesh knows nothing of its neighbours: under a flat face each one pushes by its
// border. With `border` false only its inside pushes, and Apart then means no more than that X0 is not inside.
Contact contactTriangle(const Placement& body, const std::array<Vector3, 3>& vertices, bool border = true);

// The inside of a cylinder of the given radius about the line through `origin` along the unit vector `axis`, without end. The
// contact is at the body's farthest point from the axis, where the normals agree as in eq. (4). The normal is radial, outwards;
// `lower` and `upper` bound the ratio of the wall's radius to that distance, over the directions in which the body's
// bounding sphere reaches the wall.
Contact contactHollowCylinder(const Placement& body, const Vector3& origin, const Vector3& axis, double radius);

} // namespace superquadric
