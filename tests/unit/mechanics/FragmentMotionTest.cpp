// What fragments do at their first moment: momentum, angular momentum, energy, and that they stay within their parent.
#include <tests/support/RandomBodies.hpp>

#include <pkg/mechanics/FragmentMotion.hpp>
#include <pkg/geometry/MassProperties.hpp>
#include <pkg/mechanics/OctahedralStress.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

using namespace superquadric;
using namespace superquadric::fragments;
using superquadric::testing::RandomBodies;

namespace {

struct Case {
	Pieces pieces;
	Parent parent;
	Layout layout;
};

// Balls with a cut, four, eighteen; superquadrics; with spins from none to fast, in contact or not.
Case randomCase(RandomBodies& random, int serial)
{
	const int kind = serial % 4;
	const Shape ball(Vector3::Constant(random.logarithmic(1e-4, 1)), 2, 2);
	const Shape shape = kind == 3 ? random.shape(0.01) : ball;
	CounterRandom own(1, serial, 0);
	const Vector3 cut = *drawCut(own, 1 + random.index(3));
	const Pieces pieces = kind == 3 ? blocks(cut) : (kind == 2 ? eighteenBalls() : (kind == 1 ? fourBalls() : ballsOfBlocks(cut)));
	const Vector3 spin = random.index(4) ? Vector3(random.direction() * random.logarithmic(1e-3, 1e3)) : Vector3(Vector3::Zero());
	const double deepest = random.index(2) ? random.uniform(0, 0.05) * shape.smallestHalfSize() : 0;
	const double mass = random.logarithmic(1e-6, 1);
	const Parent parent { shape, mass, mass * inertiaOfUnitMass(shape), random.rotation(), spin, deepest, /*storedEnergy*/ 0, /*turnable*/ kind != 3 };
	return { pieces, parent, arrange(pieces, parent, own) };
}

Shape shapeOf(const Case& event, std::size_t i)
{
	const Shape& shape = event.parent.shape;
	return Shape(shape.halfSizes().cwiseProduct(event.pieces[i].scale), shape.n1(), shape.n2());
}

// Spin momentum of each fragment plus the moment of its motion, all by itself.
Vector3 angularMomentum(const Case& event)
{
	const Layout& layout = event.layout;
	Vector3 sum = Vector3::Zero();
	for (std::size_t i = 0; i < event.pieces.size(); ++i) {
		const double mass = event.pieces[i].share * event.parent.mass;
		const Vector3 own = layout.rotation.transpose() * layout.spin, inertia = inertiaOfUnitMass(shapeOf(event, i));
		sum += mass * (layout.offsets[i].cross(layout.spin.cross(layout.offsets[i])) + layout.rotation * inertia.cwiseProduct(own));
	}
	return sum;
}

} // namespace

TEST(FragmentMotion, CentreOfMassMomentumAndAngularMomentumStay)
{
	RandomBodies random(11);
	for (int serial = 0; serial < 4000; ++serial) {
		const Case event = randomCase(random, serial);
		Vector3 centre = Vector3::Zero(), momentum = Vector3::Zero();
		for (std::size_t i = 0; i < event.pieces.size(); ++i) {
			centre += event.pieces[i].share * event.layout.offsets[i];
			momentum += event.pieces[i].share * event.layout.spin.cross(event.layout.offsets[i]);
		}
		const double size = event.parent.shape.boundingRadius();
		ASSERT_LT(centre.norm(), 1e-12 * size) << serial;
		ASSERT_LE(momentum.norm(), 1e-12 * size * event.layout.spin.norm()) << serial;
		const Vector3 before = event.parent.spinMomentum();
		ASSERT_LE((angularMomentum(event) - before).norm(), 1e-12 * before.norm()) << serial;
	}
}

TEST(FragmentMotion, RotationGetsNoEnergy)
{
	RandomBodies random(12);
	for (int serial = 0; serial < 4000; ++serial) {
		const Case event = randomCase(random, serial);
		ASSERT_FALSE(event.layout.gains) << serial;
		ASSERT_LE(event.layout.spinEnergy, event.parent.spinEnergy() * (1 + tolerances::energyRounding)) << serial;
	}
}

// With stored energy to spend nothing has to be spread: all centres keep clear of the parent's surface.
TEST(FragmentMotion, FragmentsOfAParticleUnderLoadStayInsideIt)
{
	RandomBodies random(13);
	for (int serial = 0; serial < 4000; ++serial) {
		Case event = randomCase(random, serial);
		event.parent.storedEnergy = 10 * event.parent.spinEnergy();
		CounterRandom own(2, serial, 0);
		event.layout = arrange(event.pieces, event.parent, own);
		const double reach = 1 - event.parent.deepest / event.parent.shape.smallestHalfSize();
		for (std::size_t i = 0; i < event.pieces.size(); ++i) {
			const Vector3 place = event.layout.rotation.transpose() * event.layout.offsets[i];
			const double margin = tolerances::fragmentMargin * event.pieces[i].scale.minCoeff();
			ASSERT_LE(event.parent.shape.gauge(place), reach - margin + 1e-12) << serial;
		}
	}
}

TEST(FragmentMotion, BlocksOfABoxKeepTheirPlacesAndTheParentsSpin)
{
	// The sharper the shape, the nearer its blocks come to the pieces of a box, which has the inertia of the whole.
	const Shape box({ 1, 2, 3 }, 20, 20);
	const Parent parent { box, 5, 5 * inertiaOfUnitMass(box), Matrix3::Identity(), { 1, -2, 0.5 }, 0, 0, false };
	const Pieces pieces = blocks({ 0.4, 0.5, 0.6 });
	CounterRandom random(1, 0, 0);
	const Layout layout = arrange(pieces, parent, random);
	EXPECT_LT((layout.spin - parent.spin).norm(), 0.05 * parent.spin.norm());
	for (int i = 0; i < 8; ++i)
		EXPECT_LT((layout.offsets[i] - parent.shape.halfSizes().cwiseProduct(pieces[i].place)).norm(), 1e-14);
}

TEST(FragmentMotion, FixedModesHaveTheInertiaOfTheParent)
{
	for (const Pieces& pieces : { fourBalls(), eighteenBalls() }) {
		Matrix3 inertia = Matrix3::Zero();
		for (const Piece& piece : pieces) {
			const double own = 2. / 5 * piece.scale.x() * piece.scale.x();
			inertia += piece.share * ((own + piece.place.squaredNorm()) * Matrix3::Identity() - piece.place * piece.place.transpose());
		}
		EXPECT_LT((inertia - 2. / 5 * Matrix3::Identity()).norm(), 1e-14);
	}
}

TEST(FragmentMotion, InertiaOfUnitMassIsThatOfTheClosedForm)
{
	RandomBodies random(14);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape();
		const Vector3 expected = inertiaOfUnitDensity(shape) / volume(shape);
		EXPECT_LT((inertiaOfUnitMass(shape) - expected).norm(), 1e-12 * expected.norm());
	}
}

// sqrt(2)/3 times the stress of a bar; none for a pressure; turning changes nothing.
TEST(OctahedralShearStress, KnownStates)
{
	EXPECT_NEAR(octahedralShearStress(Vector3(3, 0, 0).asDiagonal()), std::sqrt(2.), 1e-15);
	EXPECT_NEAR(octahedralShearStress(5 * Matrix3::Identity()), 0, 1e-15);
	const Vector3 principal(1, -2, 4);
	const double differences = std::sqrt(9. + 36. + 9.) / 3;
	RandomBodies random(15);
	const Matrix3 turn = random.rotation();
	EXPECT_NEAR(octahedralShearStress(turn * principal.asDiagonal() * turn.transpose()), differences, 1e-14);
	Matrix3 skew;
	skew << 0, 1, 2, -1, 0, 3, -2, -3, 0;
	EXPECT_NEAR(octahedralShearStress(Matrix3(principal.asDiagonal()) + skew), differences, 1e-14);
}
