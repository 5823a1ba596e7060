// Every defect of a surface is named, counted and placed; sound ones pass, whichever way they face.
#include <pkg/mesh/MeshCheck.hpp>

#include <tests/support/Meshes.hpp>

#include <gtest/gtest.h>

#include <limits>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

TriangleMesh unitCube() { return box(Vector3::Zero(), Vector3::Ones()); }
TriangleMesh cubeAt(double x, double y = 0, double z = 0, double size = 1) { return box(Vector3(x, y, z), Vector3(x + size, y + size, z + size)); }

TriangleMesh withoutLid()
{
	TriangleMesh mesh = unitCube();
	mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
	return mesh;
}

// What is said of the mesh; nothing if it is sound.
std::string complaint(const TriangleMesh& mesh, bool closed = true)
{
	try {
		checkMesh(mesh, "mould.stl", closed);
		return "";
	} catch (const std::invalid_argument& error) {
		return error.what();
	}
}

void expectComplaint(const TriangleMesh& mesh, const std::string& text, bool closed = true)
{
	EXPECT_NE(complaint(mesh, closed).find(text), std::string::npos) << "\"" << text << "\" is not in \"" << complaint(mesh, closed) << "\"";
}

} // namespace

TEST(MeshCheck, SoundSurfacesAndHowTheyFace)
{
	EXPECT_EQ(checkMesh(unitCube(), "", true), Facing::outward);
	EXPECT_EQ(checkMesh(turned(unitCube()), "", true), Facing::inward);
	EXPECT_EQ(checkMesh(unitCube(), "", false), Facing::outward);
	EXPECT_EQ(checkMesh(withoutLid(), "", false), Facing::open);
	EXPECT_EQ(checkMesh(star(2, 1, 5, 0, 1), "", true), Facing::outward);
	EXPECT_EQ(checkMesh(together(unitCube(), cubeAt(2)), "", true), Facing::outward);
	EXPECT_EQ(checkMesh(together(cubeAt(0, 0, 0, 3), turned(cubeAt(1, 1, 1))), "", true), Facing::outward); // with a cavity
}

TEST(MeshCheck, PointsOfNoTriangleCountForNothing)
{
	TriangleMesh mesh = unitCube();
	mesh.points.insert(mesh.points.begin(), Vector3(0.5, 0.5, 0.5));
	mesh.points.emplace_back(-3, 0, 0);
	for (auto& triangle : mesh.triangles)
		for (int& corner : triangle)
			++corner;
	EXPECT_EQ(checkMesh(mesh, "", true), Facing::outward);
	EXPECT_EQ(checkMesh(turned(mesh), "", true), Facing::inward);
}

TEST(MeshCheck, NoTriangles)
{
	for (bool closed : { true, false })
		EXPECT_EQ(complaint({ { Vector3::Zero() }, {} }, closed), "mould.stl: has no triangles");
}

TEST(MeshCheck, OpenEdges)
{
	EXPECT_EQ(complaint(withoutLid()), "mould.stl: 4 edges with one triangle only (the surface is not closed), first at (0, 0, 1) - (1, 0, 1)");
	EXPECT_EQ(complaint(withoutLid(), /*closed*/ false), "");
}

TEST(MeshCheck, TurnedTriangle)
{
	TriangleMesh mesh = unitCube();
	std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
	expectComplaint(mesh, "3 edges whose two triangles face opposite ways, first at (0, 0, 0) - (1, 0, 0)");
	expectComplaint(mesh, "3 edges whose two triangles face opposite ways", /*closed*/ false);
}

TEST(MeshCheck, TriangleTwice)
{
	TriangleMesh mesh = unitCube();
	mesh.triangles.push_back(mesh.triangles[0]);
	expectComplaint(mesh, "3 edges shared by more than two triangles, first at (0, 0, 0) - (1, 0, 0)");
}

TEST(MeshCheck, FinBesideAClosedSurface)
{
	TriangleMesh mesh = unitCube();
	mesh.points.emplace_back(0.5, -1, -1);
	mesh.triangles.push_back({ 0, 1, 8 });
	expectComplaint(mesh, "1 edges shared by more than two triangles");
	expectComplaint(mesh, "2 edges with one triangle only");
}

TEST(MeshCheck, TrianglesWithoutAnArea)
{
	TriangleMesh mesh = unitCube();
	mesh.points.emplace_back(0.5, 0, 0);
	mesh.triangles.push_back({ 0, 1, 8 });
	mesh.triangles.push_back({ 2, 2, 3 });
	EXPECT_EQ(complaint(mesh), "mould.stl: 2 triangles without an area, first at (0, 0, 0) - (1, 0, 0) - (0.5, 0, 0)");
}

TEST(MeshCheck, NumbersThatAreNone)
{
	TriangleMesh mesh = unitCube();
	mesh.points[3].y() = std::numeric_limits<double>::quiet_NaN();
	expectComplaint(mesh, "1 points with coordinates that are not finite, first at (1, nan, 0)");
}

TEST(MeshCheck, PartsThatGoThroughEachOther)
{
	expectComplaint(together(unitCube(), cubeAt(0.5, 0.25, 0.25)), "pairs of triangles that go through each other, first at (");
	expectComplaint(together(withoutLid(), cubeAt(0.5, 0.25, 0.25)), "pairs of triangles that go through each other", /*closed*/ false);
	expectComplaint(together(unitCube(), cubeAt(1)), "pairs of triangles that go through each other"); // face on face
}

TEST(MeshCheck, PointInWhichTwoPartsMeet)
{
	// Two cubes that share one corner, as one point.
	TriangleMesh mesh = together(unitCube(), cubeAt(1, 1, 1));
	for (auto& triangle : mesh.triangles)
		for (int& corner : triangle)
			if (corner == 8) corner = 7;
	expectComplaint(mesh, "1 points where parts of the surface meet in nothing but the point, first at (1, 1, 1)");
}

TEST(MeshCheck, PartsThatFaceOppositeWays)
{
	expectComplaint(together(unitCube(), turned(cubeAt(2))), "parts do not bound a volume together");
	expectComplaint(together(cubeAt(0, 0, 0, 3), cubeAt(1, 1, 1)), "parts do not bound a volume together"); // the inner one should face the cavity
}

TEST(MeshCheck, AllThatIsWrongIsSaid)
{
	TriangleMesh mesh = withoutLid();
	std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
	mesh = together(mesh, cubeAt(0.5, 0.25, 0.25));
	for (const char* text : { "edges with one triangle only", "face opposite ways", "go through each other" })
		expectComplaint(mesh, text);
}
