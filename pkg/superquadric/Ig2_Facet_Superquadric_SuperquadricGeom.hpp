#pragma once

#include "ContactFunctor.hpp"

#include <pkg/common/Facet.hpp>

namespace yade {

class Ig2_Facet_Superquadric_SuperquadricGeom : public ContactFunctor {
public:
	FUNCTOR2D(Facet, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Facet, Superquadric);
	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS(Ig2_Facet_Superquadric_SuperquadricGeom, IGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Facet`, a sheet without thickness that pushes to the side on which the "
		"particle's centre is, and a :yref:`Superquadric`. Each facet acts on its own: on a mesh, every facet that a flat face lies on pushes it by its border, "
		"so that the mesh is as many times too stiff. Where the particles only meet the mesh's flat parts and hollow corners, as inside a container, set borders to False.",
		((bool, borders, true, , "Whether the edges and corners of a facet push. When False a facet acts only where its inside is deepest in the particle: one contact on a flat mesh, "
			"but none on the free rim of a sheet and on ridges, which particles then pass."))
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_Facet_Superquadric_SuperquadricGeom);

} // namespace yade
