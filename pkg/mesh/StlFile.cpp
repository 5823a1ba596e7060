#include "StlFile.hpp"

#include <CGAL/IO/STL.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace superquadric {

namespace {

	// A corner as it is in the file. CGAL finds equal ones by an order; that of the numbers alone would take a NaN for equal to any.
	struct Corner : std::array<double, 3> {
		static bool less(double a, double b) { return a < b || (std::isnan(a) && !std::isnan(b)); }
		bool operator<(const Corner& other) const { return std::lexicographical_compare(begin(), end(), other.begin(), other.end(), less); }
	};

} // namespace

TriangleMesh readStl(const std::string& path)
{
	std::ifstream file(path, std::ios::binary);
	if (!file) throw std::invalid_argument(path + ": cannot be read");
	std::vector<Corner> corners;
	TriangleMesh mesh;
	if (!CGAL::IO::read_STL(file, corners, mesh.triangles)) throw std::invalid_argument(path + ": no STL file, or cut short");
	if (mesh.triangles.empty()) throw std::invalid_argument(path + ": has no triangles");
	mesh.points.reserve(corners.size());
	for (const Corner& corner : corners)
		mesh.points.emplace_back(corner[0], corner[1], corner[2]);
	return mesh;
}

} // namespace superquadric
