// STL files, ASCII and binary, whole and damaged.
#include <pkg/mesh/StlFile.hpp>

#include <tests/support/Meshes.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

TriangleMesh cube() { return box(Vector3::Zero(), Vector3(1, 2, 3)); }

std::string ascii(const TriangleMesh& mesh)
{
	std::ostringstream text;
	text << "solid cube\n";
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		text << " facet normal 0 0 0\n  outer loop\n";
		for (int k = 0; k < 3; ++k)
			text << "   vertex " << mesh.corner(i, k).transpose() << "\n";
		text << "  endloop\n endfacet\n";
	}
	text << "endsolid cube\n";
	return text.str();
}

std::string binary(const TriangleMesh& mesh, const char* header = "cube")
{
	std::string bytes(80, ' ');
	std::memcpy(&bytes[0], header, std::strlen(header));
	const auto put = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
	put(std::uint32_t(mesh.triangles.size()));
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		for (int k = 0; k < 3; ++k)
			put(0.0f);
		for (int k = 0; k < 3; ++k)
			for (int axis = 0; axis < 3; ++axis)
				put(float(mesh.corner(i, k)[axis]));
		put(std::uint16_t(0));
	}
	return bytes;
}

std::string written(const std::string& content)
{
	const std::string path = ::testing::TempDir() + "superquadric-" + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".stl";
	std::ofstream(path, std::ios::binary) << content;
	return path;
}

void expectCube(const std::string& content)
{
	const TriangleMesh mesh = readStl(written(content));
	ASSERT_EQ(mesh.points.size(), 8u); // of 36 corners
	ASSERT_EQ(mesh.triangles.size(), 12u);
	for (std::size_t i = 0; i < 12; ++i)
		for (int k = 0; k < 3; ++k)
			EXPECT_EQ(mesh.corner(i, k), cube().corner(i, k));
}

void expectRefused(const std::string& content, const std::string& why)
{
	const std::string path = written(content);
	try {
		readStl(path);
		ADD_FAILURE() << "not refused";
	} catch (const std::invalid_argument& error) {
		EXPECT_EQ(error.what(), path + ": " + why);
	}
}

} // namespace

TEST(StlFile, Ascii) { expectCube(ascii(cube())); }
TEST(StlFile, Binary) { expectCube(binary(cube())); }
TEST(StlFile, BinaryWhoseHeaderLooksLikeAscii) { expectCube(binary(cube(), "solid cube")); }

TEST(StlFile, NegativeZeroIsZero)
{
	TriangleMesh mesh = cube();
	mesh.points.push_back(-mesh.points[0]);
	mesh.triangles[0][0] = 8;
	expectCube(binary(mesh));
}

TEST(StlFile, NaNIsKeptForTheCheckToFind)
{
	TriangleMesh mesh = cube();
	mesh.points[5].x() = std::numeric_limits<double>::quiet_NaN();
	const TriangleMesh read = readStl(written(binary(mesh)));
	EXPECT_EQ(read.points.size(), 8u);
	EXPECT_EQ(std::count_if(read.points.begin(), read.points.end(), [](const Vector3& x) { return std::isnan(x.x()); }), 1);
}

TEST(StlFile, Damaged)
{
	const std::string notWhole = "no STL file, or cut short", none = "has no triangles";
	const std::string asText = ascii(cube()), asBytes = binary(cube());
	expectRefused(asText.substr(0, asText.size() / 2), notWhole);
	expectRefused(asBytes.substr(0, asBytes.size() / 2), notWhole);
	expectRefused(asBytes.substr(0, 82), notWhole);
	expectRefused("solid nothing\nendsolid nothing\n", none);
	expectRefused("", none);
	expectRefused("This is a letter, not a solid, and long enough to fill the header of a binary file, then some.", notWhole);
}

TEST(StlFile, NoSuchFile) { EXPECT_THROW(readStl("/no/such/file.stl"), std::invalid_argument); }
