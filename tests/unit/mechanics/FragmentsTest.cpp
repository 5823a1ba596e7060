// Sizes and places of fragments: what is conserved, and the distribution of the cut.
#include <pkg/mechanics/Fragments.hpp>
#include <pkg/geometry/MassProperties.hpp>
#include <pkg/mechanics/WeibullStrength.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace superquadric;
using namespace superquadric::fragments;

namespace {

// Largest distance between the empirical distribution of values and a distribution function.
template <class Function> double kolmogorovDistance(std::vector<double> values, Function distribution)
{
	std::sort(values.begin(), values.end());
	double largest = 0;
	for (std::size_t i = 0; i < values.size(); ++i) {
		const double expected = distribution(values[i]);
		largest = std::max({ largest, expected - double(i) / values.size(), double(i + 1) / values.size() - expected });
	}
	return largest;
}

// P(D > 1.95/sqrt(n)) = 0.001 (Kolmogorov).
constexpr double onePermille = 1.95;

double sumOfShares(const Pieces& pieces)
{
	double sum = 0;
	for (const Piece& piece : pieces)
		sum += piece.share;
	return sum;
}

Vector3 centreOfMass(const Pieces& pieces)
{
	Vector3 centre = Vector3::Zero();
	for (const Piece& piece : pieces)
		centre += piece.share * piece.place;
	return centre;
}

Vector3 randomCut(CounterRandom& random, double exponent) { return *drawCut(random, exponent); }

} // namespace

TEST(Fragments, SharesOfAKnownCut)
{
	const auto shares = blockShares({ 0.25, 0.5, 0.2 });
	const double expected[] = { 0.025, 0.075, 0.025, 0.075, 0.1, 0.3, 0.1, 0.3 };
	for (int i = 0; i < 8; ++i)
		EXPECT_NEAR(shares[i], expected[i], 1e-16);
}

TEST(Fragments, MassAndCentreOfMassStay)
{
	CounterRandom random(1, 0, 0);
	for (double exponent : { 1., 2., 3. })
		for (int i = 0; i < 1000; ++i) {
			const Vector3 cut = randomCut(random, exponent);
			for (const Pieces& pieces : { blocks(cut), ballsOfBlocks(cut) }) {
				ASSERT_NEAR(sumOfShares(pieces), 1, 1e-12);
				ASSERT_LT(centreOfMass(pieces).norm(), 1e-12);
			}
		}
	for (const Pieces& pieces : { fourBalls(), eighteenBalls() }) {
		EXPECT_NEAR(sumOfShares(pieces), 1, 1e-15);
		EXPECT_LT(centreOfMass(pieces).norm(), 1e-15);
	}
}

TEST(Fragments, VolumesOfPiecesAreTheirShares)
{
	CounterRandom random(2, 0, 0);
	for (int i = 0; i < 300; ++i) {
		const Vector3 cut = randomCut(random, 2), sizes(0.01, 0.03, 0.02);
		const Shape parent(sizes, 6, 3.3);
		for (const Piece& piece : blocks(cut)) {
			const Shape child(sizes.cwiseProduct(piece.scale), 6, 3.3);
			ASSERT_NEAR(volume(child), piece.share * volume(parent), 1e-12 * piece.share * volume(parent));
		}
		for (const Piece& piece : ballsOfBlocks(cut))
			ASSERT_NEAR(piece.scale.prod(), piece.share, 1e-12 * piece.share);
	}
	EXPECT_NEAR(fourBalls()[0].scale.prod(), 1. / 4, 1e-15);
	EXPECT_NEAR(eighteenBalls()[0].scale.prod(), 1. / 18, 1e-15);
	EXPECT_EQ(eighteenBalls().size(), 18u);
}

TEST(Fragments, BlocksFillTheBoxAndDoNotOverlap)
{
	CounterRandom random(3, 0, 0);
	const Vector3 cut = randomCut(random, 1);
	for (int sample = 0; sample < 10000; ++sample) {
		const Vector3 point(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
		int holders = 0;
		for (const Piece& piece : blocks(cut))
			holders += ((point - piece.place).cwiseAbs().array() < piece.scale.array()).all();
		ASSERT_EQ(holders, 1) << point.transpose();
	}
}

// A ball sits on the same side of its siblings as its block: along each axis in the order of the blocks.
TEST(Fragments, BallsSitInTheirOctants)
{
	CounterRandom random(4, 0, 0);
	for (int i = 0; i < 1000; ++i) {
		const Pieces pieces = ballsOfBlocks(randomCut(random, 2));
		for (int piece = 0; piece < 8; ++piece)
			for (int axis = 0; axis < 3; ++axis) {
				if (piece >> axis & 1) continue;
				ASSERT_LT(pieces[piece].place[axis], pieces[piece | 1 << axis].place[axis]);
			}
	}
}

TEST(Fragments, CutsFollowThePowerLaw)
{
	constexpr int number = 20000;
	for (double exponent : { 1., 2., 3. }) {
		CounterRandom random(5, 0, 0);
		std::vector<double> coordinates[3];
		for (int i = 0; i < number; ++i) {
			const Vector3 cut = randomCut(random, exponent);
			for (int axis = 0; axis < 3; ++axis)
				coordinates[axis].push_back(cut[axis]);
		}
		for (const auto& values : coordinates)
			EXPECT_LT(kolmogorovDistance(values, [&](double x) { return std::pow(x, 1 / exponent); }), onePermille / std::sqrt(number));
	}
}

TEST(Fragments, NoPieceIsSmallerThanAskedFor)
{
	CounterRandom random(6, 0, 0);
	for (int i = 0; i < 1000; ++i) {
		const auto cut = drawCut(random, 2, { 1e-3, { 0, 0.05, 0.2 } });
		ASSERT_TRUE(cut);
		const auto shares = blockShares(*cut);
		ASSERT_GE(*std::min_element(shares.begin(), shares.end()), 1e-3);
		ASSERT_TRUE(cut->y() >= 0.05 && cut->y() <= 0.95 && cut->z() >= 0.2 && cut->z() <= 0.8);
	}
	const Least pieces { 0.2, Vector3::Zero() }, sides { 0, { 0.6, 0, 0 } }; // eight pieces of a fifth; two sides of more than a half
	for (const Least& least : { pieces, sides }) {
		EXPECT_FALSE(least.possible());
		EXPECT_FALSE(drawCut(random, 2, least));
	}
}

TEST(CounterRandomNumbers, AreTheSameEverywhere)
{
	// The first three of seed 0, serial 0, purpose 0: written down once, to be found on any platform.
	CounterRandom random(0, 0, 0), again(0, 0, 0), other(0, 1, 0);
	for (double expected : { 0.12964561829974752, 0.049920065672091396, 0.67032837005867918 })
		EXPECT_EQ(random.uniform(), expected);
	EXPECT_EQ(again.uniform(), 0.12964561829974752);
	EXPECT_NE(other.uniform(), 0.12964561829974752);
}

TEST(CounterRandomNumbers, AreUniformOverSerialsAndWithinOne)
{
	constexpr int number = 100000;
	std::vector<double> over, within;
	CounterRandom one(7, 7, 7);
	double correlation = 0;
	for (int serial = 0; serial < number; ++serial) {
		over.push_back(CounterRandom(7, serial, 1).uniform());
		within.push_back(one.uniform());
		if (serial > 0) correlation += (over[serial] - 0.5) * (over[serial - 1] - 0.5);
	}
	const auto uniform = [](double x) { return x; };
	EXPECT_LT(kolmogorovDistance(over, uniform), onePermille / std::sqrt(number));
	EXPECT_LT(kolmogorovDistance(within, uniform), onePermille / std::sqrt(number));
	EXPECT_LT(std::abs(correlation * 12 / number), 3 / std::sqrt(number)); // three standard deviations
}

TEST(CounterRandomNumbers, RotationsAreProperAndHaveNoPreferredDirection)
{
	CounterRandom random(8, 0, 0);
	constexpr int number = 20000;
	std::vector<double> heights[3];
	for (int i = 0; i < number; ++i) {
		const Matrix3 turn = random.rotation();
		ASSERT_LT((turn * turn.transpose() - Matrix3::Identity()).norm(), 1e-14);
		ASSERT_NEAR(turn.determinant(), 1, 1e-14);
		for (int axis = 0; axis < 3; ++axis)
			heights[axis].push_back(turn(axis, 2));
	}
	for (const auto& values : heights) // Archimedes: the height of a point on the sphere is uniform
		EXPECT_LT(kolmogorovDistance(values, [](double z) { return (1 + z) / 2; }), onePermille / std::sqrt(number));
}

TEST(WeibullStrengthLaw, QuantileAndSurvivalBelongTogetherAndStrengthFallsWithSize)
{
	const WeibullStrength law { 2e6, 0.03, 3.5 };
	EXPECT_NEAR(law.survival(0.03, 2e6), std::exp(-1), 1e-15);
	for (double size : { 0.002, 0.03, 0.2 })
		for (double survival : { 1e-6, 0.3, 0.999999 })
			EXPECT_NEAR(law.survival(size, law.quantile(size, survival)), survival, 1e-12);
	EXPECT_NEAR(law.quantile(0.06, 0.3) / law.quantile(0.03, 0.3), std::pow(2, -3 / 3.5), 1e-14);
}
