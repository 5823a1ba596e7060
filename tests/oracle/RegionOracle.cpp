// Solid in a region against two independent methods: Monte Carlo with the shapes themselves, whose standard error is known; and for the tessellations
// CGAL's corefinement, which cuts surface with surface.
#include <pkg/geometry/MassProperties.hpp>
#include <pkg/geometry/Tessellation.hpp>
#include <pkg/mesh/SolidVolume.hpp>

#include <tests/support/Meshes.hpp>
#include <tests/support/RandomBodies.hpp>

#define CGAL_DISABLE_GMP 1
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <functional>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr double accuracy = 1e-2;

struct Bed {
	std::vector<Shape> shapes;
	std::vector<Placement> bodies;

	Bed(std::uint64_t seed, int number)
	{
		RandomBodies random(seed);
		for (int i = 0; i < 5; ++i)
			shapes.push_back(random.shape(0.25));
		for (int i = 0; i < number; ++i)
			bodies.emplace_back(shapes[std::size_t(i % 5)],
			        1.2 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)), random.rotation());
	}
};

struct Sampled {
	double volume = 0, variance = 0;
};

// Points drawn uniformly from the box of every body count where they are in both body and region.
Sampled sample(const Bed& bed, const std::function<bool(const Vector3&)>& within)
{
	constexpr int points = 20000;
	RandomBodies random(99);
	Sampled sum;
	for (const Placement& body : bed.bodies) {
		const Vector3 half = body.shape.halfSizes();
		int hits = 0;
		for (int i = 0; i < points; ++i) {
			const Vector3 local = half.cwiseProduct(Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
			hits += body.shape.gauge(local) <= 1 && within(body.position + body.rotation * local);
		}
		const double share = double(hits) / points, box = 8 * half.prod();
		sum.volume += box * share;
		sum.variance += box * box * share * (1 - share) / points;
	}
	return sum;
}

void expectWithinMonteCarlo(const Region& region, const std::function<bool(const Vector3&)>& within)
{
	const Bed bed(21, 120);
	SolidVolume sum { 0, 0, 0 };
	int cut = 0;
	for (const SolidVolume& one : volumesWithin(bed.bodies, region, accuracy)) {
		sum = { sum.low + one.low, sum.estimate + one.estimate, sum.high + one.high };
		cut += one.high > one.low;
	}
	const Sampled sampled = sample(bed, within);
	const double error = std::sqrt(sampled.variance);
	EXPECT_GT(cut, 40);
	EXPECT_LT(error, 2e-3 * sampled.volume);
	EXPECT_LE(sum.low, sampled.volume + 3 * error);
	EXPECT_GE(sum.high, sampled.volume - 3 * error);
	EXPECT_NEAR(sum.estimate, sampled.volume, 3 * error + 0.1 * (sum.high - sum.low));
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Transform>
Surface surfaceOf(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles, const Transform& transform)
{
	std::vector<Kernel::Point_3> moved;
	for (const Vector3& point : points) {
		const Vector3 x = transform(point);
		moved.emplace_back(x.x(), x.y(), x.z());
	}
	Surface surface;
	CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(moved, triangles, surface);
	return surface;
}

} // namespace

TEST(RegionOracle, HalfSpacesAgainstMonteCarlo)
{
	std::vector<HalfSpace> halfSpaces { { Vector3(1, 1, 0).normalized(), 0.5 },
		{ Vector3(-1, 0.5, 0.2).normalized(), 0.6 }, { Vector3(0, -1, 1).normalized(), 0.4 }, { -Vector3::UnitZ(), 0.7 } };
	expectWithinMonteCarlo(ConvexRegion(halfSpaces), [&](const Vector3& x) {
		return std::all_of(halfSpaces.begin(), halfSpaces.end(), [&](const HalfSpace& h) { return h.outside(x) <= 0; });
	});
}

TEST(RegionOracle, StarAgainstMonteCarlo)
{
	// Inside where the point, turned into the first of the ten right triangles, is on the inner side of the line from tip to notch.
	const double outer = 1.2, inner = 0.5;
	const Eigen::Vector2d tip(outer, 0), notch(inner * std::cos(pi / 5), inner * std::sin(pi / 5)), along = notch - tip;
	const auto within = [&](const Vector3& x) {
		const double angle = std::abs(std::remainder(std::atan2(x.y(), x.x()), 2 * pi / 5)), radius = std::hypot(x.x(), x.y());
		const Eigen::Vector2d turned = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)) - tip;
		return along.x() * turned.y() - along.y() * turned.x() >= 0 && std::abs(x.z()) <= 0.9;
	};
	expectWithinMonteCarlo(MeshRegion(star(outer, inner, 5, -0.9, 0.9), "star"), within);
}

TEST(RegionOracle, BallOfTrianglesAgainstMonteCarlo)
{
	// A region whose own triangles are far smaller than the bodies. Whether a point is between it and the surface that it stands for, CGAL's rays
	// tell.
	const Shape ball(Vector3(1, 0.9, 0.8), 4, 2);
	const Tessellation surface = tessellate(ball, 1e-3);
	const MeshRegion region({ surface.points, surface.triangles }, "ball");
	expectWithinMonteCarlo(region, [&](const Vector3& x) {
		const double gauge = ball.gauge(x);
		return gauge < 0.99 || (gauge <= 1 && region.contains(x));
	});
}

TEST(RegionOracle, AgainstCorefinement)
{
	const TriangleMesh mesh = star(1.1, 0.5, 5, -0.8, 0.9);
	const MeshRegion region(mesh, "star");
	const Bed bed(22, 40);
	for (const Placement& body : bed.bodies) {
		const Tessellation coarse = tessellate(body.shape, 0.1 * body.shape.smallestHalfSize());
		const double found = region.volumeWithin({ coarse.points, coarse.triangles, body.rotation }, body);
		Surface particle = surfaceOf(coarse.points, coarse.triangles, [&](const Vector3& x) { return body.rotation * x + body.position; });
		Surface star = surfaceOf(mesh.points, mesh.triangles, [](const Vector3& x) { return x; });
		ASSERT_TRUE(CGAL::Polygon_mesh_processing::corefine_and_compute_intersection(particle, star, particle));
		EXPECT_NEAR(found, CGAL::Polygon_mesh_processing::volume(particle), 1e-12 * volume(body.shape));
	}
}
