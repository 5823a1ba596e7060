#include "MeshFunctions.hpp"

#include <pkg/support/Buffers.hpp>
#include <pkg/support/Checks.hpp>

#include <pkg/mesh/MeshCheck.hpp>
#include <pkg/mesh/SolidVolume.hpp>
#include <pkg/mesh/StlFile.hpp>

#include <deque>

namespace yade {

YADE_PLUGIN((MeshFunctions));

namespace {

	using boost::python::object;

	superquadric::TriangleMesh meshOf(const object& points, const object& triangles)
	{
		superquadric::TriangleMesh mesh { rowsOf<Vector3r>(points, "points"), rowsOf<std::array<int, 3>>(triangles, "triangles") };
		for (const auto& triangle : mesh.triangles)
			for (const int corner : triangle)
				if (corner < 0 || std::size_t(corner) >= mesh.points.size()) refuse("triangles", "indices of points", corner);
		return mesh;
	}

	std::vector<superquadric::HalfSpace> halfSpacesOf(const object& rows)
	{
		std::vector<superquadric::HalfSpace> result;
		for (const auto& row : rowsOf<std::array<Real, 4>>(rows, "halfSpaces"))
			result.push_back({ Vector3r(row[0], row[1], row[2]), row[3] });
		return result;
	}

	// Bodies of space with the shapes that they refer to.
	struct Particles {
		std::deque<superquadric::Shape> shapes;
		std::vector<superquadric::Placement> placed;

		explicit Particles(const object& rows)
		{
			for (const auto& row : rowsOf<std::array<Real, 17>>(rows, "particles")) {
				const Real* numbers = row.data();
				const Vector3r position = Eigen::Map<const Vector3r>(numbers);
				requireFinite("position", position);
				const superquadric::Shape shape(Eigen::Map<const Vector3r>(numbers + 12), numbers[15], numbers[16]);
				if (shapes.empty() || !(shapes.back() == shape)) shapes.push_back(shape);
				placed.emplace_back(shapes.back(), position, Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>(numbers + 3));
			}
		}
	};

	object volumesWithin(const object& particles, const superquadric::Region& region, Real accuracy)
	{
		requirePositive("accuracy", accuracy);
		return bytesOf(superquadric::volumesWithin(Particles(particles).placed, region, accuracy));
	}

} // namespace

boost::python::tuple MeshFunctions::readStl(const std::string& path)
{
	const superquadric::TriangleMesh mesh = superquadric::readStl(path);
	return boost::python::make_tuple(bytesOf(mesh.points), bytesOf(mesh.triangles));
}

std::string MeshFunctions::check(const object& points, const object& triangles, const std::string& name, bool closed)
{
	switch (superquadric::checkMesh(meshOf(points, triangles), name, closed)) {
		case superquadric::Facing::outward: return "outward";
		case superquadric::Facing::inward: return "inward";
		default: return "open";
	}
}

Real MeshFunctions::volume(const object& points, const object& triangles, const object& halfSpaces)
{
	const superquadric::TriangleMesh mesh = meshOf(points, triangles);
	superquadric::ClippedSolid solid(mesh.points, mesh.triangles, Matrix3r::Identity());
	for (const auto& halfSpace : halfSpacesOf(halfSpaces))
		solid.clip(halfSpace);
	return solid.volume();
}

object MeshFunctions::contained(const object& points, const object& triangles, const std::string& name, const object& questions)
{
	const superquadric::MeshRegion region(meshOf(points, triangles), name);
	std::vector<char> answers;
	for (const Vector3r& question : rowsOf<Vector3r>(questions, "questions")) {
		requireFinite("questions", question);
		answers.push_back(region.contains(question));
	}
	return bytesOf(answers);
}

object MeshFunctions::volumesInHalfSpaces(const object& particles, Real accuracy, const object& halfSpaces)
{
	return volumesWithin(particles, superquadric::ConvexRegion(halfSpacesOf(halfSpaces)), accuracy);
}

object MeshFunctions::volumesInMesh(const object& particles, Real accuracy, const object& points, const object& triangles, const std::string& name,
        const object& halfSpaces)
{
	const superquadric::MeshRegion mesh(meshOf(points, triangles), name);
	const superquadric::ConvexRegion planes(halfSpacesOf(halfSpaces));
	return volumesWithin(particles, superquadric::CutMeshRegion(mesh, planes), accuracy);
}

} // namespace yade
