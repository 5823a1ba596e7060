#pragma once

#include "SuperquadricGeomFunctor.hpp"
#include "HollowCylinder.hpp"

#include <pkg/common/Sphere.hpp>

namespace yade {

class Ig2_HollowCylinder_Sphere_SuperquadricGeom : public SuperquadricGeomFunctor {
public:
	FUNCTOR2D(HollowCylinder, Sphere);
	DEFINE_FUNCTOR_ORDER_2D(HollowCylinder, Sphere);
	// clang-format off
	YADE_CLASS_BASE_DOC(Ig2_HollowCylinder_Sphere_SuperquadricGeom, SuperquadricGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`HollowCylinder` and a :yref:`Sphere`, in closed form."
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_HollowCylinder_Sphere_SuperquadricGeom);

} // namespace yade
