#include "CurvatureMat.hpp"

#include <lib/high-precision/Constants.hpp>
#include <pkg/mechanics/HertzMindlin.hpp>
#include <pkg/support/Checks.hpp>

namespace yade {

YADE_PLUGIN((CurvatureMat));

Real CurvatureMat::criticalTimeStep(Real minHalfSize) const
{
	requirePositive("minHalfSize", minHalfSize);
	return superquadric::hertzMindlin::criticalTimeStep(minHalfSize, young, poisson, density);
}

AcceptedAttributes::References CurvatureMat::checkedAttributes()
{
	return { &density, &young, &poisson, &frictionAngle, &normalDamping, &tangentialDamping, &rollingFriction };
}

void CurvatureMat::check() const
{
	requirePositive("density", density);
	requirePositive("young", young);
	if (!(poisson > -1 && poisson < 0.5)) refuse("poisson", "between -1 and 0.5", poisson);
	if (!(frictionAngle >= 0 && frictionAngle < Mathr::PI / 2)) refuse("frictionAngle", "within [0, pi/2)", frictionAngle);
	if (!(normalDamping >= 0 && normalDamping < 1)) refuse("normalDamping", "within [0, 1)", normalDamping);
	requireNotNegative("tangentialDamping", tangentialDamping);
	requireNotNegative("rollingFriction", rollingFriction);
}

void CurvatureMat::postLoad(CurvatureMat&)
{
	accepted.accept(checkedAttributes(), [this] { check(); });
}

} // namespace yade
