#include "Ig2_HollowCylinder_Superquadric_SuperquadricGeom.hpp"

#include <pkg/detection/WallContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_HollowCylinder_Superquadric_SuperquadricGeom));

bool Ig2_HollowCylinder_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto& cylinder = static_cast<const HollowCylinder&>(shape1);
	const auto body = static_cast<const Superquadric&>(shape2).placement(pair.state2, pair.shift2);
	if (!pair.mustBeKept() && HollowCylinder::distanceFromAxis(body.position, pair.state1) > cylinder.radius) return false;

	auto warm = pair.warmStart();
	const auto contact = superquadric::contactHollowCylinder(body, pair.state1.pos, HollowCylinder::axis(pair.state1), cylinder.radius, warm, solverCounters.ofThisThread()).reversed();
	if (!touches(contact) || !cylinder.spans(contact.surface2, pair.state1)) return pair.part(contact, warm);
	return pair.touch(contact, {}, sideOf(body, contact.surface2, contact.normal, contact.curvature2), warm);
}

} // namespace yade
