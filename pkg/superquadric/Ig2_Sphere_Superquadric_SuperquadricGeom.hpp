#pragma once

#include "ContactFunctor.hpp"
#include "ThreadCounters.hpp"

#include <pkg/common/Sphere.hpp>

namespace yade {

class Ig2_Sphere_Superquadric_SuperquadricGeom : public ContactFunctor {
public:
	FUNCTOR2D(Sphere, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Sphere, Superquadric);
	boost::python::dict counters() const { return solverCounters.asDict(); }
	void resetCounters() { solverCounters.reset(); }

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Ig2_Sphere_Superquadric_SuperquadricGeom, IGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Sphere`, taken as the superquadric with n1 = n2 = 2, and a :yref:`Superquadric`."
		, , , .def("counters", &Ig2_Sphere_Superquadric_SuperquadricGeom::counters, "Dictionary of the solver's counts since the functor was made or "
			"resetCounters was called, all threads together.")
		.def("resetCounters", &Ig2_Sphere_Superquadric_SuperquadricGeom::resetCounters, "Set the solver's counts to zero.")
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;

private:
	ThreadCounters solverCounters;
};
REGISTER_SERIALIZABLE(Ig2_Sphere_Superquadric_SuperquadricGeom);

} // namespace yade
