// What a contact law has to know of a body: where it is, how it moves, and what it sets against a push.
#pragma once

#include <core/Body.hpp>
#include <core/Scene.hpp>
#include <core/State.hpp>

namespace yade {

// How a point of a body moves. Velocities are those of half a step ago, which YADE's leap-frog integrator has; they are the ones that led to
// the present positions.
struct Motion {
	Vector3r position, velocity, spin; // of the body, or of its periodic image

	explicit Motion(const State& state, const Vector3r& shift = Vector3r::Zero(), const Vector3r& shiftVelocity = Vector3r::Zero())
	        : position(state.pos + shift)
	        , velocity(state.vel + shiftVelocity)
	        , spin(state.angVel)
	{
	}
	Vector3r velocityAt(const Vector3r& point) const { return velocity + spin.cross(point - position); }
};

// A member of a clump moves, and resists, with the clump. What is blocked or has no mass cannot be moved: it counts as infinitely heavy.
struct MovingBody : Motion {
	Body::id_t id;
	Vector3r centreOfMass;
	Matrix3r axes; // principal axes of inertia, as columns
	Real inverseMass; // 0 when it cannot be moved [1/kg]
	Vector3r inverseInertia; // about those axes; 0 when it cannot be turned [1/(kg m^2)]

	MovingBody(const Body& body, const Scene& scene, const Vector3r& shift = Vector3r::Zero(), const Vector3r& shiftVelocity = Vector3r::Zero());

	// 1/m + l.I^-1 l with the lever l of a push at a point along a unit vector [1/kg].
	Real inverseMassAgainst(const Vector3r& point, const Vector3r& push) const
	{
		const Vector3r lever = axes.transpose() * (point - centreOfMass).cross(push);
		return inverseMass + lever.cwiseAbs2().dot(inverseInertia);
	}
	// Of the smallest principal moment [1/(kg m^2)].
	Real largestInverseInertia() const { return inverseInertia.maxCoeff(); }
};

} // namespace yade
