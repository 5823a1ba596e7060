#include "Ig2_Wall_Superquadric_SuperquadricGeom.hpp"

#include <pkg/detection/WallContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_Wall_Superquadric_SuperquadricGeom));

bool Ig2_Wall_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto& wall = static_cast<const Wall&>(shape1);
	const auto body = static_cast<const Superquadric&>(shape2).placement(pair.state2, pair.shift2);
	const Real height = body.position[wall.axis] - pair.state1.pos[wall.axis];
	const int sense = wall.sense != 0 ? wall.sense : (height < 0 ? -1 : 1);
	if (!pair.mustBeKept() && sense * height < 0) return false;

	auto warm = pair.warmStart();
	const auto contact = superquadric::contactPlane(body, pair.state1.pos, sense * Vector3r::Unit(wall.axis), warm, solverCounters.ofThisThread()).reversed();
	if (!touches(contact)) return pair.part(contact, warm);
	return pair.touch(contact, {}, sideOf(body, contact.surface2, contact.normal, contact.curvature2), warm);
}

} // namespace yade
