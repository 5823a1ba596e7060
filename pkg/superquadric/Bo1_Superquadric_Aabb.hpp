#pragma once

#include "Superquadric.hpp"

#include <core/Dispatching.hpp>

namespace yade {

class Bo1_Superquadric_Aabb : public BoundFunctor {
public:
	void go(const shared_ptr<Shape>& shape, shared_ptr<Bound>& bound, const Se3r& se3, const Body*) override;
	FUNCTOR1D(Superquadric);
	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS(Bo1_Superquadric_Aabb, BoundFunctor,
		"Creates/updates an :yref:`Aabb` of a :yref:`Superquadric`: the box of its bounding sphere. YADE's colliders run again after "
		"translations only, so the box must hold the body however it turns meanwhile.",
		((Real, aabbEnlargeFactor, -1, , "Relative enlargement of the bounding box; deactivated if negative."))
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Bo1_Superquadric_Aabb);

} // namespace yade
