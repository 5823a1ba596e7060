// What pictures and files are made of, gathered in one pass: rows of 8-byte numbers for numpy.
#pragma once

#include <core/Scene.hpp>

#include <cstdint>

namespace yade {

// Each row stands again as a dtype in py/measure/bodyarrays.py; a vector is x, y, z, a tensor its rows, a quaternion x, y, z, w.
namespace rows {
	enum Kind : std::int64_t {
		SphereKind,
		SuperquadricKind,
		WallKind,
		CylinderKind,
		FacetKind,
	};

	struct Particle {
		std::int64_t id, kind, material, contacts;
		double extents[3], exponents[2], position[3], orientation[4], velocity[3], spin[3], volume, stress[9], octahedralStress;
	};

	struct Contact {
		std::int64_t id1, id2;
		double centre1[3], centre2[3], point[3], normalForce[3], shearForce[3], overlap;
	};

	// The numbers: of a Wall axis and sense, of a HollowCylinder radius and height [m], of a Facet its three vertices in space [m].
	struct Border {
		std::int64_t id, kind;
		double position[3], orientation[4], numbers[9];
	};
}

class BodyArrays : public Serializable {
public:
	boost::python::object particles(const boost::python::object& ids) const;
	boost::python::object contacts() const;
	boost::python::object container() const;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BodyArrays, Serializable,
		"The scene as arrays: each method looks at all bodies or contacts in one pass and returns bytes, rows of 8-byte numbers for numpy. "
		"py/measure/bodyarrays.py has the dtypes and is the way to use it. In a periodic scene the particles are put into the cell, and a contact "
		"goes with its first body.",
		,
		,
		.def("particles", &BodyArrays::particles, (boost::python::arg("ids") = boost::python::object()),
			"Rows of the spheres and superquadrics among the bodies ids, in that order (None: of the scene, in the order of their ids); "
			"ValueError for a body that is not there. The stress is the mean of the particle, sum of lever times force over the volume, tension "
			"positive; the contacts counted are those that push.")
		.def("contacts", &BodyArrays::contacts,
			"Rows of all real contacts of YADE's geometries with a contact point, in the order of their ids. Forces act on the second body. "
			"For a body that is no particle the contact point stands in place of its centre.")
		.def("container", &BodyArrays::container, "Rows of the walls, hollow cylinders and facets, in the order of their ids.")
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(BodyArrays);

} // namespace yade
