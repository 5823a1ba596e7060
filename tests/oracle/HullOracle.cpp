// The verdict of contactPair against convex hulls of fine tessellations, by CGAL: no gauge, no support function and no search of ours.
//
// The hull of points of the surface lies inside the body; swollen by the largest ratio of the body's support to the distance of a facet,
// it holds the body. So where the hulls meet the bodies overlap, and where the swollen hulls do not, the bodies are apart, both exactly (CGAL's
// predicates are exact). Between the two, over 1e-3 or so of the scaling, the tessellation cannot tell: these pairs are counted and few.
#include "CommonScaling.hpp"
#include "RandomPairs.hpp"

#include <pkg/detection/PairContact.hpp>

#define CGAL_DISABLE_GMP 1
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;

constexpr int sections = 50; // from pole to pole; twice as many around

// The hull's facets in the body's frame.
struct Hull {
	std::vector<std::array<Vector3, 3>> facets;
	double swelling = 0;

	explicit Hull(const Shape& shape)
	{
		const ReferenceShape reference(shape);
		std::vector<Kernel::Point_3> points;
		for (int i = 0; i <= sections; ++i)
			for (int k = 0; k < (i % sections ? 2 * sections : 1); ++k) {
				const Vector3 x = reference.surfacePoint(realPi * (Real(i) / sections - 0.5L), realPi * k / sections).cast<double>();
				points.emplace_back(x.x(), x.y(), x.z());
			}
		CGAL::Surface_mesh<Kernel::Point_3> mesh;
		CGAL::convex_hull_3(points.begin(), points.end(), mesh);
		for (const auto face : mesh.faces()) {
			std::array<Vector3, 3> corners;
			int corner = 0;
			for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
				const Kernel::Point_3& p = mesh.point(vertex);
				corners[std::size_t(corner++)] = Vector3(p.x(), p.y(), p.z());
			}
			const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
			swelling = std::max(swelling, shape.support(normal) / normal.dot(corners[0]) - 1);
			facets.push_back(corners);
		}
	}

	Triangles placed(const Placement& body, double scale) const
	{
		const auto point = [&](const Vector3& own) {
			const Vector3 x = body.position + body.toWorld(scale * own);
			return Kernel::Point_3(x.x(), x.y(), x.z());
		};
		Triangles result;
		for (const auto& corners : facets) {
			const Kernel::Triangle_3 triangle(point(corners[0]), point(corners[1]), point(corners[2]));
			if (!triangle.is_degenerate()) result.push_back(triangle); // by rounding; its neighbours cover it
		}
		return result;
	}
};

// Of bodies neither of which can hold the other: their surfaces meet.
bool meet(const Triangles& one, const Triangles& two)
{
	Tree tree(one.begin(), one.end());
	return std::any_of(two.begin(), two.end(), [&](const Kernel::Triangle_3& triangle) { return tree.do_intersect(triangle); });
}

} // namespace

TEST(PairHulls, AgreeWithTheVerdict)
{
	constexpr int pairs = 60;
	const std::array<double, 2> exponents[] = { { 2, 2 }, { 3.3, 5.7 }, { 8, 2 }, { 8, 8 }, { 20, 20 } };
	int undecided = 0;
	double worstSwelling = 0;
	for (std::uint64_t i = 0; i < pairs; ++i) {
		RandomPair pair(70, i, exponents[i % 5], exponents[i / 5 % 5], i % 3 == 0);
		const Shape shape1(pair.sizes1, pair.n11, pair.n12), shape2(pair.sizes2, pair.n21, pair.n22);
		const Hull hull1(shape1), hull2(shape2);
		const double swelling = std::max(hull1.swelling, hull2.swelling);
		worstSwelling = std::max(worstSwelling, swelling);
		const Placement body1 { shape1, Vector3::Zero(), pair.rotation1 };
		const Vector3 touching = pair.along / double(commonScaling<double>(body1, Placement { shape2, pair.along, pair.rotation2 }).middle());
		for (double sign : { -1, 1 }) {
			const Placement body2 { shape2, touching * (1 + sign * pair.random.logarithmic(3e-4, 0.05)), pair.rotation2 };
			WarmStart warm;
			SolverCounters counters;
			const Status status = contactPair(body1, body2, warm, counters).status;
			if (meet(hull1.placed(body1, 1), hull2.placed(body2, 1)))
				EXPECT_EQ(status, Status::Overlap) << "pair " << i;
			else if (!meet(hull1.placed(body1, 1 + swelling), hull2.placed(body2, 1 + swelling)))
				EXPECT_EQ(status, Status::Apart) << "pair " << i;
			else
				++undecided;
		}
	}
	EXPECT_LT(worstSwelling, 0.01);
	EXPECT_LT(undecided, pairs / 2);
	RecordProperty("undecided", undecided);
	RecordProperty("tessellationError", std::to_string(worstSwelling));
}
