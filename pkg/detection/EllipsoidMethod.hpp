// The fallback: the ellipsoid method with deep cuts (Bland, Goldfarb & Todd, Oper. Res. 29, 1039, 1981). It needs
// convexity only, shrinks its volume by a proven factor per step, and so always finishes.
#pragma once

#include "PairProblem.hpp"

namespace superquadric {

struct ScalingBounds {
	Vector3 x; // best point found, from the problem's origin [m]
	double lower, upper; // of t*
};

ScalingBounds minimiseScaling(const PairProblem& problem);

// The contact centre (PairProblem.hpp) of bodies that overlap, from the point of least scaling: bounds.upper < 1.
Vector3 contactCentre(const PairProblem& problem, const ScalingBounds& bounds);

} // namespace superquadric
