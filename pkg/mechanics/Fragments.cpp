#include "Fragments.hpp"

#include <pkg/geometry/Tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace superquadric::fragments {

namespace {

	// Of one of the blocks, by the bits of its index.
	Vector3 sides(const Vector3& cut, int index)
	{
		Vector3 side;
		for (int axis = 0; axis < 3; ++axis)
			side[axis] = index >> axis & 1 ? 1 - cut[axis] : cut[axis];
		return side;
	}

	// Equal balls in these directions, at a common multiple of them: the one with which the second moment per axis of their assembly, r^2/5 + s^2 q,
	// is that of the parent, 1/5. The directions are symmetric enough for that to hold of all axes.
	Pieces equalBalls(const std::vector<Vector3>& directions)
	{
		const double share = 1. / directions.size(), radius = std::cbrt(share);
		double moment = 0;
		for (const Vector3& direction : directions)
			moment += share * direction.squaredNorm() / 3;
		const double stretch = std::sqrt((1 - radius * radius) / (5 * moment));
		Pieces pieces;
		for (const Vector3& direction : directions)
			pieces.push_back({ share, Vector3::Constant(radius), stretch * direction });
		return pieces;
	}
}

std::array<double, 8> blockShares(const Vector3& cut)
{
	std::array<double, 8> shares;
	for (int i = 0; i < 8; ++i)
		shares[i] = sides(cut, i).prod();
	return shares;
}

Pieces blocks(const Vector3& cut)
{
	Pieces pieces;
	for (int i = 0; i < 8; ++i) {
		const Vector3 side = sides(cut, i);
		Vector3 place;
		for (int axis = 0; axis < 3; ++axis)
			place[axis] = i >> axis & 1 ? cut[axis] : cut[axis] - 1;
		pieces.push_back({ side.prod(), side, place });
	}
	return pieces;
}

Pieces ballsOfBlocks(const Vector3& cut)
{
	const double halfSide = std::cbrt(pi / 6); // of the cube with the volume of the unit ball
	Pieces pieces = blocks(cut);
	for (Piece& piece : pieces) {
		piece.scale.setConstant(std::cbrt(piece.share));
		piece.place *= halfSide;
	}
	return pieces;
}

Pieces fourBalls() { return equalBalls({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } }); }

Pieces eighteenBalls()
{
	std::vector<Vector3> sites;
	for (int x = -1; x <= 1; ++x)
		for (int y = -1; y <= 1; ++y)
			for (int z = -1; z <= 1; ++z) {
				const int neighbours = x * x + y * y + z * z;
				if (neighbours == 1 || neighbours == 2) sites.emplace_back(x, y, z);
			}
	return equalBalls(sites);
}

std::optional<Vector3> drawCut(CounterRandom& random, double exponent, const Least& least)
{
	for (int trial = 0; trial < tolerances::cutTrials; ++trial) {
		Vector3 cut;
		for (int axis = 0; axis < 3; ++axis)
			cut[axis] = std::pow(random.uniform(), exponent);
		const auto shares = blockShares(cut);
		const double smallest = *std::min_element(shares.begin(), shares.end());
		const Vector3 thinnest = cut.cwiseMin(Vector3::Ones() - cut);
		if (smallest > 0 && smallest >= least.share && (thinnest.array() >= least.sides.array()).all()) return cut;
	}
	return std::nullopt;
}

} // namespace superquadric::fragments
