#include "MovingBody.hpp"

namespace yade {

namespace {
	const State& moving(const Body& body, const Scene& scene) { return body.isClumpMember() ? *(*scene.bodies)[body.clumpId]->state : *body.state; }
	Real inverse(Real value) { return value > 0 ? 1 / value : 0; }
}

MovingBody::MovingBody(const Body& body, const Scene& scene, const Vector3r& shift, const Vector3r& shiftVelocity)
        : Motion(*body.state, shift, shiftVelocity)
        , id(body.getId())
{
	const State& state = moving(body, scene);
	centreOfMass = state.pos + shift;
	axes = state.ori.toRotationMatrix();
	const bool held = (state.blockedDOFs & State::DOF_XYZ) == State::DOF_XYZ, turns = (state.blockedDOFs & State::DOF_RXRYRZ) != State::DOF_RXRYRZ;
	inverseMass = held ? 0 : inverse(state.mass);
	inverseInertia = turns ? state.inertia.unaryExpr(&inverse) : Vector3r(Vector3r::Zero());
}

} // namespace yade
