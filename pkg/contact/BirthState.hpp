// The state of a body that knows when it came to be: fragments overlap their neighbours from birth, and the law asks when that was.
#pragma once

#include <core/State.hpp>

namespace yade {

class BirthState : public State {
public:
	~BirthState() override = default;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR(BirthState, State,
		"State of a body that may have come to be during the run. In a contact that begins in the step of a body's birth, the overlap that is there "
			"already has no force, see :yref:`CurvaturePhys.restOverlap`.",
		((long, birthStep, -1, Attr::readonly, "O.iter when it came to be by breakage; -1: not by breakage."))
		, createIndex();
	);
	// clang-format on
	REGISTER_CLASS_INDEX(BirthState, State);
};
REGISTER_SERIALIZABLE(BirthState);

} // namespace yade
