#include "SuperquadricGeom.hpp"

namespace yade {

YADE_PLUGIN((SuperquadricGeom));

superquadric::WarmStart SuperquadricGeom::warmStart() const
{
	superquadric::WarmStart warm;
	warm.kind = warmKind;
	warm.value = warmValue;
	return warm;
}

void SuperquadricGeom::setWarmStart(const superquadric::WarmStart& warm)
{
	warmKind = warm.kind;
	warmValue = warm.value;
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

} // namespace yade
