#include "NearPairs.hpp"

#include <pkg/detection/PairContact.hpp>

namespace superquadric::bench {

namespace {

	bool apart(const Placement& body1, const Placement& body2)
	{
		WarmStart warm;
		SolverCounters counters;
		return contactPair(body1, body2, warm, counters).status == Status::Apart;
	}

	// Where body 2, moved out along the direction, ceases to touch body 1: t* = 1 there, and t* grows in proportion to the distance.
	double touchingDistance(const Placement& body1, const Placement& body2, const Vector3& direction)
	{
		double inside = 0, outside = 2.1 * body1.shape.boundingRadius();
		for (int halving = 0; halving < 40; ++halving) {
			const double middle = 0.5 * (inside + outside);
			(apart(body1, { body2.shape, middle * direction, body2.rotation }) ? outside : inside) = middle;
		}
		return 0.5 * (inside + outside);
	}

	MovingPair randomPair(const Shape& shape, const ScalingRange& range, testing::RandomBodies& random)
	{
		const Placement body1 { shape, Vector3::Zero(), random.rotation() };
		const Placement turned { shape, Vector3::Zero(), random.rotation() };
		const Vector3 direction = random.direction();
		const double scaling = 1 + (range.touching ? -1 : 1) * random.logarithmic(range.nearest, range.farthest);
		const Vector3 position = scaling * touchingDistance(body1, turned, direction) * direction;
		const double motion = random.logarithmic(smallestMotion, largestMotion);
		const Vector3 moved = position + motion * shape.smallestHalfSize() * random.direction();
		const Matrix3 turn = Eigen::AngleAxisd(motion, random.direction()).toRotationMatrix();
		return { body1, { Placement { shape, position, turned.rotation }, Placement { shape, moved, turn * turned.rotation } } };
	}

} // namespace

std::vector<MovingPair> nearPairs(const Shape& shape, const ScalingRange& range, int count, std::uint64_t seed)
{
	testing::RandomBodies random(seed);
	std::vector<MovingPair> pairs;
	pairs.reserve(count);
	while (int(pairs.size()) < count) {
		const MovingPair pair = randomPair(shape, range, random);
		// The motion may have taken a pair out of the range.
		if (apart(pair.body1, pair.body2[0]) != range.touching && apart(pair.body1, pair.body2[1]) != range.touching) pairs.push_back(pair);
	}
	return pairs;
}

} // namespace superquadric::bench
