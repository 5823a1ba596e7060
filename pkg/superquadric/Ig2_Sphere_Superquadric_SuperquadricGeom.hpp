#pragma once

#include "SuperquadricGeomFunctor.hpp"

#include <pkg/common/Sphere.hpp>

namespace yade {

class Ig2_Sphere_Superquadric_SuperquadricGeom : public SuperquadricGeomFunctor {
public:
	FUNCTOR2D(Sphere, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Sphere, Superquadric);

	// clang-format off
	YADE_CLASS_BASE_DOC(Ig2_Sphere_Superquadric_SuperquadricGeom, SuperquadricGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Sphere`, taken as the superquadric with n1 = n2 = 2, and a :yref:`Superquadric`."
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_Sphere_Superquadric_SuperquadricGeom);

} // namespace yade
