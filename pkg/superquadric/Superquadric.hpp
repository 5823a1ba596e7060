// The particle: YADE's view of superquadric::Shape.
#pragma once

#include <core/Shape.hpp>
#include <core/State.hpp>
#include <pkg/geometry/Placement.hpp>
#include <pkg/support/AcceptedAttributes.hpp>

namespace yade {

class Superquadric : public Shape {
public:
	~Superquadric() override = default;

	// The mathematical shape that belongs to the attributes.
	const superquadric::Shape& solid() const { return valid; }
	// The body in space; `shift` is the offset of its periodic image [m].
	superquadric::Placement placement(const State& state, const Vector3r& shift = Vector3r::Zero()) const
	{
		return { valid, state.pos + shift, state.ori.toRotationMatrix() };
	}

	// Called by YADE after the attributes were set or loaded. Refused values are put back before the error leaves.
	void postLoad(Superquadric&);

	Real volume() const;
	// The virtual function that every shape has since YADE 2026.1, so not const; the level sets of YADE ask for it.
	Real getVolume() { return volume(); } // NOLINT(readability-make-member-function-const)
	Vector3r inertia(Real density) const;
	Real function(const Vector3r& point) const;
	Real gauge(const Vector3r& point) const;
	Real support(const Vector3r& direction) const;
	Vector3r supportPoint(const Vector3r& direction) const;
	Real meanCurvature(const Vector3r& point) const;
	Vector3r boxHalfExtents(const Quaternionr& orientation) const;
	Real boundingRadius() const { return valid.boundingRadius(); }
	boost::python::tuple tessellation(Real error) const;

	// By value: a reference would let `shape.extents[0] = -1` pass unchecked.
	Vector3r getExtents() const { return extents; }
	void setExtents(const Vector3r& value);

private:
	superquadric::Shape valid { Vector3r::Ones(), 2, 2 };
	AcceptedAttributes accepted;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Superquadric, Shape,
		"Superquadric particle of [Wang2018]_: $f(x)=\\left(|x/a|^{n_2}+|y/b|^{n_2}\\right)^{n_1/n_2}+|z/c|^{n_1}$, "
		"surface $f=1$, inside $f<1$, in the frame of the body. $n_1=n_2=2$ is an ellipsoid, $n_1\\gg 2$, $n_2=2$ a cylinder along z, "
		"$n_1, n_2\\gg 2$ a block. Refused values raise ValueError naming the parameter and the value; the shape then stays as it was.\n\n"
		"Points and directions given to the methods are in the frame of the body, from its centre.\n\n"
		".. [Wang2018] Wang & Ji, Acta Phys. Sin. 67, 094501 (2018).",
		((Vector3r, extents, Vector3r::Ones(), Attr::triggerPostLoad, "Half sizes (a, b, c) along the principal axes [m]; within [1e-30, 1e30]. "
			"[defined below]"))
		((Real, n1, 2, Attr::triggerPostLoad, "Exponent along z, within [2, 20]."))
		((Real, n2, 2, Attr::triggerPostLoad, "Exponent in the x-y plane, within [2, 20]."))
		, createIndex(); postLoad(*this);,
		.add_property("extents", &Superquadric::getExtents, &Superquadric::setExtents,
			"Half sizes (a, b, c) along the principal axes [m]; within [1e-30, 1e30]. Assign all three: reading gives a copy.")
		.def("volume", &Superquadric::volume, "Volume [m^3], in closed form.")
		.def("getVolume", &Superquadric::getVolume, "The same, under the name that it has for YADE's own shapes since YADE 2026.1.")
		.def("inertia", &Superquadric::inertia, (boost::python::arg("density")),
			"Principal moments of inertia (Ixx, Iyy, Izz) about the centre for a density in [kg/m^3]; Vector3 [kg m^2], in closed form.")
		.def("function", &Superquadric::function, (boost::python::arg("point")), "Shape function f at a point [m]: below 1 inside, 1 on the surface.")
		.def("gauge", &Superquadric::gauge, (boost::python::arg("point")),
			"$f^{1/n_1}$ at a point [m]: the factor by which the body must be scaled for its surface to pass through the point.")
		.def("support", &Superquadric::support, (boost::python::arg("direction")),
			"Greatest value of direction.x over the body; for a unit direction the half thickness along it [m].")
		.def("supportPoint", &Superquadric::supportPoint, (boost::python::arg("direction")),
			"Surface point [m] that lies farthest along a direction. ValueError for the zero direction.")
		.def("boxHalfExtents", &Superquadric::boxHalfExtents, (boost::python::arg("orientation")),
			"Half extents [m] of the exact box along the axes of space for the body rotated by a unit quaternion.")
		.def("boundingRadius", &Superquadric::boundingRadius, "Radius of the smallest sphere about the centre that holds the body [m].")
		.def("meanCurvature", &Superquadric::meanCurvature, (boost::python::arg("point")),
			"Mean curvature [1/m], positive: where the ray from the centre through the point leaves the body. ValueError for the centre.")
		.def("tessellation", &Superquadric::tessellation, (boost::python::arg("error")),
			"Closed convex surface of triangles, inscribed, whose largest distance from the surface is at most `error` [m]: (points, normals, "
				"triangles, error). "
			"The first three are bytes, row after row: N x 3 float64 [m], N x 3 float64, M x 3 int32 (indices of points, counterclockwise from "
				"outside); the "
			"last is the bound that holds [m]. ValueError for an error that is not positive, or too small for a million points. "
			"The function `tessellation` of the package gives arrays.")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(Superquadric, Shape);
};
REGISTER_SERIALIZABLE(Superquadric);

} // namespace yade
