// What a pair remembers: a warm start may save work, never change an answer; and the special places: deep, concentric, face on face.
#include <pkg/detection/PairContact.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

Matrix3 turn(double angle, const Vector3& axis) { return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(); }

// So deep that the bodies have all but swallowed each other, and the contact has many equally good places.
bool isDeep(const Contact& contact, const Shape& shape1, const Shape& shape2)
{
	return contact.overlap > 0.2 * std::min(shape1.smallestHalfSize(), shape2.smallestHalfSize());
}

} // namespace

TEST(PairWarmStart, FollowsASlowMotionWithTheColdAnswers)
{
	RandomBodies random(81);
	SolverCounters warmCounters, coldCounters;
	for (int i = 0; i < 50; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape();
		const Matrix3 rotation1 = random.rotation(), rotation2 = random.rotation();
		const Vector3 course = random.direction(), spin = random.direction();
		WarmStart warm;
		// From the centres' distance of the bounding spheres inwards.
		for (int step = 0; step < 200; ++step) {
			const double distance = (1 - 0.004 * step) * (shape1.boundingRadius() + shape2.boundingRadius());
			const Placement body1 { shape1, Vector3::Zero(), rotation1 }, body2 { shape2, distance * course, turn(0.002 * step, spin) * rotation2 };
			WarmStart none;
			const Contact followed = contactPair(body1, body2, warm, warmCounters), fresh = contactPair(body1, body2, none, coldCounters);
			ASSERT_EQ(followed.status, fresh.status);
			if (!fresh.overlapping()) continue;
			if (isDeep(fresh, shape1, shape2)) break;
			EXPECT_NEAR(followed.overlap, fresh.overlap, 1e-9 * distance);
			EXPECT_LT((followed.normal - fresh.normal).norm(), 1e-7);
		}
	}
	EXPECT_LT(warmCounters.iterations, coldCounters.iterations / 2);
	EXPECT_GT(warmCounters.rejectedByDirection, 0u);
	EXPECT_EQ(warmCounters.uncertified + coldCounters.uncertified, 0u);
}

TEST(PairWarmStart, AStaleMemoryDoesNoHarm)
{
	RandomBodies random(82);
	for (int i = 0; i < 500; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape();
		const Placement body1 { shape1, Vector3::Zero(), random.rotation() };
		const Placement body2 { shape2, random.uniform(0.3, 1) * (shape1.boundingRadius() + shape2.boundingRadius()) * random.direction(), random.rotation() };
		SolverCounters counters;
		WarmStart none, stale;
		stale.kind = i % 2 ? WarmStart::Point : WarmStart::Direction;
		stale.value = (i % 2 ? random.logarithmic(1e-6, 100) : 1) * random.direction();
		const Contact fresh = contactPair(body1, body2, none, counters), misled = contactPair(body1, body2, stale, counters);
		ASSERT_EQ(fresh.status, misled.status);
		if (fresh.overlapping() && !isDeep(fresh, shape1, shape2)) { EXPECT_NEAR(fresh.upper, misled.upper, 1e-9); }
		EXPECT_EQ(counters.uncertified, 0u);
	}
}

TEST(PairWarmStart, CountersAddUp)
{
	RandomBodies random(83);
	SolverCounters sum;
	for (int i = 0; i < 300; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape();
		const Placement body1 { shape1, Vector3::Zero(), random.rotation() }, body2 { shape2, 2.5 * random.direction(), random.rotation() };
		WarmStart warm;
		SolverCounters one;
		contactPair(body1, body2, warm, one);
		EXPECT_EQ(one.solves, 1u);
		EXPECT_EQ(one.rejectedBySphere + one.rejectedByBox + one.coldStarts, 1u);
		sum += one;
	}
	EXPECT_EQ(sum.solves, 300u);
	EXPECT_EQ(sum.rejectedBySphere + sum.rejectedByBox + sum.coldStarts, 300u);
}

// Centres on each other, or nearly: far beyond what a simulation may reach, but never a NaN nor a miss.
TEST(PairWarmStart, DeepAndConcentricPairsOverlap)
{
	RandomBodies random(84);
	for (double distance : { 0.0, 1e-300, 1e-20, 1e-12, 1e-6, 1e-3, 0.1 })
		for (int i = 0; i < 50; ++i) {
			const Shape shape1 = random.shape(), shape2 = random.shape();
			const Placement body1 { shape1, Vector3::Zero(), random.rotation() };
			const Placement body2 { shape2, distance * shape1.smallestHalfSize() * random.direction(), random.rotation() };
			WarmStart warm;
			SolverCounters counters;
			const Contact contact = contactPair(body1, body2, warm, counters);
			ASSERT_EQ(contact.status, Status::Overlap) << distance;
			EXPECT_NEAR(contact.normal.norm(), 1, 1e-12) << distance;
			EXPECT_TRUE(std::isfinite(contact.overlap) && contact.point.allFinite() && contact.middle().allFinite()) << distance;
			EXPECT_GT(contact.overlap, 0) << distance;
		}
}

// Equal blocks with parallel faces, one sliding over the other: the contact centre stays half way between the block's centres.
TEST(PairWarmStart, SlidingFacesKeepTheirPointInTheMiddle)
{
	for (double n : { 4.0, 8.0, 20.0 }) {
		const Shape block(Vector3::Ones(), n, n);
		const Placement body1 { block, Vector3::Zero(), Matrix3::Identity() };
		WarmStart warm;
		SolverCounters counters;
		for (int step = 0; step <= 1000; ++step) {
			const double slide = 1e-3 * step;
			const Placement body2 { block, Vector3(slide, 0, 1.995), Matrix3::Identity() };
			const Contact contact = contactPair(body1, body2, warm, counters);
			if (!contact.overlapping()) break;
			EXPECT_NEAR(contact.middle().x(), slide / 2, 1e-8) << "n = " << n << ", step " << step;
			EXPECT_NEAR(contact.middle().y(), 0, 1e-8) << "n = " << n << ", step " << step;
		}
		EXPECT_EQ(counters.uncertified + counters.fallbacks, 0u);
	}
}

// Equal blocks face on face, tilted: a small tilt moves the point by tilt a^2/(2 c d), c = tolerances::centring and d the overlap, and never
// faster than that, through zero and out to the edge.
TEST(PairWarmStart, RockingFacesMoveTheirPointInProportion)
{
	for (double n : { 4.0, 8.0, 20.0 }) {
		const Shape block(Vector3::Ones(), n, n);
		const Placement body1 { block, Vector3::Zero(), Matrix3::Identity() };
		const double overlap = 0.001, pace = 1 / (2 * tolerances::centring * overlap);
		WarmStart warm;
		SolverCounters counters;
		double last = 0;
		for (int step = -2000; step <= 2000; ++step) {
			const double tilt = 1e-6 * step;
			const Vector3 normal = turn(tilt / 2, Vector3::UnitY()) * Vector3::UnitZ();
			const Placement body2 { block, (2 - overlap) * normal, turn(tilt, Vector3::UnitY()) };
			const Contact contact = contactPair(body1, body2, warm, counters);
			ASSERT_TRUE(contact.overlapping());
			const double across = contact.middle().dot(turn(tilt / 2, Vector3::UnitY()) * Vector3::UnitX());
			if (std::abs(step) <= 20 && n > 4) { EXPECT_NEAR(across, pace * tilt, 1e-3 * pace * std::abs(tilt) + 1e-9) << "n = " << n << ", tilt " << tilt; }
			if (step > -2000) {
				EXPECT_GT(across, last) << "n = " << n << ", tilt " << tilt;
				EXPECT_LT(across - last, 1.01e-6 * pace) << "n = " << n << ", tilt " << tilt;
			}
			last = across;
		}
		EXPECT_GT(last, 0.4 * std::pow(1e-3, 1 / (n - 1))); // a part of the way to where the face itself turns by the tilt
		EXPECT_EQ(counters.uncertified + counters.fallbacks, 0u);
	}
}

TEST(PairWarmStart, SymmetricPairsKeepTheirSymmetry)
{
	for (double n : { 2.0, 3.3, 8.0, 20.0 }) {
		const Shape block(Vector3(1, 2, 0.5), n, n);
		const Placement body1 { block, Vector3::Zero(), Matrix3::Identity() };
		for (int axis = 0; axis < 3; ++axis) {
			const Vector3 apart = 1.99 * block.halfSizes()[axis] * Vector3::Unit(axis);
			const Placement body2 { block, apart, Matrix3::Identity() };
			WarmStart warm;
			SolverCounters counters;
			const Contact contact = contactPair(body1, body2, warm, counters);
			EXPECT_LT((contact.normal - Vector3::Unit(axis)).norm(), 1e-12);
			EXPECT_LT((contact.middle() - apart / 2).norm(), 1e-12);
			EXPECT_NEAR(contact.overlap, 0.01 * block.halfSizes()[axis], 1e-13);
		}
	}
}
