#include "BreakableParticle.hpp"

#include "ParticleContacts.hpp"

#include <pkg/common/Sphere.hpp>
#include <pkg/mechanics/OctahedralStress.hpp>
#include <pkg/superquadric/Superquadric.hpp>

namespace yade {

bool BreakableParticle::isBall() const { return dynamic_cast<const Sphere*>(body->shape.get()); }

superquadric::Shape BreakableParticle::solid() const
{
	if (const auto* sphere = dynamic_cast<const Sphere*>(body->shape.get())) return { Vector3r::Constant(sphere->radius), 2, 2 };
	return static_cast<const Superquadric&>(*body->shape).solid();
}

Real BreakableParticle::stress(const std::string& criterion, const Scene& scene) const
{
	const ParticleContacts contacts(*body, scene);
	if (criterion == "force") return contacts.largestForce() / (size * size);
	return superquadric::octahedralShearStress(contacts.stressSum() / volume);
}

} // namespace yade
