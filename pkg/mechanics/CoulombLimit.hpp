#pragma once

#include <pkg/geometry/Types.hpp>

#include <algorithm>
#include <cmath>

namespace superquadric {

// Largest part s in [0, 1] of `added` with |within + s added| <= limit, where |within| <= limit.
inline double partUpTo(double limit, const Vector3& within, const Vector3& added)
{
	const double a = added.squaredNorm(), b = within.dot(added);
	if (a == 0 || (within + added).squaredNorm() <= limit * limit) return 1;
	const double room = std::max(0., limit * limit - within.squaredNorm());
	const double root = std::sqrt(b * b + a * room);
	// Of the two forms of the positive root, the one without cancellation.
	return std::min(1., b > 0 ? room / (b + root) : (root - b) / a);
}

} // namespace superquadric
