#pragma once

#include "SuperquadricGeomFunctor.hpp"

#include <pkg/common/Wall.hpp>

namespace yade {

class Ig2_Wall_Superquadric_SuperquadricGeom : public SuperquadricGeomFunctor {
public:
	FUNCTOR2D(Wall, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Wall, Superquadric);

	// clang-format off
	YADE_CLASS_BASE_DOC(Ig2_Wall_Superquadric_SuperquadricGeom, SuperquadricGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Wall` and a :yref:`Superquadric`, whose contact point is the wall's point "
		"deepest in the particle, drawn towards the particle's middle as far as the depth allows: it moves continuously when a flat face comes to "
			"lie on the wall. With "
		":yref:`sense<Wall.sense>` 0 the wall pushes to the side on which the particle's centre is, else to the side named; there a contact can "
		"begin only when the centre is on that side."
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_Wall_Superquadric_SuperquadricGeom);

} // namespace yade
