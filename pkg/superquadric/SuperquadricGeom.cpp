#include "SuperquadricGeom.hpp"

namespace yade {

YADE_PLUGIN((SuperquadricGeom));

superquadric::WarmStart SuperquadricGeom::warmStart() const
{
	superquadric::WarmStart warm;
	warm.kind = warmKind;
	warm.value = warmValue;
	warm.seenBy2 = warmSeenBy2;
	warm.inBothFrames = warmInBothFrames;
	warm.drift = warmDrift;
	warm.supports = warmSupports;
	warm.shapes = warmShapes;
	return warm;
}

void SuperquadricGeom::setWarmStart(const superquadric::WarmStart& warm)
{
	warmKind = warm.kind;
	warmValue = warm.value;
	warmSeenBy2 = warm.seenBy2;
	warmInBothFrames = warm.inBothFrames;
	warmDrift = warm.drift;
	warmSupports = warm.supports;
	warmShapes = warm.shapes;
}

void SuperquadricGeom::setSides(const Side& side1, const Side& side2)
{
	curvature1 = side1.curvature;
	curvature2 = side2.curvature;
	sectionRadius1 = side1.sectionRadius;
	sectionRadius2 = side2.sectionRadius;
	smallestHalfSize1 = side1.smallestHalfSize;
	smallestHalfSize2 = side2.smallestHalfSize;
}

void SuperquadricGeom::noteTurn(const Vector3r& normalBefore, const Vector3r& spinSum, Real dt)
{
	turn = normalBefore.cross(normal);
	twist = dt * 0.5 * normalBefore.dot(spinSum) * normalBefore;
}

void SuperquadricGeom::follow(const superquadric::Contact& contact, const Motion& motion1, const Motion& motion2, Real dt)
{
	const Vector3r normalBefore = normal;
	contactPoint = contact.middle();
	penetrationDepth = contact.overlap;
	normal = contact.normal;
	noteTurn(normalBefore, motion1.spin + motion2.spin, dt);
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

} // namespace yade
