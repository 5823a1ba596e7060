// The contract of normal and overlap: body 2 pushed along the normal by the overlap parts from body 1; by less, it does not.
//
// The second half is exact: X1 and X2 change places, and what lies between them is common to both until then. The first holds up to a rest,
// which the oracle measures: how much farther body 2 must go, relative to the overlap. Where surfaces curve, the rest is in
// proportion to the overlap over the size (the normals at X1 and X2 are not quite that at X0). Where flat faces meet at a tilt comparable to
// the overlap over the size, X0 is the middle of the overlap and not its deepest point, as the resultant of a pressure would be:
// the deeper edge is left, a fraction of the overlap that does not fall with it.
//
// The table of docs/accuracy.md is pushing.md of SUPERQUADRIC_ACCURACY_TABLE=FOLDER.
#include "AccuracyTable.hpp"
#include "CommonScaling.hpp"
#include "RandomPairs.hpp"

#include <pkg/detection/PairContact.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr int pairsEach = 100;

// What is asserted of the rest: per class, `slope` times the overlap in smallest half sizes in random places, at most `tilted` when aligned.
struct Bound {
	double slope, tilted;
};
constexpr Bound bounds[] = { { 0.2, 0.005 }, { 3, 0.05 }, { 5, 0.1 }, { 15, 0.2 }, { 30, 0.5 }, { 80, 1 } };

// The rest of a pair that overlaps by about `depth` smallest half sizes.
void pushApart(const RandomPair& pair, double depth, double& rest)
{
	const Shape shape1(pair.sizes1, pair.n11, pair.n12), shape2(pair.sizes2, pair.n21, pair.n22);
	const double smallest = std::min(shape1.smallestHalfSize(), shape2.smallestHalfSize());
	const Placement body1 { shape1, Vector3::Zero(), pair.rotation1 };
	const auto scalingAt = [&](const Vector3& place) { return commonScaling<double>(body1, Placement { shape2, place, pair.rotation2 }); };
	const Vector3 place = pair.along * (double(1 / scalingAt(pair.along).middle()) - depth * smallest / pair.along.norm());
	WarmStart warm;
	SolverCounters counters;
	const Contact contact = contactPair(body1, Placement { shape2, place, pair.rotation2 }, warm, counters);
	ASSERT_EQ(contact.status, Status::Overlap);
	const auto pushed = [&](double part) { return scalingAt(place + part * contact.overlap * contact.normal); };
	EXPECT_LT(pushed(1 - 1e-6).upper, 1);

	double joined = 0.5, parted = 3;
	ASSERT_GT(pushed(parted).lower, 1);
	while (parted - joined > 1e-8) {
		const double middle = (joined + parted) / 2;
		(pushed(middle).middle() < 1 ? joined : parted) = middle;
	}
	rest = joined - 1;
}

} // namespace

TEST(PairContract, PushingByTheOverlapPartsButForTheStatedRest)
{
	AccuracyTable table("class | place | overlap 1e-6: median | worst | 1e-4: median | worst | 1e-2: median | worst");
	for (bool aligned : { false, true })
		for (const ShapeClass& shape : shapeClasses) {
			const std::string place = aligned ? "aligned" : "random";
			const std::uint64_t number = std::uint64_t(&shape - shapeClasses);
			table << shape.name << place;
			for (double depth : { 1e-6, 1e-4, 1e-2 }) {
				std::vector<double> rests;
				for (std::uint64_t i = 0; i < pairsEach; ++i) {
					double rest = 0;
					pushApart(RandomPair(100 + number, 2 * i + aligned, shape.exponents, shape.exponents, aligned), depth, rest);
					ASSERT_FALSE(HasFailure()) << place << " pair " << i << " of " << shape.name << ", overlap " << depth;
					rests.push_back(std::abs(rest));
				}
				EXPECT_LT(worst(rests), aligned ? bounds[number].tilted : bounds[number].slope * depth + 1e-7) << place << " " << shape.name << ", overlap " << depth;
				table << median(rests) << worst(rests);
			}
			table.endRow();
		}
	table.writeTo("pushing.md");
}
