// Two superquadrics.
#pragma once

#include "Contact.hpp"
#include <pkg/geometry/Placement.hpp>

namespace superquadric {

// Bounding spheres, remembered direction, oriented boxes, Newton's method on the conditions of the contact point (Wang & Ji, equation (2)), and
// a fallback that always finishes.
// Updates the warm start and the counters.
Contact contactPair(const Placement& body1, const Placement& body2, WarmStart& warm, SolverCounters& counters);

} // namespace superquadric
