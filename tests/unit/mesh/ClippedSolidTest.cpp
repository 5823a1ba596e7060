// Volumes of cut solids against closed forms, and against what must add up.
#include <pkg/geometry/Tessellation.hpp>
#include <pkg/mesh/ClippedSolid.hpp>

#include <tests/support/Meshes.hpp>
#include <tests/support/RandomBodies.hpp>

#include <gtest/gtest.h>

#include <algorithm>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

ClippedSolid solidOf(const TriangleMesh& mesh) { return { mesh.points, mesh.triangles, Matrix3::Identity() }; }
ClippedSolid unitCube() { return solidOf(box(Vector3::Zero(), Vector3::Ones())); }

double cut(ClippedSolid solid, const std::vector<HalfSpace>& halfSpaces)
{
	for (const HalfSpace& halfSpace : halfSpaces)
		solid.clip(halfSpace);
	return solid.volume();
}

HalfSpace randomHalfSpace(RandomBodies& random, double reach)
{
	return { random.rotation().col(0), random.uniform(-reach, reach) };
}

// Irwin & Hall: the part of the unit cube with x + y + z <= s.
double cubeCorner(double s)
{
	const auto cubed = [](double x) { return x > 0 ? x * x * x : 0; };
	return (cubed(s) - 3 * cubed(s - 1) + 3 * cubed(s - 2)) / 6;
}

} // namespace

TEST(ClippedSolid, CornerOfACube)
{
	for (double s : { -0.1, 0.0, 0.2, 1.0, 1.3, 1.5, 2.0, 2.9, 3.0, 3.5 })
		EXPECT_NEAR(cut(unitCube(), { { Vector3::Ones() / std::sqrt(3), s / std::sqrt(3) } }), s < 3 ? cubeCorner(s) : 1, 1e-15) << s;
}

TEST(ClippedSolid, PlanesThroughFacesEdgesAndCornersOfACube)
{
	for (int axis = 0; axis < 3; ++axis)
		for (double sign : { 1.0, -1.0 })
			for (double at : { 0.0, 0.5, 1.0 })
				EXPECT_EQ(cut(unitCube(), { { sign * Vector3::Unit(axis), sign * at } }), sign > 0 ? at : 1 - at);
	const Vector3 edge = Vector3(1, -1, 0).normalized();
	EXPECT_NEAR(cut(unitCube(), { { edge, 0 } }), 0.5, 1e-15);
	EXPECT_NEAR(cut(unitCube(), { { edge, 0 }, { -edge, 0 } }), 0, 1e-15);
	EXPECT_NEAR(cut(unitCube(), { { edge, 0 }, { Vector3(0, 1, -1).normalized(), 0 } }), 1.0 / 6, 1e-15);
}

TEST(ClippedSolid, WedgeOfACylinder)
{
	// By the plane through a diameter of the base, 45 degrees up: 2/3 r^3. The polygon of N sides has sin(x)/x of the circle's area, x = 2 pi/N.
	const int sides = 2000;
	const ClippedSolid cylinder = solidOf(star(1, 1, sides / 2, 0, 2));
	const double x = 2 * pi / sides, wedge = cut(cylinder, { { Vector3(-1, 0, 1).normalized(), 0 } });
	EXPECT_NEAR(cylinder.volume(), 2 * pi * std::sin(x) / x, 1e-12);
	EXPECT_LT(wedge, 2.0 / 3);
	EXPECT_GT(wedge, 2.0 / 3 - 2 * pi * (1 - std::sin(x) / x));
}

TEST(ClippedSolid, CapsOfEllipsoids)
{
	const Vector3 sizes(1, 2, 0.5);
	const Tessellation tessellation = tessellate(Shape(sizes, 2, 2), 1e-3);
	const ClippedSolid ellipsoid(tessellation.points, tessellation.triangles, Matrix3::Identity());
	const double missing = 4 * pi / 3 * sizes.prod() - ellipsoid.volume();
	RandomBodies random(5);
	for (int i = 0; i < 50; ++i) {
		const HalfSpace halfSpace = randomHalfSpace(random, 0.6);
		// The affine map to the unit ball takes the plane to one at this distance from the centre.
		const double distance = halfSpace.offset / sizes.cwiseProduct(halfSpace.normal).norm(), height = std::clamp(1 + distance, 0.0, 2.0);
		const double exact = sizes.prod() * pi * height * height * (3 - height) / 3, found = cut(ellipsoid, { halfSpace });
		EXPECT_LE(found, exact + 1e-13);
		EXPECT_GE(found, exact - missing - 1e-13);
	}
}

TEST(ClippedSolid, PartsAddUpAndOrderDoesNotMatter)
{
	RandomBodies random(7);
	for (int i = 0; i < 300; ++i) {
		const Shape shape = random.shape();
		const Tessellation tessellation = tessellate(shape, 0.05 * shape.smallestHalfSize());
		const ClippedSolid solid(tessellation.points, tessellation.triangles, random.rotation());
		std::vector<HalfSpace> halfSpaces;
		for (int k = 0; k < 4; ++k)
			halfSpaces.push_back(randomHalfSpace(random, shape.smallestHalfSize()));
		const double part = cut(solid, halfSpaces), tolerance = 1e-13 * shape.halfSizes().prod();
		std::reverse(halfSpaces.begin(), halfSpaces.end());
		EXPECT_NEAR(cut(solid, halfSpaces), part, tolerance);
		const HalfSpace last = halfSpaces.back();
		halfSpaces.pop_back();
		const double whole = cut(solid, halfSpaces);
		halfSpaces.push_back({ -last.normal, -last.offset });
		EXPECT_NEAR(cut(solid, halfSpaces) + part, whole, tolerance);
	}
}

TEST(ClippedSolid, ManyNearlyEqualPlanes)
{
	// Each leaves slivers of the one before, and polygons that lie in the next plane to rounding.
	RandomBodies random(11);
	const Tessellation tessellation = tessellate(Shape(Vector3(1, 1, 1), 8, 8), 0.02);
	for (int i = 0; i < 100; ++i) {
		const ClippedSolid solid(tessellation.points, tessellation.triangles, random.rotation());
		const HalfSpace first = randomHalfSpace(random, 0.7);
		ClippedSolid once = solid, often = solid;
		once.clip(first);
		for (int k = 0; k < 20; ++k) {
			const Vector3 tilted = (first.normal + 1e-15 * random.rotation().col(0)).normalized();
			often.clip({ tilted, first.offset + random.uniform(-1e-15, 1e-15) });
		}
		EXPECT_NEAR(often.volume(), once.volume(), 1e-12);
	}
}
