// The verdict of contactPair on random pairs within 5 % of touching, a third of them aligned on purpose, against an independent oracle
// (CommonScaling.hpp: dual problem, long double, bounds on both sides).
//
// Errors: the oracle's own is half the width of its interval, asserted below 1e-12; where the true t* is nearer to 1 than that plus
// `rounding` (of the doubles that place the bodies) no verdict is called wrong. Touching is right only within tolerances::touching.
// Beside the oracle, which needs a correct search, each certificate is checked by one evaluation of eq. (1) or of the supports, which
// needs none. Each pair is asked at 1e-6, 1e-3, 1 and 10 m, cold, then again warm.
//
// SUPERQUADRIC_ORACLE_PAIRS sets the number of pairs (10,000 if unset).
#include "CommonScaling.hpp"

#include <tests/unit/RandomBodies.hpp>

#include <pkg/geometry/PairContact.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr double rounding = 2e-14;
constexpr double oracleError = 1e-12;

int pairsWanted()
{
	const char* text = std::getenv("SUPERQUADRIC_ORACLE_PAIRS");
	return text ? std::max(1, std::atoi(text)) : 10000;
}

// Two bodies of unit order; `along` is the direction of the centres, not yet their distance.
struct Pair {
	Vector3 sizes1, sizes2;
	double n11, n12, n21, n22; // n1 and n2 of body 1, then of body 2
	Matrix3 rotation1, rotation2;
	Vector3 along;
	const char* kind;
};

Matrix3 turn(double angle, const Vector3& axis) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

class RandomPairs {
public:
	explicit RandomPairs(std::uint64_t seed) : random_(seed) { }

	Pair next()
	{
		Pair pair;
		pair.sizes1 = random_.halfSizes();
		pair.sizes2 = random_.halfSizes(random_.logarithmic(0.01, 1));
		const bool blocks = random_.index(3) == 0;
		for (double* n : { &pair.n11, &pair.n12, &pair.n21, &pair.n22 })
			*n = blocks ? random_.uniform(8, 20) : random_.exponent();
		pair.rotation1 = random_.rotation();
		pair.rotation2 = random_.rotation();
		pair.along = random_.direction();
		pair.kind = "random";
		if (random_.index(3) == 0) align(pair);
		if (random_.index(2)) {
			std::swap(pair.sizes1, pair.sizes2);
			std::swap(pair.n11, pair.n21);
			std::swap(pair.n12, pair.n22);
			std::swap(pair.rotation1, pair.rotation2);
		}
		return pair;
	}

	// Within 5 % of touching; every fourth one by orders of magnitude closer.
	double scaling()
	{
		const double distance = random_.index(4) ? random_.uniform(0, 0.05) : random_.logarithmic(1e-13, 0.05);
		return random_.index(2) ? 1 + distance : 1 - distance;
	}

	Vector3 place() { return random_.uniform(0, 3) * random_.direction(); }
	RandomBodies& random() { return random_; }

private:
	void align(Pair& pair)
	{
		const Matrix3 frame = random_.index(2) ? Matrix3(Matrix3::Identity()) : random_.rotation();
		const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
		pair.rotation1 = frame;
		pair.along = frame.col(random_.index(3));
		switch (random_.index(4)) {
			case 0: // a face on a face, turned in quarters, half of them aside
				pair.kind = "face on face";
				pair.rotation2 = frame * turn(random_.index(4) * pi / 2, random_.index(2) ? x : z);
				if (random_.index(2)) pair.along += 0.5 * random_.direction();
				break;
			case 1: // an edge on an edge, crossed or parallel
				pair.kind = "edge on edge";
				pair.rotation1 = frame * turn(std::atan2(pair.sizes1.y(), pair.sizes1.z()), x);
				pair.rotation2 = random_.index(2) ? Matrix3(frame * turn(std::atan2(pair.sizes2.y(), pair.sizes2.z()), x))
				                                 : Matrix3(frame * turn(-std::atan2(pair.sizes2.x(), pair.sizes2.z()), y));
				pair.along = frame.col(2);
				break;
			case 2: // a corner on a face
				pair.kind = "corner on face";
				pair.rotation2 = frame * Eigen::Quaterniond::FromTwoVectors(pair.sizes2, -z).toRotationMatrix();
				pair.along = frame.col(2);
				break;
			default: // a body and its copy, along an axis or from corner to corner
				pair.kind = "symmetric";
				pair.sizes2 = pair.sizes1;
				pair.n21 = pair.n11;
				pair.n22 = pair.n12;
				pair.rotation2 = frame;
				if (random_.index(2)) pair.along = frame * pair.sizes1.normalized();
		}
	}

	RandomBodies random_;
};

double valueOfEquationOne(const Placement& body, const Vector3& x)
{
	return double(ReferenceShape(body.shape).function(body.toBody(x - body.position)));
}

// One evaluation, no search: the point inside both bodies, or the plane between them.
void expectProved(const Contact& contact, const Placement& body1, const Placement& body2)
{
	if (contact.status == Status::Overlap) {
		// The point is a double of world coordinates, so it may be off by their rounding.
		for (const Placement* body : { &body1, &body2 }) {
			const double blur = 1e-15 * (1 + contact.point.norm() / body->shape.smallestHalfSize());
			EXPECT_LT(valueOfEquationOne(*body, contact.point), 1 + body->shape.n1() * blur);
		}
	}
	if (contact.status == Status::Apart) {
		const CommonScaling sum(body1, body2);
		const Vector3 between = body2.position - body1.position;
		EXPECT_GT(between.cast<Real>().dot(contact.normal.cast<Real>()), sum.heightAlong(contact.normal.cast<Real>()) * (1 - rounding));
	}
}

void expectRight(const Contact& contact, double t, double error)
{
	ASSERT_NE(contact.status, Status::Uncertified);
	if (contact.status == Status::Touching) { EXPECT_LE(std::abs(t - 1), tolerances::touching + error); }
	if (contact.status == Status::Overlap) { EXPECT_LT(t, 1 + error); }
	if (contact.status == Status::Apart) { EXPECT_GT(t, 1 - error); }
	EXPECT_LE(contact.lower, t * (1 + error));
	if (contact.status == Status::Apart) return;
	EXPECT_GE(contact.upper, t * (1 - error));
}

} // namespace

TEST(PairVerdict, AgreesWithTheOracleAndIsProved)
{
	RandomPairs pairs(61);
	SolverCounters counters;
	double worstError = 0;
	int overlaps = 0, aparts = 0;
	const int wanted = pairsWanted();
	for (int i = 0; i < wanted; ++i) {
		const Pair pair = pairs.next();
		const Shape unit1(pair.sizes1, pair.n11, pair.n12), unit2(pair.sizes2, pair.n21, pair.n22);
		const ScalingInterval reference
		        = commonScaling(Placement { unit1, Vector3::Zero(), pair.rotation1 }, Placement { unit2, pair.along, pair.rotation2 });
		const double width = double(reference.halfWidth() / reference.middle());
		ASSERT_LT(width, oracleError) << "pair " << i << ", " << pair.kind;
		worstError = std::max(worstError, width);

		const double t = pairs.scaling(), error = width + rounding;
		const Vector3 between = pair.along * double(t / reference.middle()), place = pairs.place();
		for (double size : { 1e-6, 1e-3, 1.0, 10.0 }) {
			SCOPED_TRACE(std::string(pair.kind) + " pair " + std::to_string(i) + " at size " + std::to_string(size) + ", t* - 1 = " + std::to_string(t - 1));
			const Shape shape1(size * pair.sizes1, pair.n11, pair.n12), shape2(size * pair.sizes2, pair.n21, pair.n22);
			const Placement body1 { shape1, size * place, pair.rotation1 }, body2 { shape2, size * (place + between), pair.rotation2 };
			// The centres' distance is a difference of rounded doubles.
			const double blurred = error + 1e-15 * (place.norm() + between.norm()) / between.norm();
			WarmStart warm;
			for (int repeat = 0; repeat < 2; ++repeat) {
				const Contact contact = contactPair(body1, body2, warm, counters);
				expectRight(contact, t, blurred);
				expectProved(contact, body1, body2);
				overlaps += contact.status == Status::Overlap;
				aparts += contact.status == Status::Apart;
			}
		}
		if (::testing::Test::HasFailure()) return; // one pair is enough to study
	}
	EXPECT_EQ(counters.uncertified, 0u);
	EXPECT_GT(overlaps, 2 * wanted);
	EXPECT_GT(aparts, 2 * wanted);
	RecordProperty("oracleError", std::to_string(worstError * 1e15) + "e-15");
	RecordProperty("fallbacks", std::to_string(counters.fallbacks));
}
