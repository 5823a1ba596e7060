// The contract of a contact of two superquadrics (Contact.hpp): signs, normal, overlap, surface points, symmetry, warm start.
// The verdicts themselves are held against an oracle in tests/oracle.
#include <pkg/geometry/Curvature.hpp>
#include <pkg/detection/PairContact.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <tests/oracle/CommonScaling.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

const double sizes[] = { 1e-6, 1e-3, 1.0, 10.0 };

struct Body {
	Shape shape;
	Vector3 position;
	Matrix3 rotation;
	Placement placed() const { return { shape, position, rotation }; }
};

struct Pair {
	Body one, two;
};

Contact contactOf(const Body& one, const Body& two)
{
	WarmStart warm;
	SolverCounters counters;
	const Contact contact = contactPair(one.placed(), two.placed(), warm, counters);
	EXPECT_EQ(counters.uncertified, 0u);
	return contact;
}
Contact contactOf(const Pair& pair) { return contactOf(pair.one, pair.two); }

// A random pair whose common scaling is t, by the oracle.
Pair pairAt(RandomBodies& random, double t, double size = 1)
{
	const Shape shape1 = random.shape(size), shape2 = random.shape(size * random.logarithmic(0.05, 20));
	Body one { shape1, size * random.direction(), random.rotation() }, two { shape2, one.position + size * random.direction(), random.rotation() };
	const double reached = double(commonScaling(one.placed(), two.placed()).middle());
	two.position = one.position + (two.position - one.position) * (t / reached);
	return { one, two };
}

Pair moved(const Pair& pair, const Matrix3& turn, const Vector3& shift, double scale)
{
	const auto copy = [&](const Body& b) {
		return Body { Shape(scale * b.shape.halfSizes(), b.shape.n1(), b.shape.n2()), scale * (turn * b.position + shift), turn * b.rotation };
	};
	return { copy(pair.one), copy(pair.two) };
}

double smallest(const Pair& pair) { return std::min(pair.one.shape.smallestHalfSize(), pair.two.shape.smallestHalfSize()); }

// The pair drawn together until its overlap is a part of the smallest half size; to first order.
Pair sunk(const Pair& touching, double part)
{
	Pair pair = touching;
	const Vector3 between = pair.two.position - pair.one.position;
	pair.two.position = pair.one.position + between * (1 - part * smallest(pair) / between.norm());
	return pair;
}

RealVector seenBy(const Body& body, const Vector3& x) { return body.rotation.cast<Real>().transpose() * (x - body.position).cast<Real>(); }

// Of the gauge, and of half the squared distance from the centre in half sizes; in space.
RealVector gaugeGradient(const Body& body, const ReferenceShape& reference, const RealVector& x)
{
	const Real f = reference.function(x), g = std::pow(f, 1 / reference.n1);
	return body.rotation.cast<Real>() * (reference.gradient(x) * (g / (reference.n1 * f)));
}
RealVector offCentreGradient(const Body& body, const RealVector& x)
{
	return body.rotation.cast<Real>() * x.cwiseQuotient(body.shape.halfSizes().cast<Real>().cwiseAbs2());
}

} // namespace

TEST(PairContact, OfSpheresIsClosedForm)
{
	RandomBodies random(71);
	for (double size : sizes)
		for (int i = 0; i < 100; ++i) {
			const double radius1 = size * random.logarithmic(0.1, 1), radius2 = size * random.logarithmic(0.1, 1);
			// Up to an overlap of half the smaller radius; deeper ones have swallowed each other.
			const double t = 1 + random.uniform(-0.5, 0.1) * std::min(radius1, radius2) / (radius1 + radius2);
			const Vector3 centre1 = size * random.direction(), normal = random.direction(), centre2 = centre1 + t * (radius1 + radius2) * normal;
			const Body one { Shape(Vector3::Constant(radius1), 2, 2), centre1, random.rotation() }, two { Shape(Vector3::Constant(radius2), 2, 2), centre2, random.rotation() };
			const Contact contact = contactOf(one, two);
			ASSERT_EQ(contact.status, t < 1 ? Status::Overlap : Status::Apart);
			EXPECT_LT((contact.normal - normal).norm(), 1e-10);
			if (t > 1) continue;
			EXPECT_NEAR(contact.overlap, radius1 + radius2 - (centre2 - centre1).norm(), 1e-13 * size);
			EXPECT_LT((contact.surface1 - centre1 - radius1 * normal).norm(), 1e-10 * size);
			EXPECT_LT((contact.surface2 - centre2 + radius2 * normal).norm(), 1e-10 * size);
			EXPECT_LT((contact.point - centre1 - t * radius1 * normal).norm(), 1e-10 * size);
			EXPECT_NEAR(contact.curvature1 * radius1, 1, 1e-12);
			EXPECT_NEAR(contact.curvature2 * radius2, 1, 1e-12);
		}
}

TEST(PairContact, OverlapKeepsTheContract)
{
	RandomBodies random(72);
	for (int i = 0; i < 1000; ++i) {
		// Deeper ones have all but swallowed each other.
		const Pair pair = sunk(pairAt(random, 1, sizes[i % 4]), random.logarithmic(1e-6, 0.1));
		const double t = double(commonScaling(pair.one.placed(), pair.two.placed()).middle());
		const Contact contact = contactOf(pair);
		ASSERT_EQ(contact.status, Status::Overlap);
		EXPECT_LT(contact.upper, 1);
		EXPECT_GT(contact.upper, t - 1e-12); // no point is deeper than t*
		EXPECT_NEAR(contact.normal.norm(), 1, 1e-14);
		EXPECT_GT(contact.normal.dot(pair.two.position - pair.one.position), 0);
		EXPECT_GT(contact.overlap, 0);
		const double blur = 1e-14 * (contact.point.norm() + pair.one.shape.boundingRadius());
		EXPECT_LT((contact.surface1 - contact.surface2 - contact.overlap * contact.normal).norm(), blur);
		EXPECT_LE(contact.lower, t);

		const ReferenceShape reference1(pair.one.shape), reference2(pair.two.shape);
		const Real tolerance = 20 * blur / smallest(pair);
		EXPECT_LT(std::abs(reference1.function(seenBy(pair.one, contact.surface1)) - 1), tolerance * reference1.n1);
		EXPECT_LT(std::abs(reference2.function(seenBy(pair.two, contact.surface2)) - 1), tolerance * reference2.n1);
		// The contact centre: the gauges are equal, and across the normal the gradients balance the pull to the middle.
		const RealVector x1 = seenBy(pair.one, contact.point), x2 = seenBy(pair.two, contact.point);
		const RealVector gradient1 = gaugeGradient(pair.one, reference1, x1), gradient2 = gaugeGradient(pair.two, reference2, x2);
		EXPECT_NEAR(std::pow(reference1.function(x1), 1 / reference1.n1), std::pow(reference2.function(x2), 1 / reference2.n1), 1e-10);
		const RealVector normal = contact.normal.cast<Real>(), axis = gradient1 - gradient2;
		EXPECT_LT((axis / axis.norm() - normal).norm(), 1e-8);
		const RealVector pull = gradient1 + tolerances::centring * Real(1 - contact.upper) * (offCentreGradient(pair.one, x1) + offCentreGradient(pair.two, x2));
		EXPECT_LT((pull - pull.dot(normal) * normal).norm(), 1e-7 * axis.norm());
	}
}

// With equal n1 the point of a shallow contact solves eq. (2) in F: the gradients balance and F_i = F_j.
TEST(PairContact, EqualExponentsSolveEquationTwo)
{
	RandomBodies random(73);
	for (int i = 0; i < 300; ++i) {
		Pair pair = pairAt(random, 1);
		const Shape copy(pair.two.shape.halfSizes(), pair.one.shape.n1(), pair.two.shape.n2());
		pair.two = Body { copy, pair.two.position, pair.two.rotation };
		const double reached = double(commonScaling(pair.one.placed(), pair.two.placed()).middle());
		pair.two.position = pair.one.position + (pair.two.position - pair.one.position) * ((1 - 1e-9) / reached);
		const Contact contact = contactOf(pair);
		ASSERT_EQ(contact.status, Status::Overlap);
		const ReferenceShape reference1(pair.one.shape), reference2(pair.two.shape);
		const RealVector x1 = seenBy(pair.one, contact.point), x2 = seenBy(pair.two, contact.point);
		const RealVector gradient1 = pair.one.rotation.cast<Real>() * reference1.gradient(x1), gradient2 = pair.two.rotation.cast<Real>() * reference2.gradient(x2);
		const Real squareOfMultiplier = gradient1.norm() / gradient2.norm();
		EXPECT_LT((gradient1 + squareOfMultiplier * gradient2).norm(), 1e-6L * gradient1.norm());
		EXPECT_NEAR(reference1.function(x1), reference2.function(x2), 1e-10 * pair.one.shape.n1());
	}
}

TEST(PairContact, ApartIsProvedBySurfacePoints)
{
	RandomBodies random(74);
	for (int i = 0; i < 300; ++i) {
		const Pair pair = pairAt(random, 1 + random.logarithmic(1e-9, 0.05), sizes[i % 4]);
		const Contact contact = contactOf(pair);
		ASSERT_EQ(contact.status, Status::Apart);
		EXPECT_GT(contact.lower, 1);
		const auto largest = [&](const Body& body, const Vector3& direction) {
			const Vector3 own = body.rotation.transpose() * direction;
			const ReferenceShape reference(body.shape);
			Real far = reference.searchedSupport(own);
			for (int k = 0; k < 500; ++k)
				far = std::max(far, reference.surfacePoint(random.uniform(-pi / 2, pi / 2), random.uniform(-pi, pi)).dot(own.cast<Real>()));
			return double(far);
		};
		const double gap = (pair.two.position - pair.one.position).dot(contact.normal) - largest(pair.one, contact.normal) - largest(pair.two, -contact.normal);
		EXPECT_GT(gap, 0);
	}
}

// Body 2 pushed along the normal by a little less than the overlap still overlaps, exactly: X1 is then common to both. Pushed by the
// overlap it is parted but for a residue of second order, for X0 is not quite the deepest point: the residue relative to the
// overlap is a multiple of the overlap over the size of the face that carries it.
TEST(PairContact, PushingByTheOverlapParts)
{
	RandomBodies random(75);
	for (int i = 0; i < 500; ++i) {
		const double depth = random.logarithmic(1e-8, 1e-5);
		const Pair pair = pairAt(random, 1 - depth, sizes[i % 4]);
		const Contact contact = contactOf(pair);
		ASSERT_EQ(contact.status, Status::Overlap);
		Body pushed = pair.two;
		pushed.position = pair.two.position + 0.999 * contact.overlap * contact.normal;
		EXPECT_EQ(contactOf(pair.one, pushed).status, Status::Overlap);
		pushed.position = pair.two.position + 1.003 * contact.overlap * contact.normal;
		EXPECT_EQ(contactOf(pair.one, pushed).status, Status::Apart) << "t* = 1 - " << depth;
	}
}

TEST(PairContact, SwappedBodiesGiveTheReversedContact)
{
	RandomBodies random(76);
	for (int i = 0; i < 500; ++i) {
		const double size = sizes[i % 4];
		const Pair touching = pairAt(random, 1, size), pair = random.index(4) ? sunk(touching, random.logarithmic(1e-6, 0.1)) : sunk(touching, -0.02);
		const Contact contact = contactOf(pair), swapped = contactOf(pair.two, pair.one).reversed();
		ASSERT_EQ(contact.status, swapped.status);
		if (!contact.overlapping()) continue;
		EXPECT_NEAR(contact.overlap, swapped.overlap, 1e-9 * size);
		EXPECT_LT((contact.normal - swapped.normal).norm(), 1e-8);
		EXPECT_LT((contact.surface1 - swapped.surface1).norm(), 1e-5 * size);
		EXPECT_NEAR(contact.curvature1 * size, swapped.curvature1 * size, 1e-5 * (1 + contact.curvature1 * size));
	}
}

TEST(PairContact, DoesNotKnowThePlaceTheFrameOrTheMetre)
{
	RandomBodies random(77);
	for (int i = 0; i < 300; ++i) {
		const Pair pair = sunk(pairAt(random, 1), random.index(2) ? random.logarithmic(1e-6, 0.1) : random.uniform(-0.05, -0.001));
		const Contact contact = contactOf(pair);
		for (double scale : sizes) {
			const Matrix3 turn = random.rotation();
			const Vector3 shift = 10 * random.direction();
			const Contact other = contactOf(moved(pair, turn, shift, scale));
			ASSERT_EQ(other.status, contact.status);
			if (!contact.overlapping()) continue;
			EXPECT_NEAR(other.overlap, scale * contact.overlap, 1e-9 * scale);
			EXPECT_LT((other.normal - turn * contact.normal).norm(), 1e-8);
			EXPECT_NEAR(other.upper, contact.upper, 1e-10);
		}
	}
}

// Curvatures are those of the surface points within what the surface turns over the overlap: at a shallow contact, the same.
TEST(PairContact, CurvaturesAreThoseOfTheSurfacePoints)
{
	RandomBodies random(78);
	for (int i = 0; i < 300; ++i) {
		const Pair pair = pairAt(random, 1 - 1e-9);
		const Contact contact = contactOf(pair);
		const double expected1 = meanCurvature(pair.one.shape, seenBy(pair.one, contact.surface1).cast<double>());
		const double expected2 = meanCurvature(pair.two.shape, seenBy(pair.two, contact.surface2).cast<double>());
		EXPECT_NEAR(contact.curvature1, expected1, 1e-4 * std::max(expected1, 1 / pair.one.shape.boundingRadius()));
		EXPECT_NEAR(contact.curvature2, expected2, 1e-4 * std::max(expected2, 1 / pair.two.shape.boundingRadius()));
	}
}

// Nothing is proved of a body whose place is not a number, and it is not settled in silence.
// Found by the fuzz tests: at 1e-311 m, where the square of the distance vanishes, two balls were apart.
TEST(PairContact, CentresThatAllButCoincideAreAnOverlap)
{
	RandomBodies random(79);
	for (double power = -323; power < 0; power += 0.5)
		for (double size : sizes) {
			const double distance = size * std::pow(10, power);
			const Body one { Shape(Vector3::Constant(size), 2, 2), Vector3::Zero(), random.rotation() };
			for (const Shape& shape : { one.shape, random.shape(size) }) {
				const Contact contact = contactOf(one, { shape, distance * random.direction(), random.rotation() });
				ASSERT_EQ(contact.status, Status::Overlap) << distance;
				EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
				EXPECT_TRUE(contact.overlap > 0 && contact.point.allFinite() && contact.surface1.allFinite() && contact.surface2.allFinite());
			}
		}
}

TEST(PairContact, NotANumberIsNoVerdict)
{
	const Shape cube(Vector3::Constant(1), 8, 8);
	const double nan = std::numeric_limits<double>::quiet_NaN();
	for (const auto& [position, rotation] : { std::pair<Vector3, Matrix3>(Vector3(nan, 0, 0), Matrix3::Identity()), { Vector3(1, 0, 0), Matrix3::Constant(nan) } }) {
		WarmStart warm;
		SolverCounters counters;
		const Contact contact = contactPair({ cube, Vector3::Zero(), Matrix3::Identity() }, { cube, position, rotation }, warm, counters);
		EXPECT_EQ(contact.status, Status::Uncertified);
		EXPECT_EQ(counters.uncertified, 1u);
	}
}
