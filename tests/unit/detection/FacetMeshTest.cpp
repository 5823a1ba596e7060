// Meshes of triangles against what they stand for: a plane, a ridge, a hollow corner, a sheet with a rim.
#include <pkg/detection/FacetMesh.hpp>
#include <pkg/detection/WallContact.hpp>

#include <tests/support/RandomBodies.hpp>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

using Mesh = std::vector<MeshFacet>;

void add(Mesh& mesh, const Vector3& a, const Vector3& b, const Vector3& c) { mesh.push_back({ int(mesh.size()), { a, b, c } }); }

// The square [-side/2, side/2]^2 of the plane z = 0, moved by `lift(x, y)`, in 2 cells^2 triangles.
template <class Lift> Mesh sheet(double side, int cells, const Lift& lift)
{
	const auto at = [&](int i, int k) {
		const double x = side * (double(i) / cells - 0.5), y = side * (double(k) / cells - 0.5);
		return Vector3(x, y, lift(x, y));
	};
	Mesh mesh;
	for (int i = 0; i < cells; ++i)
		for (int k = 0; k < cells; ++k) {
			add(mesh, at(i, k), at(i + 1, k), at(i, k + 1));
			add(mesh, at(i + 1, k + 1), at(i, k + 1), at(i + 1, k));
		}
	return mesh;
}
Mesh floorOf(int cells, double side = 8)
{
	return sheet(side, cells, [](double, double) { return 0.0; });
}

Mesh neighboursOf(const Mesh& mesh, const MeshFacet& facet)
{
	Mesh result;
	for (const MeshFacet& other : mesh) {
		bool shares = false;
		for (const Vector3& v : facet.vertices)
			for (const Vector3& w : other.vertices)
				shares = shares || (v - w).norm() < 1e-9;
		if (shares && other.id != facet.id) result.push_back(other);
	}
	return result;
}

// The contacts that push, each facet with a memory of its own.
class Pushed {
public:
	explicit Pushed(Mesh mesh)
	        : mesh_(std::move(mesh))
	        , warm_(mesh_.size())
	{
	}

	std::vector<Contact> by(const Placement& body)
	{
		std::vector<Contact> result;
		for (size_t i = 0; i < mesh_.size(); ++i) {
			const Contact contact = contactTriangle(body, mesh_[i].vertices, warm_[i], counters);
			EXPECT_NE(contact.status, Status::Uncertified);
			if (!contact.overlapping()) continue;
			if (farFromBorder(body, mesh_[i], contact.point) || pushesAmong(body, mesh_[i], contact, neighboursOf(mesh_, mesh_[i]), counters))
				result.push_back(contact);
		}
		return result;
	}

	SolverCounters counters;

private:
	Mesh mesh_;
	std::vector<WarmStart> warm_;
};

Contact onPlane(const Placement& body)
{
	WarmStart warm;
	SolverCounters counters;
	return contactPlane(body, Vector3::Zero(), Vector3::UnitZ(), warm, counters);
}

void expectSame(const std::vector<Contact>& pushed, const Contact& plane, const Placement& body)
{
	ASSERT_EQ(pushed.size(), 1u) << "at " << body.position.transpose();
	EXPECT_NEAR(pushed[0].overlap / plane.overlap, 1, 1e-5);
	EXPECT_LT((pushed[0].normal - plane.normal).norm(), 1e-6);
	EXPECT_LT((pushed[0].point - plane.point).norm(), 1e-5);
}

const double rightAngle = pi / 2;

} // namespace

TEST(FacetMesh, AFlatFloorPushesAsThePlaneHoweverItIsCut)
{
	const Shape cube(Vector3::Constant(1), 8, 8);
	for (int cells : { 1, 4, 8 }) {
		Pushed floor(floorOf(cells));
		// In the middle of the mesh, on a vertex, on an edge and anywhere.
		for (const Vector3& place : { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0.5, 0, 0), Vector3(0.5, 0.5, 0), Vector3(0.3, 0.2, 0), Vector3(-0.7, 0.9, 0) }) {
			const Placement body { cube, place + Vector3(0, 0, 1 - 1e-3), Matrix3::Identity() };
			expectSame(floor.by(body), onPlane(body), body);
		}
		EXPECT_EQ(floor.counters.fallbacks, 0u);
	}
}

TEST(FacetMesh, AnyBodyAnywhereOnAFlatFloor)
{
	RandomBodies random(121);
	for (int i = 0; i < 300; ++i) {
		const Shape shape = random.shape(0.5);
		const Matrix3 rotation = i % 2 ? random.rotation() : Matrix3(Eigen::AngleAxisd(random.logarithmic(1e-10, 0.1), random.direction()).toRotationMatrix());
		const Vector3 place(random.uniform(-1.5, 1.5), i % 5 ? random.uniform(-1.5, 1.5) : 0, 0);
		const Placement body { shape, place + Vector3(0, 0, shape.support(rotation.row(2)) * (1 - random.logarithmic(1e-6, 0.05))), rotation };
		Pushed floor(floorOf(8));
		expectSame(floor.by(body), onPlane(body), body);
	}
}

// Slow ways over seams and vertices: every step has exactly one contact, the plane's.
TEST(FacetMesh, SlidingAndRollingOverSeamsIsSmooth)
{
	const Shape cube(Vector3::Constant(1), 8, 8), egg(Vector3(1, 0.8, 0.7), 2.5, 3);
	for (double step : { 1e-8, 1e-7, 1e-6, 1e-3 }) {
		Pushed floor(floorOf(8)), other(floorOf(8));
		for (int i = -300; i <= 300; ++i) {
			const Placement sliding { cube, Vector3(1 + i * step, 0.5 * i * step, 1 - 1e-3), Matrix3::Identity() };
			expectSame(floor.by(sliding), onPlane(sliding), sliding);
			const Matrix3 rotation = Eigen::AngleAxisd(0.3 + i * step, Vector3(0.3, 1, 0).normalized()).toRotationMatrix();
			const Placement rolling { egg, Vector3(i * step, 0.3 * i * step, (1 - 1e-3) * egg.support(rotation.row(2))), rotation };
			expectSame(other.by(rolling), onPlane(rolling), rolling);
		}
	}
}

// A ball led over a ridge: one contact at every place, whose normal is radial, and whose overlap follows the distance.
TEST(FacetMesh, ARidgePushesOnce)
{
	const Shape ball(Vector3::Constant(0.5), 2, 2);
	for (double slope : { 1e-4, 0.1, 1.0 }) {
		Pushed ridge(sheet(8, 8, [&](double x, double) { return -slope * std::abs(x); }));
		double last = 0;
		Vector3 lastPosition = Vector3::Zero();
		for (int i = -100; i <= 100; ++i) {
			const Vector3 up = Vector3(slope * i / 50.0, 0, 1).normalized();
			const Placement body { ball, Vector3(0.001, 0.21, 0) + 0.499 * up, Matrix3::Identity() };
			const auto pushed = ridge.by(body);
			ASSERT_EQ(pushed.size(), 1u) << "slope " << slope << ", place " << i;
			EXPECT_LT((pushed[0].normal + (body.position - pushed[0].point).normalized()).norm(), 1e-9);
			EXPECT_NEAR(pushed[0].overlap, 0.5 - (body.position - pushed[0].point).norm(), 1e-12);
			if (i > -100) { EXPECT_LE(std::abs(pushed[0].overlap - last), (body.position - lastPosition).norm() * (1 + 1e-6)); }
			last = pushed[0].overlap;
			lastPosition = body.position;
		}
	}
}

TEST(FacetMesh, AHollowCornerPushesFromBothSidesAndARimOnce)
{
	const Shape ball(Vector3::Constant(0.5), 2, 2);
	Pushed valley(sheet(8, 8, [](double x, double) { return std::abs(x); }));
	const auto pushed = valley.by({ ball, Vector3(0, 0.2, 0.499 * std::sqrt(2.0)), Matrix3::Identity() });
	ASSERT_EQ(pushed.size(), 2u);
	EXPECT_NEAR(pushed[0].overlap, 1e-3, 1e-12);
	EXPECT_NEAR(pushed[1].overlap, 1e-3, 1e-12);
	EXPECT_NEAR(pushed[0].normal.dot(pushed[1].normal), std::cos(rightAngle), 1e-9);

	Pushed floor(floorOf(8));
	for (double y : { 0.2, 0.5, 1.0 }) {
		const auto rim = floor.by({ ball, Vector3(4.3, y, 0.399), Matrix3::Identity() });
		ASSERT_EQ(rim.size(), 1u) << y;
		EXPECT_LT((rim[0].normal - Vector3(-0.3, 0, -0.399).normalized()).norm(), 1e-9);
	}
	EXPECT_EQ(floor.by({ ball, Vector3(4.29, 4.29, 0.28), Matrix3::Identity() }).size(), 1u); // the sheet's corner
}

// The documented limit: a bend so flat that the contact covers both sides is pushed by both.
TEST(FacetMesh, AHollowBendUnderTheContactPushesFromBothSides)
{
	const Shape ball(Vector3::Constant(0.5), 2, 2);
	for (double slope : { 1e-3, 1e-2 }) {
		Pushed valley(sheet(8, 8, [&](double x, double) { return slope * std::abs(x); }));
		const auto pushed = valley.by({ ball, Vector3(0, 0.2, 0.499 * std::hypot(1, slope)), Matrix3::Identity() });
		ASSERT_EQ(pushed.size(), 2u);
		EXPECT_NEAR(pushed[0].overlap, 1e-3, 1e-12);
		EXPECT_NEAR(pushed[1].overlap, 1e-3, 1e-12);
	}
}
