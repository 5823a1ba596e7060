#include "VibrationRecorder.hpp"

#include <pkg/support/Checks.hpp>

namespace yade {

YADE_PLUGIN((VibrationRecorder));

void VibrationRecorder::action()
{
	if (!box) throw std::invalid_argument("VibrationRecorder: box = None: a VibratingBoxEngine is needed");
	const auto [position, velocity] = centroid();
	const Real halfStep = scene->dt / 2, elapsed = scene->time - lastTime;
	times.push_back(scene->time + halfStep);
	boxDisplacement.emplace_back(box->displacement - halfStep * box->velocity);
	boxVelocity.push_back(box->velocity);
	centroidPosition.emplace_back(position - halfStep * velocity);
	centroidVelocity.push_back(velocity);
	contactForce.push_back(elapsed > 0 ? Vector3r((box->contactImpulse - lastImpulse) / elapsed) : box->contactForce);
	lastImpulse = box->contactImpulse;
	lastTime = scene->time;
}

std::pair<Vector3r, Vector3r> VibrationRecorder::centroid() const
{
	Real mass = 0;
	Vector3r moment = Vector3r::Zero(), momentum = Vector3r::Zero();
	for (const Body::id_t id : particles) {
		if (!scene->bodies->exists(id)) refuse("particles", "bodies in the scene", id);
		const State& state = *(*scene->bodies)[id]->state;
		mass += state.mass;
		moment += state.mass * state.pos;
		momentum += state.mass * state.vel;
	}
	if (!(mass > 0)) return { Vector3r::Zero(), Vector3r::Zero() };
	return { moment / mass, momentum / mass };
}

} // namespace yade
