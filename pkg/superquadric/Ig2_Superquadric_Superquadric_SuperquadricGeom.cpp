#include "Ig2_Superquadric_Superquadric_SuperquadricGeom.hpp"

#include <pkg/geometry/Bounds.hpp>
#include <pkg/detection/PairContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_Superquadric_Superquadric_SuperquadricGeom));

bool Ig2_Superquadric_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto &superquadric1 = static_cast<const Superquadric&>(shape1), &superquadric2 = static_cast<const Superquadric&>(shape2);
	auto& counters = solverCounters.ofThisThread();
	// Half of the pairs that the collider finds end here, before their rotations and their memory are even looked at.
	if (!pair.mustBeKept() && superquadric::boundingSpheresApart(superquadric1.solid(), superquadric2.solid(), pair.position2() - pair.state1.pos)) {
		++counters.solves;
		++counters.rejectedBySphere;
		return false;
	}
	const auto body1 = superquadric1.placement(pair.state1), body2 = superquadric2.placement(pair.state2, pair.shift2);
	auto warm = pair.warmStart();
	return describe(solveAt(body1, body2, warm), body1, body2, pair, warm);
}

superquadric::Contact Ig2_Superquadric_Superquadric_SuperquadricGeom::solveAt(
        const superquadric::Placement& body1, const superquadric::Placement& body2, superquadric::WarmStart& warm)
{
	return superquadric::contactPair(body1, body2, warm, solverCounters.ofThisThread());
}

bool Ig2_Superquadric_Superquadric_SuperquadricGeom::describe(const superquadric::Contact& contact, const superquadric::Placement& body1,
        const superquadric::Placement& body2, const ContactPair& pair, const superquadric::WarmStart& warm)
{
	if (!touches(contact)) return pair.part(contact, warm);
	return pair.touch(contact, sideOf(body1, contact.surface1, contact.normal, contact.curvature1),
	        sideOf(body2, contact.surface2, contact.normal, contact.curvature2), warm);
}

} // namespace yade
