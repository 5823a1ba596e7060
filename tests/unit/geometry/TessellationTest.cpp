// Tessellations against what they promise: closed, convex, on the surface, and nowhere farther from it than said. Distances are measured from
// points of the surface to the triangles one by one; volumes against the closed form.
#include <pkg/geometry/MassProperties.hpp>
#include <pkg/geometry/Tessellation.hpp>

#include <tests/support/RandomBodies.hpp>

#include <gtest/gtest.h>

#include <map>
#include <string>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

using Triangle = std::array<Vector3, 3>;

std::vector<Triangle> corners(const Tessellation& mesh)
{
	std::vector<Triangle> result;
	for (const auto& [i, j, k] : mesh.triangles)
		result.push_back({ mesh.points[i], mesh.points[j], mesh.points[k] });
	return result;
}

// Twice the area, along the outward normal.
Vector3 areaVector(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

double volumeInside(const std::vector<Triangle>& triangles)
{
	double result = 0;
	for (const Triangle& t : triangles)
		result += t[0].dot(t[1].cross(t[2])) / 6;
	return result;
}

double areaOf(const std::vector<Triangle>& triangles)
{
	double result = 0;
	for (const Triangle& t : triangles)
		result += areaVector(t).norm() / 2;
	return result;
}

double distanceToSegment(const Vector3& x, const Vector3& from, const Vector3& to)
{
	const Vector3 along = to - from;
	const double place = std::min(1.0, std::max(0.0, along.dot(x - from) / along.squaredNorm()));
	return (x - from - place * along).norm();
}

double distanceToTriangle(const Vector3& x, const Triangle& t)
{
	const Vector3 normal = areaVector(t).normalized();
	bool over = true;
	double result = distanceToSegment(x, t[2], t[0]);
	for (int i = 0; i < 3; ++i) {
		const Vector3 &from = t[i], &to = t[(i + 1) % 3];
		over = over && (to - from).cross(x - from).dot(normal) >= 0;
		result = std::min(result, distanceToSegment(x, from, to));
	}
	return over ? std::abs(normal.dot(x - t[0])) : result;
}

// The largest of the distances from many points of the surface, by direction of the normal and by direction from the centre, to the triangles.
double sampledDistance(const Shape& shape, const std::vector<Triangle>& triangles, RandomBodies& random, int samples)
{
	double result = 0;
	for (int i = 0; i < samples; ++i) {
		const Vector3 direction = random.direction(), scaled = direction.cwiseProduct(shape.halfSizes());
		const Vector3 x = i % 2 ? shape.supportPoint(direction.cwiseQuotient(shape.halfSizes())) : Vector3(scaled / shape.gauge(scaled));
		double nearest = 1e300;
		for (const Triangle& t : triangles)
			nearest = std::min(nearest, distanceToTriangle(x, t));
		result = std::max(result, nearest);
	}
	return result;
}

// Every edge is run through once each way, so the surface is closed and turned one way; Euler's formula makes it one sphere.
void expectClosed(const Tessellation& mesh)
{
	std::map<std::pair<int, int>, int> edges;
	for (const auto& t : mesh.triangles)
		for (int i = 0; i < 3; ++i)
			++edges[{ t[i], t[(i + 1) % 3] }];
	for (const auto& [edge, count] : edges) {
		ASSERT_EQ(count, 1);
		ASSERT_TRUE(edges.count({ edge.second, edge.first }));
	}
	EXPECT_EQ(int(mesh.points.size()) - int(edges.size()) / 2 + int(mesh.triangles.size()), 2);
}

// At every edge the corner across it lies below the triangle (but for rounding), so that the closed surface is convex; no triangle is a
// needle without area.
void expectConvex(const Tessellation& mesh, double size)
{
	std::map<std::pair<int, int>, int> across; // the third corner of the triangle which runs along the edge that way
	for (const auto& t : mesh.triangles)
		for (int i = 0; i < 3; ++i)
			across[{ t[i], t[(i + 1) % 3] }] = t[(i + 2) % 3];
	for (const auto& [edge, corner] : across) {
		const Vector3 &from = mesh.points[edge.first], &to = mesh.points[edge.second];
		const Vector3 area = areaVector({ from, to, mesh.points[corner] });
		ASSERT_GT(area.norm(), 1e-5 * size * (to - from).norm());
		ASSERT_LT(area.normalized().dot(mesh.points[across.at({ edge.second, edge.first })] - from), 1e-12 * size);
	}
}

void expectOnSurface(const Tessellation& mesh, const Shape& shape)
{
	ASSERT_EQ(mesh.normals.size(), mesh.points.size());
	for (std::size_t i = 0; i < mesh.points.size(); ++i) {
		ASSERT_NEAR(shape.gauge(mesh.points[i]), 1, 1e-14);
		ASSERT_NEAR(mesh.normals[i].norm(), 1, 1e-14);
		ASSERT_NEAR(mesh.normals[i].dot(mesh.points[i]), shape.support(mesh.normals[i]), 1e-12 * shape.boundingRadius());
	}
}

// The body lies between the mesh and the mesh thickened by its error, whose volume is Steiner's: with a bound of the mean curvature's integral.
void expectVolume(const Tessellation& mesh, const Shape& shape)
{
	const std::vector<Triangle> triangles = corners(mesh);
	const double inside = volumeInside(triangles), e = mesh.error;
	EXPECT_LT(inside, volume(shape));
	EXPECT_GT(inside + areaOf(triangles) * e + 4 * pi * shape.boundingRadius() * e * e + 4 * pi / 3 * e * e * e, volume(shape));
}

std::string messageFor(double error)
{
	try {
		tessellate(Shape(Vector3(1, 2, 3), 4, 5), error);
	} catch (const std::invalid_argument& refused) {
		return refused.what();
	}
	return "accepted";
}

} // namespace

TEST(Tessellation, OfRandomShapesIsClosedConvexOnTheSurfaceAndOfTheRightVolume)
{
	RandomBodies random(61);
	const double sizes[] = { 1e-6, 1e-3, 1, 10 }, errors[] = { 1, 0.1, 1e-2, 1e-3 };
	for (int i = 0; i < 160; ++i) {
		const Shape shape = random.shape(sizes[i % 4]);
		const double error = errors[i / 4 % 4] * shape.smallestHalfSize();
		const Tessellation mesh = tessellate(shape, error);
		EXPECT_LE(mesh.error, error);
		expectClosed(mesh);
		expectConvex(mesh, shape.boundingRadius());
		expectOnSurface(mesh, shape);
		expectVolume(mesh, shape);
		if (HasFailure()) FAIL() << "half sizes " << shape.halfSizes().transpose() << ", n1 = " << shape.n1() << ", n2 = " << shape.n2() << ", " << error;
	}
}

// The bound holds, and it is sharp: points are found that are nearly as far away.
TEST(Tessellation, ErrorIsTheLargestDistanceFromTheSurface)
{
	RandomBodies random(62);
	double sharpest = 0;
	for (int i = 0; i < 40; ++i) {
		const Shape shape = random.shape(i % 2 ? 1 : 1e-6);
		const Tessellation mesh = tessellate(shape, (i % 4 < 2 ? 0.3 : 0.03) * shape.smallestHalfSize());
		const double measured = sampledDistance(shape, corners(mesh), random, 2000);
		EXPECT_LE(measured, mesh.error);
		EXPECT_GE(measured, 0.4 * mesh.error);
		sharpest = std::max(sharpest, measured / mesh.error);
	}
	EXPECT_GT(sharpest, 0.9);
}

// A sphere cut at equal angles t along both families has the error R (1 - cos(t/2)^2) = R t^2 / 4, so some 2 (pi/t)^2 = pi^2 R / 2 / error points.
TEST(Tessellation, OfASphereTakesAsManyPointsAsItsCurvatureAsks)
{
	for (const double error : { 1e-2, 1e-3, 1e-4 }) {
		const Tessellation mesh = tessellate(Shape(Vector3(1, 1, 1), 2, 2), error);
		EXPECT_NEAR(mesh.points.size() * error / (pi * pi / 2), 1, 0.2);
		EXPECT_GT(mesh.error, 0.8 * error);
	}
}

// Sharp edges take the points: a cube of n = 20 needs fewer than the sphere it holds.
TEST(Tessellation, OfASharpCubeTakesFewPoints)
{
	const Tessellation sphere = tessellate(Shape(Vector3(1, 1, 1), 2, 2), 1e-3), cube = tessellate(Shape(Vector3(1, 1, 1), 20, 20), 1e-3);
	EXPECT_LT(cube.points.size(), sphere.points.size() / 2);
}

TEST(Tessellation, CoarsestIsAnOctahedron)
{
	const Tessellation mesh = tessellate(Shape(Vector3(1, 2, 3), 2, 2), 1e6);
	EXPECT_EQ(mesh.points.size(), 6u);
	EXPECT_EQ(mesh.triangles.size(), 8u);
	EXPECT_LT(mesh.error, 3);
	EXPECT_NEAR(volumeInside(corners(mesh)), 8, 1e-12);
}

TEST(Tessellation, RefusesWhatCannotBe)
{
	for (const double error : { 0.0, -1.0, std::nan(""), HUGE_VAL })
		EXPECT_NE(messageFor(error).find("error must be finite and positive, got"), std::string::npos);
	EXPECT_NE(messageFor(1e-9).find("error must be larger: 1e-09 m takes"), std::string::npos);
	EXPECT_NE(messageFor(5e-324).find("error must be larger"), std::string::npos);
}
