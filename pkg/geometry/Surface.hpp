// The point where a ray leaves a body.
#pragma once

#include "Placement.hpp"

namespace superquadric {

// Distance along the unit vector `direction` from the point at `fromCentre`, in or near the body, to the surface [m]; negative
// when the point lies outside. The gauge must grow along the direction. `gauge` is the body's there, with its gradient.
double distanceToSurface(const Placement& body, const Vector3& fromCentre, const Vector3& direction, const GaugeValue& gauge);
double distanceToSurface(const Placement& body, const Vector3& fromCentre, const Vector3& direction);

} // namespace superquadric
