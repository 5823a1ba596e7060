#pragma once

#include "HollowCylinder.hpp"

#include <core/Dispatching.hpp>

namespace yade {

class Bo1_HollowCylinder_Aabb : public BoundFunctor {
public:
	void go(const shared_ptr<Shape>& shape, shared_ptr<Bound>& bound, const Se3r& se3, const Body*) override;
	FUNCTOR1D(HollowCylinder);
	// clang-format off
	YADE_CLASS_BASE_DOC(Bo1_HollowCylinder_Aabb, BoundFunctor,
		"Creates/updates an :yref:`Aabb` of a :yref:`HollowCylinder`: its exact box. As with a :yref:`Wall`, a sheared periodic cell is an error."
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Bo1_HollowCylinder_Aabb);

} // namespace yade
