#include "Ig2_Superquadric_Superquadric_SuperquadricGeom.hpp"

#include <pkg/geometry/PairContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_Superquadric_Superquadric_SuperquadricGeom));

bool Ig2_Superquadric_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto body1 = static_cast<const Superquadric&>(shape1).placement(pair.state1);
	const auto body2 = static_cast<const Superquadric&>(shape2).placement(pair.state2, pair.shift2);
	auto warm = pair.warmStart();
	const auto contact = superquadric::contactPair(body1, body2, warm, solverCounters.ofThisThread());
	if (!touches(contact)) return pair.part(contact, warm);
	return pair.touch(contact, sideOf(body1, contact.surface1, contact.normal, contact.curvature1),
	                  sideOf(body2, contact.surface2, contact.normal, contact.curvature2), warm);
}

} // namespace yade
