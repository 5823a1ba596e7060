// Pairs of equal bodies placed as neighbours in a settled bed are: at random orientations, near touching, each in two
// places that differ by what a time step moves them.
#pragma once

#include <pkg/detection/Contact.hpp>
#include <pkg/geometry/Placement.hpp>
#include <tests/support/RandomBodies.hpp>

#include <array>
#include <vector>

namespace superquadric::bench {

// One pair at two moments.
struct MovingPair {
	Placement body1;
	std::array<Placement, 2> body2;
};

// A range of the common scaling t* at which pairs touch: below 1 they overlap by 1 - t*, above they are apart.
struct ScalingRange {
	double nearest, farthest; // |t* - 1|
	bool touching;
};
// What gravity makes of stiff grains: overlaps of 1e-4 to 3e-3 of a size.
constexpr ScalingRange touchingRange { 1e-4, 3e-3, true };
// Neighbours that do not touch, from a grain's roughness to where the boxes of the collider still meet.
constexpr ScalingRange apartRange { 1e-3, 2e-1, false };

// Relative motion between two calls, in sizes, for the displacement and in rad for the rotation.
constexpr double smallestMotion = 1e-6, largestMotion = 1e-4;

// `count` pairs of the shape with t* in the range at both moments; the same seed gives the same pairs.
std::vector<MovingPair> nearPairs(const Shape& shape, const ScalingRange& range, int count, std::uint64_t seed);

} // namespace superquadric::bench
