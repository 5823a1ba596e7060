// What a breakable particle carries: its own strength and where it comes from.
#pragma once

#include <pkg/contact/BirthState.hpp>

namespace yade {

class BreakableState : public BirthState {
public:
	~BreakableState() override = default;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR(BreakableState, BirthState,
		"State of a body of :yref:`BreakableMat`, made with it. :yref:`BreakageEngine` draws the strength when it first sees the body; ids are never "
			"used twice in a scene, so that ancestry can be followed.",
		((Real, strength, NaN, , "Of this particle, in the measure of :yref:`BreakageEngine.criterion` [Pa]; positive, infinite: never breaks; NaN: "
			"not drawn yet. May be set."))
		((int, generation, 0, Attr::readonly, "0: not made by breakage, else one more than its parent's."))
		((int, parent, -1, Attr::readonly, "Id of the particle that it is a fragment of; -1: of none."))
		((int, ancestor, -1, Attr::readonly, "Id of the first particle that it is a fragment of, through all generations; -1: of none."))
		((Real, inertiaFactor, 1, Attr::readonly, "Mass and inertia over those of its volume and density, see :yref:`BreakageEngine.inertialSize` "
			"[-]."))
		, createIndex();
	);
	// clang-format on
	REGISTER_CLASS_INDEX(BreakableState, BirthState);
};
REGISTER_SERIALIZABLE(BreakableState);

} // namespace yade
