#include "Ip2_CurvatureMat_CurvatureMat_CurvaturePhys.hpp"

#include "CurvaturePhys.hpp"

#include <core/Interaction.hpp>
#include <pkg/geometry/HertzMindlin.hpp>

namespace yade {

YADE_PLUGIN((Ip2_CurvatureMat_CurvatureMat_CurvaturePhys));

void Ip2_CurvatureMat_CurvatureMat_CurvaturePhys::go(
        const shared_ptr<Material>& material1, const shared_ptr<Material>& material2, const shared_ptr<Interaction>& interaction)
{
	if (interaction->phys) return;
	const auto& m1 = static_cast<const CurvatureMat&>(*material1);
	const auto& m2 = static_cast<const CurvatureMat&>(*material2);
	const auto phys = shared_ptr<CurvaturePhys>(new CurvaturePhys);
	phys->effectiveModulus = superquadric::hertzMindlin::effectiveModulus(m1.young, m1.poisson, m2.young, m2.poisson);
	phys->stiffnessRatio = superquadric::hertzMindlin::stiffnessRatio(m1.young, m1.poisson, m2.young, m2.poisson);
	const Real angle = frictAngle ? (*frictAngle)(m1.id, m2.id, m1.frictionAngle, m2.frictionAngle) : std::min(m1.frictionAngle, m2.frictionAngle);
	phys->tangensOfFrictionAngle = std::tan(angle);
	phys->normalDamping = (m1.normalDamping + m2.normalDamping) / 2;
	phys->tangentialDamping = (m1.tangentialDamping + m2.tangentialDamping) / 2;
	phys->rollingFriction = std::min(m1.rollingFriction, m2.rollingFriction);
	interaction->phys = phys;
}

} // namespace yade
