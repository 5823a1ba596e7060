#include "SuperquadricGeom.hpp"

namespace yade {

YADE_PLUGIN((SuperquadricGeom));

void SuperquadricGeom::touch(const superquadric::Contact& contact, const Side& side1, const Side& side2, const Vector3r& normalBefore,
        const Motion& motion1, const Motion& motion2, Real dt)
{
	touching = true;
	curvature1 = side1.curvature;
	curvature2 = side2.curvature;
	sectionRadius1 = side1.sectionRadius;
	sectionRadius2 = side2.sectionRadius;
	smallestHalfSize1 = side1.smallestHalfSize;
	smallestHalfSize2 = side2.smallestHalfSize;
	contactPoint = contact.middle();
	penetrationDepth = contact.overlap;
	turn = normalBefore.cross(contact.normal);
	twist = dt * 0.5 * normalBefore.dot(motion1.spin + motion2.spin) * normalBefore;
	normal = contact.normal;
	const Vector3r velocity = motion2.velocityAt(contactPoint) - motion1.velocityAt(contactPoint);
	shearInc = dt * (velocity - normal.dot(velocity) * normal);
}

void SuperquadricGeom::part(const superquadric::Contact& contact)
{
	touching = false;
	// Negative in any case: that is how YADE's own laws, too, know a contact that has ended.
	penetrationDepth = std::min(contact.overlap, -std::numeric_limits<Real>::min());
	shearInc = Vector3r::Zero();
}

boost::python::tuple SuperquadricGeom::warmStartAsTuple() const
{
	using superquadric::WarmStart;
	return boost::python::make_tuple(warm.kind == WarmStart::Point ? "point" : (warm.kind == WarmStart::Direction ? "direction" : "none"), warm.value);
}

} // namespace yade
