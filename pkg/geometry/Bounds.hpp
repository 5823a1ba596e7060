// Bounding volumes: exact axis-aligned box, and the separating-axis test of the oriented boxes.
#pragma once

#include "Placement.hpp"

namespace superquadric {

// Half extents of the exact axis-aligned box of the rotated body [m], from its support function.
Vector3 boxHalfExtents(const Shape& shape, const Matrix3& rotation);

// Whether the bounding spheres are apart; `between` is centre 2 minus centre 1. False for NaN.
bool boundingSpheresApart(const Shape& shape1, const Shape& shape2, const Vector3& between);

// Separating-axis test of the two oriented bounding boxes (Gottschalk, Lin & Manocha 1996). True when the boxes are
// apart; `direction` is then the unit axis from body 1 to body 2 that proves it. `between` is centre 2 minus centre 1.
bool orientedBoxesApart(const Placement& body1, const Placement& body2, const Vector3& between, Vector3& direction);

} // namespace superquadric
