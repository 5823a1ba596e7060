// Planes: the verdict against a search over the body's surface, the contact centre against a search over the plane.
#include <pkg/detection/WallContact.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

const double sizes[] = { 1e-6, 1e-3, 1.0, 10.0 };

double gaugeAt(const Placement& body, const Vector3& x)
{
	const ReferenceShape reference(body.shape);
	return double(std::pow(reference.function(body.toBody(x - body.position)), 1 / reference.n1));
}

// The objective that the contact centre minimises over the plane; infinite outside the body.
double objectiveAt(const Placement& body, const Vector3& x)
{
	const double gauge = gaugeAt(body, x);
	if (!(gauge < 1)) return std::numeric_limits<double>::infinity();
	return -std::log(1 - gauge) + body.toBody(x - body.position).cwiseQuotient(body.shape.halfSizes()).squaredNorm();
}

Contact coldContact(const Placement& body, const Vector3& origin, const Vector3& outward)
{
	WarmStart warm;
	SolverCounters counters;
	const Contact contact = contactPlane(body, origin, outward, warm, counters);
	EXPECT_EQ(counters.uncertified, 0u);
	EXPECT_EQ(counters.fallbacks, 0u);
	return contact;
}

// A body whose deepest point is `depth` times the size of its half thickness behind the plane z = 0.
Placement sunk(const Shape& shape, const Matrix3& rotation, double depth)
{
	return { shape, Vector3(0, 0, (1 - depth) * shape.support(rotation.row(2))), rotation };
}

// Nearly lying on one of its faces: turned by `angle` about a random axis.
Matrix3 nearlyFlat(RandomBodies& random, double angle)
{
	const int up = random.index(3);
	Matrix3 axes;
	for (int k = 0; k < 3; ++k)
		axes.col((up + 1 + k) % 3) = Vector3::Unit(k);
	return Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix() * axes;
}

} // namespace

TEST(PlaneContact, VerdictAndContract)
{
	RandomBodies random(101);
	for (int i = 0; i < 400; ++i) {
		const double size = sizes[i % 4];
		const Shape shape = random.shape(size);
		const Placement body { shape, size * random.direction(), random.rotation() };
		const Vector3 outward = random.direction();
		const Vector3 origin = body.position - random.uniform(0.05, 1.2) * shape.boundingRadius() * outward + size * outward.unitOrthogonal();
		const Contact contact = coldContact(body, origin, outward);

		const double reach = double(ReferenceShape(shape).searchedSupport(body.toBody(outward)));
		const double depth = reach - (body.position - origin).dot(outward), blur = 1e-12 * size;
		ASSERT_EQ(contact.status, depth > 0 ? Status::Overlap : Status::Apart);
		EXPECT_EQ(contact.normal, -outward); // from the body into the wall
		if (!contact.overlapping()) {
			EXPECT_GT(contact.lower, 1);
			continue;
		}
		EXPECT_GT(contact.overlap, 0);
		EXPECT_LE(contact.overlap, depth + blur);
		EXPECT_NEAR(gaugeAt(body, contact.surface1), 1, 1e-12);
		EXPECT_NEAR((contact.surface2 - origin).dot(outward), 0, blur);
		EXPECT_LT((contact.surface1 - contact.surface2 - contact.overlap * contact.normal).norm(), blur);
		EXPECT_NEAR(contact.upper, gaugeAt(body, contact.point), 1e-7 * (1 - contact.upper) + 1e-13);
		EXPECT_LT(gaugeAt(body, contact.point), 1); // the proof
	}
}

TEST(PlaneContact, CentreIsTheMinimiserOnThePlane)
{
	RandomBodies random(102);
	for (int i = 0; i < 400; ++i) {
		const Shape shape = random.shape(sizes[i % 4]);
		const Matrix3 rotation = i % 2 ? random.rotation() : nearlyFlat(random, random.logarithmic(1e-9, 0.3));
		const double depth = random.logarithmic(1e-7, 0.5);
		const Placement body = sunk(shape, rotation, depth);
		const Contact contact = coldContact(body, Vector3::Zero(), Vector3::UnitZ());
		ASSERT_EQ(contact.status, Status::Overlap);
		const double best = objectiveAt(body, contact.point);
		ASSERT_TRUE(std::isfinite(best));
		// From near to far; the reference's own rounding in the logarithm grows as the depth falls.
		for (double distance = 1e-5; distance < 2; distance *= 1.3) {
			const double turn = random.uniform(-pi, pi);
			const Vector3 other = contact.point + distance * shape.smallestHalfSize() * Vector3(std::cos(turn), std::sin(turn), 0);
			EXPECT_GE(objectiveAt(body, other), best - 1e-13 / depth) << "distance " << distance << " depth " << depth;
		}
	}
}

// A shift by the overlap parts the body from the plane, up to second order where it is curved: the rest falls faster than the overlap.
TEST(PlaneContact, LiftingByTheOverlapParts)
{
	RandomBodies random(103);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape(sizes[i % 4]);
		const Matrix3 rotation = random.rotation();
		const double reach = shape.support(rotation.row(2));
		double rest[2];
		for (int k = 0; k < 2; ++k) {
			const double depth = k ? 1e-7 : 1e-5;
			const Contact contact = coldContact(sunk(shape, rotation, depth), Vector3::Zero(), Vector3::UnitZ());
			rest[k] = 1 - contact.overlap / (depth * reach);
			EXPECT_GT(rest[k], -1e-8);
			const Placement lifted { shape, sunk(shape, rotation, depth).position - contact.overlap * (1 + 2 * rest[k] + 1e-8) * contact.normal, rotation };
			EXPECT_EQ(coldContact(lifted, Vector3::Zero(), Vector3::UnitZ()).status, Status::Apart);
		}
		EXPECT_LT(rest[1], 1e-2);
		EXPECT_LT(rest[1], 0.2 * rest[0] + 1e-8);
	}
}

TEST(PlaneContact, OfASphereIsClosedForm)
{
	RandomBodies random(104);
	for (int i = 0; i < 100; ++i) {
		const double size = sizes[i % 4], radius = size * random.uniform(0.1, 2), depth = random.logarithmic(1e-8, 0.9) * radius;
		const Vector3 outward = random.direction(), centre = size * random.direction();
		const Shape sphere(Vector3::Constant(radius), 2, 2);
		const Contact contact = coldContact({ sphere, centre, random.rotation() }, centre - (radius - depth) * outward, outward);
		EXPECT_NEAR(contact.overlap, depth, 1e-14 * (size + radius));
		EXPECT_LT((contact.surface1 - centre + radius * outward).norm(), 1e-14 * (size + radius));
		EXPECT_NEAR(contact.curvature1 * radius, 1, 1e-12);
	}
}

TEST(PlaneContact, IsTheSameAtAllSizes)
{
	RandomBodies random(105);
	for (int i = 0; i < 100; ++i) {
		const Shape unit = random.shape();
		const Matrix3 rotation = i % 2 ? random.rotation() : nearlyFlat(random, random.logarithmic(1e-9, 0.3));
		const double depth = random.logarithmic(1e-8, 0.5);
		const Contact one = coldContact(sunk(unit, rotation, depth), Vector3::Zero(), Vector3::UnitZ());
		for (double size : sizes) {
			const Shape shape(size * unit.halfSizes(), unit.n1(), unit.n2());
			const Contact other = coldContact(sunk(shape, rotation, depth), Vector3::Zero(), Vector3::UnitZ());
			EXPECT_NEAR(other.overlap / (size * one.overlap), 1, 1e-6);
			EXPECT_LT((other.point - size * one.point).norm(), 1e-6 * shape.boundingRadius());
		}
	}
}

// A block turns through the position flat on the plane, sunk by a thousandth: the point moves as on an elastic foundation, by the
// size when the tilt is overlap over size, and neither point nor overlap jumps.
TEST(PlaneContact, TurningThroughFlatMovesThePointContinuously)
{
	for (double n : { 4.0, 8.0, 20.0 }) {
		const Shape block(Vector3(1, 1.5, 0.7), n, n);
		const double sink = 1e-3;
		WarmStart warm;
		SolverCounters counters;
		Contact last;
		const double first = -1e-2, step = 2e-6;
		for (int i = 0; i <= 10000; ++i) {
			const double angle = first + step * i;
			const Placement body { block, Vector3(0, 0, 0.7 - sink), Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix() };
			const Contact contact = contactPlane(body, Vector3::Zero(), Vector3::UnitZ(), warm, counters);
			ASSERT_EQ(contact.status, Status::Overlap);
			if (i > 0) {
				EXPECT_LT((contact.point - last.point).norm(), 1.0 * step / sink);
				EXPECT_LT(std::abs(contact.overlap - last.overlap), 1.5 * step);
			}
			last = contact;
		}
		EXPECT_EQ(counters.fallbacks, 0u);
		EXPECT_LT(counters.iterations, 1.5 * counters.solves);
		// Near flat, on a face that is flat almost to its edges: -theta/(sink + theta x) + 2 x = 0.
		if (n < 8) continue;
		for (double angle : { 0.0, 1e-8, 1e-6, 1e-4 }) {
			const Contact contact = coldContact({ block, Vector3(0, 0, 0.7 - sink), Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix() }, Vector3::Zero(), Vector3::UnitZ());
			EXPECT_NEAR(contact.point.x(), angle / sink / 2, 0.1 * angle / sink + 1e-9) << "n = " << n << ", angle " << angle;
		}
	}
}

TEST(PlaneContact, WarmAndColdAgree)
{
	RandomBodies random(106);
	SolverCounters counters;
	for (int i = 0; i < 300; ++i) {
		const Shape shape = random.shape(sizes[i % 4]);
		Matrix3 rotation = i % 2 ? random.rotation() : nearlyFlat(random, 1e-4);
		const Matrix3 turn = Eigen::AngleAxisd(random.logarithmic(1e-8, 1e-2), random.direction()).toRotationMatrix();
		const double depth = random.logarithmic(1e-6, 0.1);
		WarmStart warm;
		for (int step = 0; step < 10; ++step) {
			rotation = turn * rotation;
			const Placement body = sunk(shape, rotation, depth);
			const Contact contact = contactPlane(body, Vector3::Zero(), Vector3::UnitZ(), warm, counters);
			const Contact cold = coldContact(body, Vector3::Zero(), Vector3::UnitZ());
			EXPECT_NEAR(contact.overlap / cold.overlap, 1, 1e-6);
			EXPECT_LT((contact.point - cold.point).norm(), 1e-6 * shape.boundingRadius());
		}
	}
	EXPECT_EQ(counters.fallbacks, 0u);
	EXPECT_EQ(counters.uncertified, 0u);
}

// Anything goes in: every call ends with a verdict, also with a remembered point that is worth nothing and far behind the plane.
TEST(PlaneContact, EveryCallEndsWithAVerdict)
{
	RandomBodies random(107);
	SolverCounters counters;
	for (int i = 0; i < 100000; ++i) {
		const Shape shape = random.shape(sizes[i % 4]);
		const Matrix3 rotation = i % 3 ? nearlyFlat(random, i % 3 == 1 ? 0 : random.logarithmic(1e-16, 1)) : random.rotation();
		const double reach = shape.support(rotation.row(2));
		const double depth = i % 2 ? random.logarithmic(1e-17, 1) : random.uniform(-0.1, 3);
		const Placement body { shape, Vector3(0, 0, (1 - depth) * reach), rotation };
		WarmStart warm;
		if (i % 5) {
			warm.kind = WarmStart::Point;
			warm.value = random.uniform(0, 1.5) * shape.boundingRadius() * random.direction();
		}
		const Contact contact = contactPlane(body, Vector3::Zero(), Vector3::UnitZ(), warm, counters);
		ASSERT_TRUE(contact.status == Status::Overlap || contact.status == Status::Apart);
		if (std::abs(depth) > 1e-15) { ASSERT_EQ(contact.overlapping(), depth > 0) << depth; }
		if (contact.overlapping()) {
			ASSERT_TRUE(contact.overlap > 0 && std::isfinite(contact.overlap)) << contact.overlap;
			ASSERT_TRUE(contact.surface1.allFinite() && std::isfinite(contact.curvature1));
		}
	}
	EXPECT_EQ(counters.fallbacks, 0u);
	EXPECT_EQ(counters.uncertified, 0u);
}

TEST(PlaneContact, ProvesNothingOfAPlaceThatIsNoNumber)
{
	const Shape cube(Vector3::Ones(), 8, 8);
	WarmStart warm;
	SolverCounters counters;
	const Placement body { cube, Vector3(0, 0, std::numeric_limits<double>::quiet_NaN()), Matrix3::Identity() };
	EXPECT_EQ(contactPlane(body, Vector3::Zero(), Vector3::UnitZ(), warm, counters).status, Status::Uncertified);
	EXPECT_EQ(counters.uncertified, 1u);
}
