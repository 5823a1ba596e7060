// A law that can be asked without an Interaction: by a loop that has the bodies' motion at hand.
#pragma once

#include <pkg/support/MovingBody.hpp>

#include <core/IPhys.hpp>

namespace yade {

class SuperquadricGeom;

// What a contact does to its two bodies.
struct ContactLoad {
	Vector3r force; // on body 2; body 1 gets the opposite [N]
	Vector3r torque1, torque2; // about the bodies' positions [N m]
};

class MovingBodiesLaw {
public:
	virtual ~MovingBodiesLaw() = default;
	// Of two bodies that touch; updates the physics. May run in several threads, on different contacts.
	virtual ContactLoad load(SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2) = 0;
};

} // namespace yade
