#include "Ig2_Facet_Superquadric_SuperquadricGeom.hpp"

#include <pkg/geometry/WallContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_Facet_Superquadric_SuperquadricGeom));

bool Ig2_Facet_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto& facet = static_cast<const Facet&>(shape1);
	const Matrix3r rotation = pair.state1.ori.toRotationMatrix();
	std::array<Vector3r, 3> vertices;
	for (int i = 0; i < 3; ++i)
		vertices[i] = pair.state1.pos + rotation * facet.vertices[i];

	const auto body = static_cast<const Superquadric&>(shape2).placement(pair.state2, pair.shift2);
	const auto contact = superquadric::contactTriangle(body, vertices, borders).reversed();
	if (!touches(contact)) return pair.part(contact);
	return pair.touch(contact, {}, sideOf(body, contact.surface2, contact.normal, contact.curvature2));
}

} // namespace yade
