#include "Ig2_Superquadric_Superquadric_SuperquadricGeom.hpp"

#include <pkg/geometry/Bounds.hpp>
#include <pkg/geometry/PairContact.hpp>

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
	const auto contact = superquadric::contactPair(body1, body2, warm, counters);
	if (!touches(contact)) return pair.part(contact, warm);
	return pair.touch(contact, sideOf(body1, contact.surface1, contact.normal, contact.curvature1),
	                  sideOf(body2, contact.surface2, contact.normal, contact.curvature2), warm);
}

} // namespace yade
