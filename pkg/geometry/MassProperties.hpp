// Volume and principal inertia in closed form (Jaklic, Leonardis & Solina, Segmentation and Recovery of
// Superquadrics, 2000), with e1 = 2/n1 and e2 = 2/n2.
#pragma once

#include "Shape.hpp"

namespace superquadric {

// [m^3]
double volume(const Shape& shape);

// Principal moments about the centre in the body's frame for unit density [m^5]; times the density: [kg m^2].
Vector3 inertiaOfUnitDensity(const Shape& shape);

} // namespace superquadric
