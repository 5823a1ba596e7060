// The verdict of contactPair on random pairs (RandomPairs.hpp) against an independent oracle (CommonScaling.hpp: dual problem, bounds on
// both sides).
//
// Errors: the oracle's own is half the width of its interval, asserted below `oracleError`; in double it settles every pair farther
// than that from touching, the rest go to long double. Where the true t* is nearer to 1 than the interval plus `rounding` (of the
// doubles that place the bodies) no verdict is called wrong. Touching is right only within tolerances::touching. Beside the oracle,
// which needs a correct search, each certificate is checked by one evaluation of eq. (1) or of the supports, which needs none.
//
// Each pair is asked at 1e-6, 1e-3, 1 and 10 m: cold, then after it has moved away a little, then back in its place, both times warm.
//
// SUPERQUADRIC_ORACLE_PAIRS sets the number of pairs (100,000 if unset), SUPERQUADRIC_ORACLE_FIRST the number of the first one (0): long
// runs can be cut into parts, and a pair that failed repeated alone. SUPERQUADRIC_ORACLE_SEED (61) gives other pairs.
#include "CommonScaling.hpp"
#include "RandomPairs.hpp"

#include <pkg/detection/PairContact.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <cstdlib>
#include <sstream>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr double rounding = 2e-14;
constexpr double oracleError = 1e-13;

// X0 is the deepest point drawn towards the middle: ln(1 - t) may fall by c q, with c = 2 and q at most 3 within both bodies.
const double leastDepth = std::exp(-6.0);

unsigned long setting(const char* name, unsigned long otherwise)
{
	const char* text = std::getenv(name);
	return text ? std::strtoul(text, nullptr, 10) : otherwise;
}

ScalingInterval reference(const RandomPair& pair, const Shape& shape1, const Shape& shape2)
{
	const Placement body1 { shape1, Vector3::Zero(), pair.rotation1 }, body2 { shape2, pair.along, pair.rotation2 };
	if (std::abs(pair.scaling - 1) < oracleError + rounding) return commonScaling<Real>(body1, body2);
	return commonScaling<double>(body1, body2);
}

// One evaluation, no search: the point inside both bodies, or the plane between them.
bool proved(const Contact& contact, const Placement& body1, const Placement& body2)
{
	if (contact.status == Status::Overlap) {
		// The point is a double of world coordinates, so it may be off by their rounding.
		for (const Placement* body : { &body1, &body2 }) {
			const double blur = 1e-15 * (1 + contact.point.norm() / body->shape.smallestHalfSize());
			const Real f = ReferenceShape(body->shape).function(body->toBody(contact.point - body->position));
			if (!(f < 1 + body->shape.n1() * blur)) return false;
		}
	}
	if (contact.status == Status::Apart) {
		const Vector3 between = body2.position - body1.position;
		const double height = CommonScaling<double>(body1, body2).heightAlong(contact.normal);
		return between.dot(contact.normal) > height * (1 - rounding);
	}
	return contact.status != Status::Uncertified;
}

bool right(const Contact& contact, double t, double error)
{
	if (!(contact.lower <= t * (1 + error))) return false;
	switch (contact.status) {
		case Status::Apart: return t > 1 - error && contact.lower > 1;
		case Status::Touching: return std::abs(t - 1) <= tolerances::touching + error && contact.upper >= t * (1 - error);
		case Status::Overlap: return t < 1 + error && contact.upper < 1 && contact.upper >= t * (1 - error) && 1 - contact.upper >= leastDepth * (1 - t) - error;
		default: return false;
	}
}

std::string described(const Contact& contact)
{
	std::ostringstream text;
	text << "status " << int(contact.status) << ", lower - 1 = " << contact.lower - 1 << ", upper - 1 = " << contact.upper - 1;
	return text.str();
}

struct Asked {
	SolverCounters counters;
	unsigned long overlaps = 0, aparts = 0;
	double worstError = 0;

	void ask(RandomPair& pair)
	{
		const Shape unit1(pair.sizes1, pair.n11, pair.n12), unit2(pair.sizes2, pair.n21, pair.n22);
		const ScalingInterval interval = reference(pair, unit1, unit2);
		const double width = double(interval.halfWidth() / interval.middle());
		ASSERT_LT(width, oracleError);
		worstError = std::max(worstError, width);
		const Vector3 between = pair.along * double(pair.scaling / interval.middle());
		// The centres' distance is a difference of rounded doubles.
		const double error = width + rounding + 1e-15 * (pair.place.norm() + between.norm()) / between.norm();
		for (double size : { 1e-6, 1e-3, 1.0, 10.0 })
			askAt(size, pair, between, error);
	}

	void askAt(double size, RandomPair& pair, const Vector3& between, double error)
	{
		const Shape shape1(size * pair.sizes1, pair.n11, pair.n12), shape2(size * pair.sizes2, pair.n21, pair.n22);
		const Placement body1 { shape1, size * pair.place, pair.rotation1 }, body2 { shape2, size * (pair.place + between), pair.rotation2 };
		const double motion = pair.random.logarithmic(1e-6, 1e-2);
		const Vector3 shift = motion * std::min(shape1.smallestHalfSize(), shape2.smallestHalfSize()) * pair.random.direction();
		const Placement moved { shape2, body2.position + shift, turn(motion, pair.random.direction()) * body2.rotation };
		WarmStart warm;
		const Placement* const places[] = { &body2, &moved, &body2 };
		for (const Placement* second : places) {
			const Contact contact = contactPair(body1, *second, warm, counters);
			ASSERT_TRUE(proved(contact, body1, *second)) << "at size " << size << ": " << described(contact);
			if (second == &moved) continue;
			ASSERT_TRUE(right(contact, pair.scaling, error)) << "at size " << size << ": " << described(contact);
			overlaps += contact.status == Status::Overlap;
			aparts += contact.status == Status::Apart;
		}
	}
};

} // namespace

TEST(PairVerdict, AgreesWithTheOracleAndIsProved)
{
	const unsigned long wanted = std::max(1ul, setting("SUPERQUADRIC_ORACLE_PAIRS", 100000)), first = setting("SUPERQUADRIC_ORACLE_FIRST", 0);
	const unsigned long seed = setting("SUPERQUADRIC_ORACLE_SEED", 61);
	Asked asked;
	for (unsigned long i = first; i < first + wanted; ++i) {
		RandomPair pair(seed, i);
		asked.ask(pair);
		// One pair is enough to study.
		ASSERT_FALSE(HasFailure()) << pair.kind << " pair " << i << " of seed " << seed << ", t* - 1 = " << pair.scaling - 1;
	}
	EXPECT_EQ(asked.counters.uncertified, 0u);
	EXPECT_NEAR(double(asked.overlaps) / double(asked.overlaps + asked.aparts), 0.5, 3 / std::sqrt(double(wanted)));
	RecordProperty("oracleError", std::to_string(asked.worstError * 1e15) + "e-15");
	RecordProperty("solves", std::to_string(asked.counters.solves));
	RecordProperty("fallbacks", std::to_string(asked.counters.fallbacks));
}
