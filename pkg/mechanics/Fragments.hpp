// Into what a particle breaks: numbers, sizes and places of its fragments, for a parent with half sizes 1. The cube mode is that of Zhao & Chi,
// J. Northeastern Univ. Nat. Sci. 44(3), 408 (2023), Z(1) and Z(2) are its equations.
#pragma once

#include "CounterRandom.hpp"
#include <pkg/geometry/Types.hpp>

#include <array>
#include <optional>
#include <vector>

namespace superquadric::fragments {

struct Piece {
	double share; // of the parent's volume, k of Z(1); all of them add up to 1
	Vector3 scale; // half sizes over the parent's
	Vector3 place; // of its centre, along the parent's axes, in its half sizes
};
using Pieces = std::vector<Piece>;

// Volumes of the eight blocks into which three planes through the point `cut` divide the unit cube, Z(1): abc, and so on. Bit 0, 1, 2 of the index is
// set for the upper part along x, y, z.
std::array<double, 8> blockShares(const Vector3& cut);

// Of a superquadric in place: each piece in its block of the parent's box.
Pieces blocks(const Vector3& cut);

// Of a sphere: balls with the volumes of the blocks, r = r0 k^(1/3), Z(2), in the middle of the blocks of a cube that has the sphere's volume.
Pieces ballsOfBlocks(const Vector3& cut);

// Of a sphere: equal balls on a tetrahedron, or on a lattice of 3 x 3 x 3 without its corners and its middle. Either way as close to each other as
// the parent's moment of inertia allows, which the assembly then has. (The paper does not tell where its 4 and 18 balls are, nor how large; neither
// do the works we could read. Of the published conditions, equal balls and conserved mass are met.)
Pieces fourBalls();
Pieces eighteenBalls();

// What no block may fall below: its share, and its sides over those of the whole.
struct Least {
	double share = 0;
	Vector3 sides = Vector3::Zero();

	// Whether any cut keeps to it: if so, the one through the middle does.
	bool possible() const { return share <= 1. / 8 && sides.maxCoeff() <= 0.5; }
};

// Coordinates u^exponent of a cut, drawn anew until no block is less; none if that takes too many trials.
std::optional<Vector3> drawCut(CounterRandom& random, double exponent, const Least& least = {});

} // namespace superquadric::fragments
