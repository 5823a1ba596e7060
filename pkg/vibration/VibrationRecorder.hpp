// Time series of a vibrating box and of the particles in it.
#pragma once

#include "VibratingBoxEngine.hpp"

#include <pkg/common/PeriodicEngines.hpp>

namespace yade {

class VibrationRecorder : public PeriodicEngine {
public:
	void action() override;

private:
	// Centre of mass of the particles and its velocity.
	std::pair<Vector3r, Vector3r> centroid() const;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS(VibrationRecorder, PeriodicEngine,
		"Records the motion of a :yref:`VibratingBoxEngine` and of the centre of mass of particles, as often as :yref:`PeriodicEngine` is told to "
			"(iterPeriod), in lists that grow together. It goes into O.engines after "
		":yref:`NewtonIntegrator`: positions and velocities are then those in the middle of the step, in which the leap-frog has both to second "
			"order; times are to match. The lists are saved with the scene; without particles the centre of mass stays zero.",
		((shared_ptr<VibratingBoxEngine>, box, , , "The box."))
		((std::vector<int>, particles, , , "Ids of the particles; bodies that are not there raise ValueError."))
		((std::vector<Real>, times, , , "Simulated time [s]."))
		((std::vector<Vector3r>, boxDisplacement, , , "Displacement of the box [m]."))
		((std::vector<Vector3r>, boxVelocity, , , "[m/s]"))
		((std::vector<Vector3r>, centroidPosition, , , "Centre of mass of the particles in the scene's axes [m]."))
		((std::vector<Vector3r>, centroidVelocity, , , "[m/s]"))
		((std::vector<Vector3r>, contactForce, , , "Force of the contacts on the box [N]: its mean since the record before, so that no blow is "
			"missed."))
		((Vector3r, lastImpulse, Vector3r::Zero(), Attr::hidden, "The box's contactImpulse at the record before [N s]."))
		((Real, lastTime, NaN, Attr::hidden, "Time of the record before [s]; NaN: there is none."))
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(VibrationRecorder);

} // namespace yade
