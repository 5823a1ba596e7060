#include "Ig2_Facet_Superquadric_SuperquadricGeom.hpp"

#include <core/Omega.hpp>
#include <pkg/detection/WallContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_Facet_Superquadric_SuperquadricGeom));

void Ig2_Facet_Superquadric_SuperquadricGeom::findNeighbours()
{
	neighbours.find(*Omega::instance().getScene(), /*again*/ true);
}

bool Ig2_Facet_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto facet = meshFacet(static_cast<const Facet&>(shape1), pair.state1, pair.interaction->getId1());
	const auto body = static_cast<const Superquadric&>(shape2).placement(pair.state2, pair.shift2);
	auto& counters = solverCounters.ofThisThread();
	auto warm = pair.warmStart();
	const auto contact = superquadric::contactTriangle(body, facet.vertices, warm, counters);
	if (!touches(contact) || !pushes(body, facet, contact, *pair.scene, counters)) return pair.part(contact.reversed(), warm);
	return pair.touch(contact.reversed(), {}, sideOf(body, contact.surface1, contact.normal, contact.curvature1), warm);
}

bool Ig2_Facet_Superquadric_SuperquadricGeom::pushes(const superquadric::Placement& body, const superquadric::MeshFacet& facet,
        const superquadric::Contact& contact, const Scene& scene, superquadric::SolverCounters& counters)
{
	if (superquadric::farFromBorder(body, facet, contact.point)) return true;
	neighbours.find(scene);
	return superquadric::pushesAmong(body, facet, contact, neighbours.of(facet, scene), counters);
}

} // namespace yade
