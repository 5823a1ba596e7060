#pragma once

#include "SuperquadricGeomFunctor.hpp"
#include "HollowCylinder.hpp"

namespace yade {

class Ig2_HollowCylinder_Superquadric_SuperquadricGeom : public SuperquadricGeomFunctor {
public:
	FUNCTOR2D(HollowCylinder, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(HollowCylinder, Superquadric);

	// clang-format off
	YADE_CLASS_BASE_DOC(Ig2_HollowCylinder_Superquadric_SuperquadricGeom, SuperquadricGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`HollowCylinder` and a :yref:`Superquadric`, whose deepest point is its farthest "
		"from the axis; there the normals of both agree."
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_HollowCylinder_Superquadric_SuperquadricGeom);

} // namespace yade
