// How much of each body lies in a region, with bounds. The tessellation T of a body S is convex and has its corners on S, so it lies in S; and their
// volumes are known. So for any region R
//   |T in R| <= |S in R| <= |T in R| + |S| - |T|,
// and |T in R| |S|/|T| lies between the two.
#pragma once

#include "Region.hpp"

namespace superquadric {

struct SolidVolume {
	double low, estimate, high; // [m^3]
};

// Of each body. Bodies wholly inside count with their closed form and are not tessellated; the others are within `accuracy` of their smallest half
// size. Bounds are bounds up to the rounding of the sums, some 1e-14 of a body's volume.
std::vector<SolidVolume> volumesWithin(const std::vector<Placement>& bodies, const Region& region, double accuracy);

} // namespace superquadric
