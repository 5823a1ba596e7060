// The parts of bodies in a region: boxes as half spaces and as surfaces agree, what is not convex adds up, and bounds hold where the answer is known.
#include <pkg/geometry/MassProperties.hpp>
#include <pkg/mesh/SolidVolume.hpp>

#include <tests/support/Meshes.hpp>
#include <tests/support/RandomBodies.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr double accuracy = 0.02;

std::vector<HalfSpace> halfSpacesOf(const Vector3& low, const Vector3& high)
{
	std::vector<HalfSpace> result;
	for (int axis = 0; axis < 3; ++axis) {
		result.push_back({ Vector3::Unit(axis), high[axis] });
		result.push_back({ -Vector3::Unit(axis), -low[axis] });
	}
	return result;
}

// Bodies of a few shapes, in and around the cube [-1, 1]^3.
struct Bodies {
	std::vector<Shape> shapes;
	std::vector<Placement> placed;

	Bodies(std::uint64_t seed, int number)
	{
		RandomBodies random(seed);
		for (int i = 0; i < 10; ++i)
			shapes.push_back(random.shape(0.3));
		for (int i = 0; i < number; ++i)
			placed.emplace_back(shapes[std::size_t(i % 10)],
			        Vector3(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)), random.rotation());
	}
};

void expectAlike(const SolidVolume& one, const SolidVolume& other, double scale)
{
	EXPECT_NEAR(one.low, other.low, 1e-12 * scale);
	EXPECT_NEAR(one.high, other.high, 1e-12 * scale);
}

} // namespace

TEST(Region, BoxAsHalfSpacesAndAsSurface)
{
	const Bodies bodies(3, 200);
	const Vector3 low(-1, -0.8, -0.6), high(0.9, 1, 0.7);
	for (bool inward : { false, true }) {
		const TriangleMesh surface = inward ? turned(box(low, high)) : box(low, high);
		const MeshRegion mesh(surface, "box");
		EXPECT_NEAR(mesh.volume(), (high - low).prod(), 1e-14);
		const auto fromPlanes = volumesWithin(bodies.placed, ConvexRegion(halfSpacesOf(low, high)), accuracy),
		           fromMesh = volumesWithin(bodies.placed, mesh, accuracy);
		int cut = 0;
		for (std::size_t i = 0; i < bodies.placed.size(); ++i) {
			const double whole = volume(bodies.placed[i].shape);
			// A body whose box alone touches the surface is cut for the one and whole for the other.
			EXPECT_NEAR(fromMesh[i].estimate, fromPlanes[i].estimate, 1e-12 * whole);
			cut += fromPlanes[i].estimate > 0.01 * whole && fromPlanes[i].estimate < 0.99 * whole;
		}
		EXPECT_GT(cut, 50);
	}
}

TEST(Region, StarAndTheRestOfTheBoxAddUp)
{
	const Bodies bodies(4, 150);
	const Vector3 corner(1.2, 1.2, 1.1);
	const TriangleMesh inner = star(1.1, 0.5, 5, -0.8, 0.9), outer = box(-corner, corner);
	const MeshRegion star(inner, "star"), rest(together(outer, turned(inner)), "box with a cavity"), whole(outer, "box");
	EXPECT_NEAR(star.volume() + rest.volume(), whole.volume(), 1e-13);
	const auto inStar = volumesWithin(bodies.placed, star, accuracy), inRest = volumesWithin(bodies.placed, rest, accuracy),
	           inBox = volumesWithin(bodies.placed, whole, accuracy);
	for (std::size_t i = 0; i < bodies.placed.size(); ++i)
		EXPECT_NEAR(inStar[i].estimate + inRest[i].estimate, inBox[i].estimate, 1e-12 * volume(bodies.placed[i].shape)) << i;
}

TEST(Region, ContainsPoints)
{
	const MeshRegion region(star(2, 1, 5, 0, 1), "star");
	EXPECT_TRUE(region.contains(Vector3(1.9, 0, 0.5)));
	EXPECT_FALSE(region.contains(Vector3(-1.9, 0, 0.5)));
	EXPECT_FALSE(region.contains(Vector3(1.9, 0, 1.5)));
	EXPECT_TRUE(region.contains(Vector3(0, 0, 1)));
}

TEST(Region, BodiesInsideAndOutsideAreExact)
{
	const Shape shape(Vector3(0.1, 0.2, 0.3), 8, 3);
	const std::vector<Placement> bodies { { shape, Vector3::Zero(), Matrix3::Identity() }, { shape, Vector3(3, 0, 0), Matrix3::Identity() } };
	const Vector3 half(1, 1, 1);
	const MeshRegion mesh(box(-half, half), "box");
	const ConvexRegion convex(halfSpacesOf(-half, half));
	for (const Region* region : { static_cast<const Region*>(&mesh), static_cast<const Region*>(&convex) }) {
		const auto found = volumesWithin(bodies, *region, accuracy);
		expectAlike(found[0], { volume(shape), volume(shape), volume(shape) }, 0);
		expectAlike(found[1], { 0, 0, 0 }, 0);
	}
}

TEST(Region, BoundsHoldForHalvesAndCaps)
{
	// Half of any superquadric that is cut through its centre; caps of a sphere.
	RandomBodies random(6);
	for (int i = 0; i < 100; ++i) {
		const Shape shape = random.shape();
		const std::vector<Placement> body { { shape, Vector3(1, 2, 3), random.rotation() } };
		const Vector3 normal = random.rotation().col(0);
		const SolidVolume half = volumesWithin(body, ConvexRegion({ { normal, normal.dot(body[0].position) } }), accuracy)[0];
		EXPECT_LE(half.low, volume(shape) / 2);
		EXPECT_GE(half.high, volume(shape) / 2);
		EXPECT_NEAR(half.estimate, volume(shape) / 2, 1e-12 * volume(shape));
	}
	const Shape ball(Vector3::Constant(2), 2, 2);
	const std::vector<Placement> body { { ball, Vector3::Zero(), Matrix3::Identity() } };
	for (double height : { 0.1, 1.0, 2.5, 3.9 }) {
		const double exact = pi * height * height * (6 - height) / 3;
		const SolidVolume cap = volumesWithin(body, ConvexRegion({ { Vector3(0.6, 0, 0.8), height - 2 } }), accuracy)[0];
		EXPECT_LE(cap.low, exact);
		EXPECT_GE(cap.high, exact);
		EXPECT_NEAR(cap.estimate, exact, 0.02 * volume(ball));
	}
}

TEST(Region, SurfaceThatBoundsNothingIsRefused)
{
	TriangleMesh open = box(Vector3::Zero(), Vector3::Ones());
	open.triangles.pop_back();
	EXPECT_THROW(MeshRegion(open, "open"), std::invalid_argument);
}
