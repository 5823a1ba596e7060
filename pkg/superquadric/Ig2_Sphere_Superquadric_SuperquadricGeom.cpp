#include "Ig2_Sphere_Superquadric_SuperquadricGeom.hpp"

#include <pkg/detection/PairContact.hpp>

namespace yade {

YADE_PLUGIN((Ig2_Sphere_Superquadric_SuperquadricGeom));

namespace {
	// Most spheres met one after the other are equal, and making a shape costs as much as asking it.
	const superquadric::Shape& sphereOf(Real radius)
	{
		thread_local superquadric::Shape sphere(Vector3r::Ones(), 2, 2);
		if (sphere.halfSizes().x() != radius) sphere = superquadric::Shape(Vector3r::Constant(radius), 2, 2);
		return sphere;
	}
}

bool Ig2_Sphere_Superquadric_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const Real radius = static_cast<const Sphere&>(shape1).radius;
	// Without the sphere's own rotation, under which the contact point does not move.
	const superquadric::Placement body1 { sphereOf(radius), pair.state1.pos, Matrix3r::Identity() };
	const auto body2 = static_cast<const Superquadric&>(shape2).placement(pair.state2, pair.shift2);
	auto warm = pair.warmStart();
	const auto contact = superquadric::contactPair(body1, body2, warm, solverCounters.ofThisThread());
	if (!touches(contact)) return pair.part(contact, warm);
	return pair.touch(contact, { 1 / radius, radius, radius }, sideOf(body2, contact.surface2, contact.normal, contact.curvature2), warm);
}

} // namespace yade
