// pkg/mesh for Python.
#pragma once

#include <core/Shape.hpp>

namespace yade {

class MeshFunctions : public Serializable {
public:
	static boost::python::tuple readStl(const std::string& path);
	static std::string check(const boost::python::object& points, const boost::python::object& triangles, const std::string& name, bool closed);
	static Real volume(const boost::python::object& points, const boost::python::object& triangles, const boost::python::object& halfSpaces);
	static boost::python::object contained(const boost::python::object& points, const boost::python::object& triangles, const std::string& name,
	        const boost::python::object& questions);
	static boost::python::object volumesInHalfSpaces(const boost::python::object& particles, Real accuracy, const boost::python::object& halfSpaces);
	static boost::python::object volumesInMesh(const boost::python::object& particles, Real accuracy, const boost::python::object& points,
	        const boost::python::object& triangles, const std::string& name,
	        const boost::python::object& halfSpaces);

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(MeshFunctions, Serializable,
		"Surfaces of triangles, and how much solid is in what they or half spaces enclose: what `yade.superquadric` (stlContainer, "
		"packingFraction, Box, Cylinder, HalfSpaces, Mesh) stands on, "
		"where lengths, types and names are checked. All methods are static. Arrays come as contiguous numpy arrays and go as bytes, row after "
		"row: points N x 3 float64 [m]; triangles M x 3 int32, indices of points; "
		"halfSpaces K x 4 float64 (nx, ny, nz, d): the points with n.x <= d, n a unit vector; particles P x 17 float64: position [m], rotation "
		"from body to space (row after row), half sizes [m], n1, n2."
		, , ,
		.def("readStl", &MeshFunctions::readStl, (boost::python::arg("path")),
			"(points, triangles) of an STL file, ASCII or binary; corners with equal coordinates are one point. ValueError for what is no whole "
			"STL file.").staticmethod("readStl")
		.def("check", &MeshFunctions::check,
			(boost::python::arg("points"), boost::python::arg("triangles"), boost::python::arg("name"), boost::python::arg("closed") = true),
			"'outward', 'inward' or (without `closed`) 'open': how the surface faces. ValueError that begins with `name` and says all that is "
			"wrong: numbers that are not finite, triangles without an area, open edges, edges of more than "
			"two triangles, triangles turned over, parts that meet in a point, triangles through each other, parts that face opposite ways; how "
			"many, and where first. Decided exactly (CGAL).").staticmethod("check")
		.def("volume", &MeshFunctions::volume, (boost::python::arg("points"), boost::python::arg("triangles"), boost::python::arg("halfSpaces")),
			"Volume [m^3] of the part of what a closed surface that faces outward encloses that lies in all of the half "
			"spaces.").staticmethod("volume")
		.def("contained", &MeshFunctions::contained,
			(boost::python::arg("points"), boost::python::arg("triangles"), boost::python::arg("name"), boost::python::arg("questions")),
			"A byte 0 or 1 for each of the points `questions`: whether a closed surface encloses it.").staticmethod("contained")
		.def("volumesInHalfSpaces", &MeshFunctions::volumesInHalfSpaces,
			(boost::python::arg("particles"), boost::python::arg("accuracy"), boost::python::arg("halfSpaces")),
			"Lower bound, estimate, upper bound [m^3] of the volume of each particle in all of the half spaces: P x 3 float64. Particles that are "
			"cut are replaced by tessellations within "
			"`accuracy` times their smallest half size; the bounds hold for the particles themselves.").staticmethod("volumesInHalfSpaces")
		.def("volumesInMesh", &MeshFunctions::volumesInMesh,
			(boost::python::arg("particles"), boost::python::arg("accuracy"), boost::python::arg("points"), boost::python::arg("triangles"),
			boost::python::arg("name"), boost::python::arg("halfSpaces")),
			"The same in what a closed surface encloses, convex or not, whichever way it faces, and in all of the half "
			"spaces.").staticmethod("volumesInMesh")
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(MeshFunctions);

} // namespace yade
