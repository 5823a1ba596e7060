#pragma once

#include "ContactFunctor.hpp"
#include "HollowCylinder.hpp"
#include "ThreadCounters.hpp"

namespace yade {

class Ig2_HollowCylinder_Superquadric_SuperquadricGeom : public ContactFunctor {
public:
	FUNCTOR2D(HollowCylinder, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(HollowCylinder, Superquadric);
	boost::python::dict counters() const { return solverCounters.asDict(); }
	void resetCounters() { solverCounters.reset(); }

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Ig2_HollowCylinder_Superquadric_SuperquadricGeom, IGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`HollowCylinder` and a :yref:`Superquadric`, whose deepest point is its farthest "
		"from the axis, eq. (4)."
		, , , .def("counters", &Ig2_HollowCylinder_Superquadric_SuperquadricGeom::counters, "Dictionary of the solver's counts since the functor was "
			"made or resetCounters was called, all threads together.")
		.def("resetCounters", &Ig2_HollowCylinder_Superquadric_SuperquadricGeom::resetCounters, "Set the solver's counts to zero.")
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;

private:
	ThreadCounters solverCounters;
};
REGISTER_SERIALIZABLE(Ig2_HollowCylinder_Superquadric_SuperquadricGeom);

} // namespace yade
