// Mean curvature of a level surface, eq. (10) with the sign that makes it +1/R on a sphere of radius R.
#pragma once

#include "Shape.hpp"

namespace superquadric {

// Of the level surface of the gauge through the point where `gauge` was taken [1/m].
double meanCurvature(const GaugeValue& gauge);

// Of the body's surface on the ray from its centre through `bodyPoint` (not the centre) [1/m].
double meanCurvature(const Shape& shape, const Vector3& bodyPoint);

} // namespace superquadric
