#include "ParticleContacts.hpp"

#include <pkg/contact/CurvaturePhys.hpp>
#include <pkg/dem/ScGeom.hpp>

namespace yade {

ParticleContacts::ParticleContacts(const Body& body, const Scene& scene)
{
	for (const auto& [other, interaction] : body.intrs) {
		if (!interaction->isReal()) continue;
		const auto* phys = dynamic_cast<const CurvaturePhys*>(interaction->phys.get());
		const auto* geom = dynamic_cast<const ScGeom*>(interaction->geom.get());
		if (!phys || !geom) continue;
		const bool second = interaction->getId2() == body.getId();
		Vector3r centre = body.state->pos;
		if (second && scene.isPeriodic) centre += scene.cell->intrShiftPos(interaction->cellDist);
		const Vector3r force = phys->normalForce + phys->shearForce; // on body 2
		contacts.push_back({ *phys, geom->contactPoint - centre, second ? force : Vector3r(-force) });
	}
}

Real ParticleContacts::largestForce() const
{
	Real largest = 0;
	for (const Contact& contact : contacts)
		largest = std::max(largest, contact.force.norm());
	return largest;
}

Matrix3r ParticleContacts::stressSum() const
{
	Matrix3r sum = Matrix3r::Zero();
	for (const Contact& contact : contacts)
		sum += contact.lever * contact.force.transpose();
	return sum;
}

Real ParticleContacts::storedEnergy() const
{
	Real sum = 0;
	for (const Contact& contact : contacts)
		sum += contact.phys.storedEnergy();
	return sum;
}

Real ParticleContacts::deepest() const
{
	Real largest = 0;
	for (const Contact& contact : contacts)
		largest = std::max(largest, contact.phys.overlap + contact.phys.restOverlap);
	return largest;
}

} // namespace yade
