// Triangles against a brute-force search over the triangle.
#include <pkg/detection/WallContact.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

using Triangle = std::array<Vector3, 3>;

const double sizes[] = { 1e-6, 1e-3, 1.0, 10.0 };

// f^(1/n1) of eq. (1).
double gaugeAt(const Placement& body, const Vector3& x)
{
	const ReferenceShape reference(body.shape);
	return double(std::pow(reference.function(body.toBody(x - body.position)), 1 / reference.n1));
}

Vector3 pointOf(const Triangle& v, double s, double t) { return v[0] + s * (v[1] - v[0]) + t * (v[2] - v[0]); }

// What the contact centre minimises; outside the body it goes on with the gauge, higher than anywhere inside.
double objectiveAt(const Placement& body, const Vector3& x)
{
	const double gauge = gaugeAt(body, x);
	return gauge < 1 ? -std::log(1 - gauge) + body.toBody(x - body.position).cwiseQuotient(body.shape.halfSizes()).squaredNorm() : 100 * gauge;
}

// The smallest value on the triangle of what has one valley: nested golden sections.
template <class Function> double smallestOn(const Triangle& v, const Function& function)
{
	const auto bestAlong = [&](Real s) {
		const auto negative = [&](Real t) { return -function(pointOf(v, double(s), double(t))); };
		return negative(largestAt(negative, 0, 1 - s));
	};
	return -double(bestAlong(largestAt(bestAlong, 0, 1)));
}

Triangle randomTriangle(RandomBodies& random, double size)
{
	Triangle v { size * random.direction(), size * random.direction(), size * random.direction() };
	while ((v[1] - v[0]).cross(v[2] - v[0]).norm() < 0.1 * size * size)
		v[2] = size * random.direction();
	return v;
}

Contact coldContact(const Placement& body, const Triangle& v)
{
	WarmStart warm;
	SolverCounters counters;
	const Contact contact = contactTriangle(body, v, warm, counters);
	EXPECT_EQ(counters.uncertified, 0u);
	EXPECT_EQ(counters.fallbacks, 0u);
	return contact;
}

// Against the plane z = 0.
Contact coldPlane(const Placement& body)
{
	WarmStart warm;
	SolverCounters counters;
	return contactPlane(body, Vector3::Zero(), Vector3::UnitZ(), warm, counters);
}

double distanceFrom(const Triangle& v, const Vector3& x)
{
	const Vector3 normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
	double outside = 0;
	for (int i = 0; i < 3; ++i)
		outside = std::max(outside, -(x - v[i]).dot(normal.cross(v[(i + 1) % 3] - v[i]).normalized()));
	return std::max(std::abs((x - v[0]).dot(normal)), outside);
}

} // namespace

TEST(TriangleContact, AgainstBruteForce)
{
	RandomBodies random(103);
	int overlaps = 0, aparts = 0;
	for (int i = 0; i < 100; ++i) {
		const double size = sizes[i % 4];
		const Shape shape = random.shape(size * random.logarithmic(0.1, 2));
		const Triangle v = randomTriangle(random, size);
		const Vector3 middle = (v[0] + v[1] + v[2]) / 3;
		const Placement body { shape, middle + size * random.uniform(0, 1.5) * random.direction(), random.rotation() };
		const double g = smallestOn(v, [&](const Vector3& x) { return gaugeAt(body, x); });
		if (std::abs(g - 1) < 1e-9) continue;
		const Contact contact = coldContact(body, v);
		ASSERT_EQ(contact.status, g < 1 ? Status::Overlap : Status::Apart) << "smallest gauge " << g;
		(g < 1 ? overlaps : aparts)++;
		if (contact.status == Status::Apart) {
			EXPECT_LE(contact.lower, g * (1 + 1e-12)); // may be the plane's, which is below
			EXPECT_GT(contact.lower, 1);
			// The plane through the body's deepest point leaves all three vertices on the other side.
			const double reach = double(ReferenceShape(shape).searchedSupport(body.toBody(contact.normal)));
			for (const Vector3& vertex : v)
				EXPECT_GT((vertex - body.position).dot(contact.normal), reach * (1 - 1e-13));
			continue;
		}
		EXPECT_NEAR(gaugeAt(body, contact.point), contact.upper, 1e-9);
		const double objective = smallestOn(v, [&](const Vector3& x) { return objectiveAt(body, x); });
		EXPECT_NEAR(objectiveAt(body, contact.point), objective, 1e-8);
		EXPECT_LT(distanceFrom(v, contact.point), 1e-12 * size);
		EXPECT_NEAR(gaugeAt(body, contact.surface1), 1, 1e-11);
		EXPECT_NEAR(contact.normal.norm(), 1, 1e-13);
		EXPECT_LT((contact.surface1 - contact.surface2 - contact.overlap * contact.normal).norm(), 1e-12 * size);
		EXPECT_LT((body.position - middle).dot(contact.normal), shape.boundingRadius() + size); // finite
		EXPECT_LT((body.position - contact.point).dot(contact.normal), 0); // pushes towards the centre's side
	}
	EXPECT_GT(overlaps, 20);
	EXPECT_GT(aparts, 20);
}

// A body carried over face, edge and vertex, and back: overlap, normal and point follow without jumps.
TEST(TriangleContact, IsContinuousOverFaceEdgeAndVertex)
{
	const Triangle v { Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(0, 2, 0) };
	RandomBodies random(104);
	for (int i = 0; i < 8; ++i) {
		const Shape shape(Vector3(random.uniform(0.4, 1), random.uniform(0.4, 1), random.uniform(0.4, 1)), random.uniform(2, 4), random.uniform(2, 4));
		const Matrix3 rotation = random.rotation();
		Contact last;
		for (int step = 0; step <= 20000; ++step) {
			// From over the face out across an edge (y < 0), then along it around the vertex at the origin.
			const double s = 2e-4 * step;
			const Vector3 path = s < 2 ? Vector3(0.6, 0.6 - 0.4 * s, 0.25) : Vector3(0.6 - 0.4 * (s - 2), -0.2, 0.25);
			const Contact contact = coldContact(Placement { shape, path, rotation }, v);
			if (!contact.overlapping()) break;
			if (step > 0) {
				EXPECT_NEAR(contact.overlap, last.overlap, 1e-3);
				EXPECT_LT((contact.normal - last.normal).norm(), 2e-2);
				EXPECT_LT((contact.point - last.point).norm(), 2e-2);
			}
			last = contact;
		}
	}
}

// Meeting the edge from inside, where the plane's closed form ends: both formulas give the same contact there.
TEST(TriangleContact, TheFormulasOfFaceAndEdgeAgreeOnTheEdge)
{
	RandomBodies random(105);
	for (int i = 0; i < 100; ++i) {
		const Shape shape = random.shape(0.5);
		const Matrix3 rotation = random.rotation();
		const Placement body { shape, Vector3(0, 0, 0.9 * shape.support(rotation.row(2))), rotation };
		const Vector3 deepest = coldPlane(body).point;
		for (double shift : { -1e-13, 1e-13 }) {
			const Triangle v { deepest + Vector3(-3, shift, 0), deepest + Vector3(3, shift, 0), deepest + Vector3(0, 5, 0) };
			const Contact contact = coldContact(body, v), plane = coldPlane(body);
			EXPECT_NEAR(contact.overlap, plane.overlap, 1e-10);
			EXPECT_LT((contact.normal - plane.normal).norm(), 1e-5);
			EXPECT_LT((contact.surface1 - plane.surface1).norm(), 1e-5);
			EXPECT_NEAR(contact.curvature1, plane.curvature1, 1e-4 * (1 + plane.curvature1));
		}
	}
}

// A sheet: from below it pushes down; vertices may come in any order.
TEST(TriangleContact, ActsOnBothSidesInAnyOrderOfItsVertices)
{
	RandomBodies random(106);
	for (int i = 0; i < 100; ++i) {
		const Shape shape = random.shape(0.3);
		const Triangle v = randomTriangle(random, 1), turned { v[2], v[0], v[1] }, reversed { v[1], v[0], v[2] };
		const Placement body { shape, (v[0] + v[1] + v[2]) / 3 + 0.3 * random.direction(), random.rotation() };
		const Contact contact = coldContact(body, v);
		for (const Triangle& other : { turned, reversed }) {
			const Contact same = coldContact(body, other);
			ASSERT_EQ(same.status, contact.status);
			if (!contact.overlapping()) continue;
			EXPECT_NEAR(same.overlap, contact.overlap, 1e-10);
			EXPECT_LT((same.normal - contact.normal).norm(), 1e-6);
		}
	}
}

TEST(TriangleContact, SphereOnAnEdgeAndOnAVertex)
{
	const Triangle v { Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(0, 2, 0) };
	const Shape sphere(Vector3::Constant(0.5), 2, 2);
	const Contact edge = coldContact(Placement { sphere, Vector3(1, -0.24, 0.32), Matrix3::Identity() }, v);
	EXPECT_NEAR(edge.overlap, 0.1, 1e-14);
	EXPECT_LT((edge.normal - Vector3(0, 0.6, -0.8)).norm(), 1e-14);
	const Contact vertex = coldContact(Placement { sphere, Vector3(-0.1, -0.2, 0.2), Matrix3::Identity() }, v);
	EXPECT_NEAR(vertex.overlap, 0.2, 1e-14);
	EXPECT_LT((vertex.normal - Vector3(1, 2, -2) / 3).norm(), 1e-14);
	// With the centre on the edge there is no side; any unit normal will do, but none that is not a number.
	for (const Vector3& centre : { Vector3(1, 0, 0), Vector3(0, 0, 0), Vector3(2.0 / 3, 4.0 / 3, 0), Vector3(0.1, 1.9, 0) }) {
		const Contact within = coldContact(Placement { sphere, centre, Matrix3::Identity() }, v);
		EXPECT_EQ(within.status, Status::Overlap);
		EXPECT_NEAR(within.normal.norm(), 1, 1e-12) << centre.transpose();
		EXPECT_TRUE(std::isfinite(within.overlap)) << centre.transpose();
	}
}

// A small grain on a large facet, as in a mesh of a machine.
TEST(TriangleContact, GrainsFarSmallerThanTheTriangle)
{
	RandomBodies random(107);
	for (int i = 0; i < 200; ++i) {
		const Triangle v = randomTriangle(random, 1);
		const double along = random.uniform(0.1, 0.9);
		const Vector3 onEdge = v[0] + along * (v[1] - v[0]), outwards = ((v[1] - v[0]).cross(v[2] - v[0])).cross(v[1] - v[0]).normalized();
		const Shape shape = random.shape(1e-4);
		const Matrix3 rotation = random.rotation();
		const Placement body { shape, onEdge - outwards * 0.9999 * shape.smallestHalfSize(), rotation };
		EXPECT_EQ(coldContact(body, v).status, Status::Overlap);
		const Placement far { shape, onEdge - outwards * 1.0001 * shape.boundingRadius(), rotation };
		EXPECT_EQ(coldContact(far, v).status, Status::Apart);
	}
}
