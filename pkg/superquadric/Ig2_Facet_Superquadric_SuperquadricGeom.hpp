#pragma once

#include "ContactFunctor.hpp"

#include <pkg/common/Facet.hpp>

namespace yade {

class Ig2_Facet_Superquadric_SuperquadricGeom : public ContactFunctor {
public:
	FUNCTOR2D(Facet, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Facet, Superquadric);
	// clang-format off
	YADE_CLASS_BASE_DOC(Ig2_Facet_Superquadric_SuperquadricGeom, IGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Facet`, a sheet without thickness that pushes to the side on which the "
		"particle's centre is, and a :yref:`Superquadric`."
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_Facet_Superquadric_SuperquadricGeom);

} // namespace yade
