#include "SuperquadricGeom.hpp"

namespace yade {

YADE_PLUGIN((SuperquadricGeom));

superquadric::WarmStart SuperquadricGeom::warmStart() const
{
	superquadric::WarmStart warm;
	warm.kind = warmKind;
	warm.value = warmValue;
	warm.seenBy2 = warmSeenBy2;
	warm.supports = warmSupports;
	return warm;
}

void SuperquadricGeom::setWarmStart(const superquadric::WarmStart& warm)
{
	warmKind = warm.kind;
	warmValue = warm.value;
	warmSeenBy2 = warm.seenBy2;
	warmSupports = warm.supports;
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

void SuperquadricGeom::part(const superquadric::Contact& contact)
{
	touching = false;
	// Negative in any case: that is how YADE's own laws, too, know a contact that has ended.
	penetrationDepth = std::min(contact.overlap, -std::numeric_limits<Real>::min());
	shearInc = Vector3r::Zero();
}

} // namespace yade
