#include "Ig2_HollowCylinder_Sphere_SuperquadricGeom.hpp"

namespace yade {

YADE_PLUGIN((Ig2_HollowCylinder_Sphere_SuperquadricGeom));

namespace {

	superquadric::Contact contactOf(const HollowCylinder& cylinder, const State& state, const Vector3r& centre, Real radius)
	{
		const Vector3r axis = HollowCylinder::axis(state);
		const Vector3r foot = state.pos + axis.dot(centre - state.pos) * axis;
		const Real distance = (centre - foot).norm();
		// On the axis every direction is as good.
		const Vector3r outward = distance > 0 ? Vector3r((centre - foot) / distance) : Vector3r(state.ori * Vector3r::UnitX());

		superquadric::Contact contact;
		contact.normal = -outward;
		contact.surface1 = foot + cylinder.radius * outward;
		contact.surface2 = centre + radius * outward;
		contact.point = contact.middle();
		contact.overlap = distance + radius - cylinder.radius;
		contact.status = contact.overlap > 0 ? superquadric::Status::Overlap : superquadric::Status::Apart;
		contact.curvature2 = 1 / radius;
		return contact;
	}

} // namespace

bool Ig2_HollowCylinder_Sphere_SuperquadricGeom::solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair)
{
	const auto& cylinder = static_cast<const HollowCylinder&>(shape1);
	const Real radius = static_cast<const Sphere&>(shape2).radius;
	const Vector3r centre = pair.position2();
	if (!pair.mustBeKept() && HollowCylinder::distanceFromAxis(centre, pair.state1) > cylinder.radius) return false;

	const auto contact = contactOf(cylinder, pair.state1, centre, radius);
	if (!touches(contact) || !cylinder.spans(contact.surface2, pair.state1)) return pair.part(contact);
	return pair.touch(contact, {}, { contact.curvature2, radius, radius });
}

} // namespace yade
