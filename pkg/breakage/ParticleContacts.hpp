// All contacts of one particle, as breakage sees them. They are visited in the order of the partners' ids: sums do not depend on the history of the
// scene's list of interactions.
#pragma once

#include <core/Scene.hpp>

namespace yade {

class CurvaturePhys;
class ScGeom;

class ParticleContacts {
public:
	ParticleContacts(const Body& body, const Scene& scene);

	Real largestForce() const; // [N]
	Matrix3r stressSum() const; // sum of lever times force, which is the volume times the mean stress [N m]
	Real storedEnergy() const; // [J]
	Real deepest() const; // the largest overlap, that at rest included [m]

private:
	struct Contact {
		const CurvaturePhys& phys;
		Vector3r lever; // from the particle's centre [m]
		Vector3r force; // on the particle [N]
	};
	std::vector<Contact> contacts;
};

} // namespace yade
