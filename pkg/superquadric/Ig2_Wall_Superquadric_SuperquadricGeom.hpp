#pragma once

#include "ContactFunctor.hpp"
#include "ThreadCounters.hpp"

#include <pkg/common/Wall.hpp>

namespace yade {

class Ig2_Wall_Superquadric_SuperquadricGeom : public ContactFunctor {
public:
	FUNCTOR2D(Wall, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Wall, Superquadric);
	boost::python::dict counters() const { return solverCounters.asDict(); }
	void resetCounters() { solverCounters.reset(); }

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Ig2_Wall_Superquadric_SuperquadricGeom, IGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Wall` and a :yref:`Superquadric`, whose contact point is the wall's point "
		"deepest in the particle, drawn towards the particle's middle as far as the depth allows: it moves continuously when a flat face comes to "
			"lie on the wall. With "
		":yref:`sense<Wall.sense>` 0 the wall pushes to the side on which the particle's centre is, else to the side named; there a contact can "
		"begin only when the centre is on that side."
		, , , .def("counters", &Ig2_Wall_Superquadric_SuperquadricGeom::counters, "Dictionary of the solver's counts since the functor was made or "
			"resetCounters was called, all threads together.")
		.def("resetCounters", &Ig2_Wall_Superquadric_SuperquadricGeom::resetCounters, "Set the solver's counts to zero.")
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;

private:
	ThreadCounters solverCounters;
};
REGISTER_SERIALIZABLE(Ig2_Wall_Superquadric_SuperquadricGeom);

} // namespace yade
