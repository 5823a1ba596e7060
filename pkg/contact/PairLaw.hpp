// A law that can be asked without an Interaction: by a loop that has the bodies' motion at hand.
#pragma once

#include <pkg/support/MovingBody.hpp>

#include <core/IPhys.hpp>

namespace yade {

class SuperquadricGeom;

class PairLaw {
public:
	virtual ~PairLaw() = default;
	// Two bodies that touch get their forces, the contact its physics. May run in several threads, on different contacts.
	virtual void act(const SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2) = 0;
};

} // namespace yade
