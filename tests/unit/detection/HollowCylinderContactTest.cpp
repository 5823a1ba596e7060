// A body inside a hollow cylinder against the farthest of its surface points from the axis, searched by brute force.
#include <pkg/detection/WallContact.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

struct Container {
	Vector3 origin, axis;
	double radius;
	Vector3 across(const Vector3& x) const { return x - origin - (x - origin).dot(axis) * axis; }
};

Vector3 surfacePoint(const Placement& body, double eta, double omega)
{
	return body.position + body.toWorld(ReferenceShape(body.shape).surfacePoint(eta, omega).cast<double>());
}

// The largest distance from the axis: a grid over the two angles of the surface, the best of it refined by shrinking patterns. With sharp
// edges the angles are drawn together there, where the farthest point mostly is.
double farthestByGrid(const Placement& body, const Container& container, int cells)
{
	struct Candidate {
		double distance, eta, omega;
	};
	const auto at = [&](double eta, double omega) { return Candidate { container.across(surfacePoint(body, eta, omega)).norm(), eta, omega }; };
	std::vector<Candidate> grid;
	for (int i = 0; i <= cells; ++i)
		for (int k = 0; k < 2 * cells; ++k)
			grid.push_back(at(pi * (double(i) / cells - 0.5), pi * (double(k) / cells - 1)));
	std::sort(grid.begin(), grid.end(), [](const Candidate& a, const Candidate& b) { return a.distance > b.distance; });
	double farthest = 0;
	for (int start = 0; start < 8; ++start) {
		Candidate best = grid[start];
		for (double step = pi / cells; step > 1e-13; step /= 2)
			for (bool better = true; better;) {
				better = false;
				for (int direction = 0; direction < 8; ++direction) {
					const Candidate next = at(best.eta + step * std::cos(direction * pi / 4), best.omega + step * std::sin(direction * pi / 4));
					if (next.distance <= best.distance) continue;
					best = next;
					better = true;
				}
			}
		farthest = std::max(farthest, best.distance);
	}
	return farthest;
}

Contact coldContact(const Placement& body, const Vector3& origin, const Vector3& axis, double radius)
{
	WarmStart warm;
	SolverCounters counters;
	const Contact contact = contactHollowCylinder(body, origin, axis, radius, warm, counters);
	EXPECT_EQ(counters.uncertified, 0u);
	return contact;
}

void expectContract(const Contact& contact, const Placement& body, const Container& container)
{
	const double blur = 1e-12 * container.radius;
	EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
	EXPECT_NEAR(contact.normal.dot(container.axis), 0, 1e-12);
	EXPECT_NEAR(contact.overlap, (contact.surface1 - contact.surface2).dot(contact.normal), blur);
	EXPECT_NEAR(container.across(contact.surface2).norm(), container.radius, blur);
	EXPECT_NEAR(container.across(contact.surface1).norm(), container.radius + contact.overlap, blur);
	EXPECT_GT(container.across(contact.surface1).dot(contact.normal), 0);
	const Vector3 own = body.toBody(contact.surface1 - body.position);
	EXPECT_NEAR(std::pow(ReferenceShape(body.shape).function(own), 1 / Real(body.shape.n1())), 1, 1e-11);
	EXPECT_LE(contact.lower, contact.upper * (1 + 1e-15));
}

} // namespace

TEST(HollowCylinderContact, AgainstBruteForce)
{
	RandomBodies random(111);
	for (int i = 0; i < 80; ++i) {
		const double scale = i % 4 == 3 ? 1e-3 : 1;
		const Shape shape = random.shape(scale * random.logarithmic(0.02, 0.5));
		const Container container { scale * random.direction(), random.direction(), scale };
		// Anywhere from the axis to the wall; every fifth on the axis.
		const double away = i % 5 ? random.uniform(0, 1.2) * scale : 0;
		const Vector3 outwards = container.axis.cross(random.direction()).normalized();
		const Placement body { shape, container.origin + away * outwards + scale * random.uniform(-2, 2) * container.axis, random.rotation() };
		const double farthest = farthestByGrid(body, container, 40);
		const Contact contact = coldContact(body, container.origin, container.axis, container.radius);
		const double tolerance = 1e-9 * shape.boundingRadius() + 1e-13 * scale;
		if (contact.status == Status::Overlap) {
			EXPECT_NEAR(contact.overlap, farthest - container.radius, tolerance) << "n " << shape.n1() << " " << shape.n2();
			expectContract(contact, body, container);
		} else {
			ASSERT_EQ(contact.status, Status::Apart);
			EXPECT_LE(farthest, container.radius + tolerance);
		}
	}
}

// At the contact the body's normal is radial, as eq. (4) asks: the gradients of F_i and F_w are parallel.
TEST(HollowCylinderContact, NormalsAgree)
{
	RandomBodies random(112);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape(0.1);
		const Container container { random.direction(), random.direction(), 1 };
		const Vector3 outwards = container.axis.cross(random.direction()).normalized();
		const Placement body { shape, container.origin + (1 - 0.9 * shape.smallestHalfSize()) * outwards, random.rotation() };
		const Contact contact = coldContact(body, container.origin, container.axis, container.radius);
		ASSERT_EQ(contact.status, Status::Overlap);
		expectContract(contact, body, container);
		const RealVector own = body.toBody(contact.surface1 - body.position).cast<Real>();
		const Vector3 normal = body.toWorld(ReferenceShape(shape).normal(own).cast<double>());
		EXPECT_LT((normal - contact.normal).norm(), 1e-4) << "n " << shape.n1() << " " << shape.n2();
	}
}

TEST(HollowCylinderContact, OfASphereIsClosedForm)
{
	RandomBodies random(113);
	for (double size : { 1e-6, 1e-3, 1.0, 10.0 })
		for (int i = 0; i < 100; ++i) {
			const double radius = size * random.uniform(0.01, 0.95), away = size - radius * random.uniform(0.9, 1.1);
			const Container container { size * random.direction(), random.direction(), size };
			const Vector3 outwards = container.axis.cross(random.direction()).normalized();
			const Shape sphere(Vector3::Constant(radius), 2, 2);
			const Placement body { sphere, container.origin + away * outwards + size * container.axis, random.rotation() };
			const Contact contact = coldContact(body, container.origin, container.axis, container.radius);
			const double overlap = std::abs(away) + radius - size; // away < 0: beyond the axis
			ASSERT_EQ(contact.status, overlap > 0 ? Status::Overlap : Status::Apart);
			EXPECT_NEAR(contact.overlap, overlap, 1e-12 * size);
			if (overlap < 0) continue;
			const Vector3 normal = away > 0 ? outwards : Vector3(-outwards);
			EXPECT_LT((contact.normal - normal).norm(), 1e-6);
			EXPECT_LT((contact.surface1 - body.position - radius * normal).norm(), 1e-6 * size);
			EXPECT_NEAR(contact.curvature1 * radius, 1, 1e-6);
		}
}

// A flat side laid along the wall touches with both its edges: the farther one after the smallest turn, with the same overlap.
TEST(HollowCylinderContact, FlatFaceAlongTheWall)
{
	for (double n : { 8.0, 20.0 }) {
		const Shape block(Vector3(0.1, 0.1, 0.1), n, n);
		const Container container { Vector3::Zero(), Vector3::UnitZ(), 1 };
		for (double angle : { 0.0, 1e-6, -1e-6, 1e-3, pi / 4 }) {
			const Placement body { block, Vector3(0.9, 0, 0), Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix() };
			const Contact contact = coldContact(body, container.origin, container.axis, container.radius);
			const double farthest = farthestByGrid(body, container, 60);
			EXPECT_NEAR(contact.overlap, farthest - 1, 1e-11) << "n = " << n << ", angle " << angle;
			EXPECT_EQ(contact.status, farthest > 1 ? Status::Overlap : Status::Apart);
		}
	}
}

TEST(HollowCylinderContact, BodiesNearlyAsBigAsTheContainer)
{
	RandomBodies random(114);
	for (int i = 0; i < 30; ++i) {
		// A plug: its axis nearly the container's, with or without play.
		const double n2 = i % 4 ? random.uniform(2, 4) : 2;
		const Shape plug(Vector3(random.uniform(0.99, 1.001), random.uniform(0.99, 1.001), random.uniform(0.2, 2)), random.uniform(2, 20), n2);
		const Container container { Vector3::Zero(), Vector3::UnitZ(), 1 };
		const Matrix3 tilt = Eigen::AngleAxisd(0.01 * random.uniform(), random.direction()).toRotationMatrix();
		const Placement body { plug, 0.002 * random.uniform() * random.direction(), tilt };
		const Contact contact = coldContact(body, container.origin, container.axis, container.radius);
		// The search ends once nothing can reach the wall; the distance to it is then a bound.
		const double overlap = farthestByGrid(body, container, 60) - 1;
		EXPECT_EQ(contact.status, overlap > 0 ? Status::Overlap : Status::Apart);
		if (contact.overlapping())
			EXPECT_NEAR(contact.overlap, overlap, std::max(1e-8, 0.0101 * overlap)) << "n " << plug.n1() << " " << plug.n2();
		else
			EXPECT_LE(contact.overlap, overlap + 1e-12);
		EXPECT_GE(contact.upper - contact.lower, 0);
		if (contact.overlapping()) expectContract(contact, body, container);
	}
}

// Every direction is as good where a round body sits on the axis; it must still be one, and the bound must hold.
TEST(HollowCylinderContact, RoundBodyOnTheAxis)
{
	for (double radius : { 0.5, 0.999, 1.0, 1.001 }) {
		const Shape drum(Vector3(radius, radius, 0.3), 8, 2);
		const Contact contact = coldContact(Placement { drum, Vector3::Zero(), Matrix3::Identity() }, Vector3::Zero(), Vector3::UnitZ(), 1);
		if (radius != 1) { EXPECT_EQ(contact.status, radius > 1 ? Status::Overlap : Status::Apart); } // at 1 rounding decides
		if (radius > 0.9) { EXPECT_NEAR(contact.overlap, radius - 1, 1e-12); }
		EXPECT_GE(1 / contact.lower, radius * (1 - 1e-15)); // the bound's looseness may grow here, not its truth
		EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
		EXPECT_NEAR(contact.normal.z(), 0, 1e-12);
	}
}

// What the header promises of the bounds, on the bodies that make it hard.
TEST(HollowCylinderContact, BoundsTheFarthestPointWithinTheTolerance)
{
	RandomBodies random(115);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape(random.logarithmic(0.05, 0.8));
		const Container container { Vector3::Zero(), random.direction(), 1 };
		const Placement body { shape, random.uniform() * container.axis.unitOrthogonal(), random.rotation() };
		const Contact contact = coldContact(body, container.origin, container.axis, container.radius);
		if (!contact.overlapping()) continue;
		const double farthest = container.radius / contact.upper, bound = container.radius / contact.lower;
		EXPECT_LE(bound - farthest, std::max(1.01e-10 * shape.boundingRadius() + 1e-15, 0.0101 * contact.overlap)) << "n " << shape.n1() << " " << shape.n2();
	}
}

// What is remembered changes the answer by no more than the stated share, and every call ends with a verdict.
TEST(HollowCylinderContact, WarmAndColdAgree)
{
	RandomBodies random(116);
	SolverCounters counters;
	int overlaps = 0;
	for (int i = 0; i < 300; ++i) {
		const double scale = i % 4 == 3 ? 1e-6 : (i % 4 == 2 ? 10 : 1);
		const Shape shape = random.shape(scale * random.logarithmic(0.02, 0.5));
		const Vector3 axis = random.direction(), outwards = axis.unitOrthogonal();
		const Matrix3 turn = Eigen::AngleAxisd(random.logarithmic(1e-8, 1e-2), random.direction()).toRotationMatrix();
		Matrix3 rotation = random.rotation();
		WarmStart warm;
		for (int step = 0; step < 20; ++step) {
			rotation = turn * rotation;
			const Placement body { shape, (scale - random.uniform(0.8, 1.1) * shape.boundingRadius()) * outwards, rotation };
			const Contact contact = contactHollowCylinder(body, Vector3::Zero(), axis, scale, warm, counters), cold = coldContact(body, Vector3::Zero(), axis, scale);
			if (!cold.overlapping() && !contact.overlapping()) continue;
			++overlaps;
			EXPECT_NEAR(contact.overlap, cold.overlap, 0.0101 * cold.overlap + 1e-9 * shape.boundingRadius());
		}
	}
	EXPECT_GT(overlaps, 300);
	EXPECT_EQ(counters.uncertified, 0u);
}
