#include "Ip2_CurvatureMat_CurvatureMat_CurvaturePhys.hpp"

#include "CurvaturePhys.hpp"
#include "ElastoplasticMat.hpp"

#include <core/Interaction.hpp>
#include <pkg/mechanics/HertzMindlin.hpp>

namespace yade {

YADE_PLUGIN((Ip2_CurvatureMat_CurvatureMat_CurvaturePhys));

void Ip2_CurvatureMat_CurvatureMat_CurvaturePhys::go(
        const shared_ptr<Material>& material1, const shared_ptr<Material>& material2, const shared_ptr<Interaction>& interaction)
{
	if (interaction->phys) return;
	for (const Material* material : { material1.get(), material2.get() }) {
		const auto* elastoplastic = dynamic_cast<const ElastoplasticMat*>(material);
		if (elastoplastic && elastoplastic->plasticity().yields())
			throw std::runtime_error("Ip2_CurvatureMat_CurvatureMat_CurvaturePhys: an ElastoplasticMat that yields needs "
			                         "Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys");
	}
	const auto phys = shared_ptr<CurvaturePhys>(new CurvaturePhys);
	combine(static_cast<const CurvatureMat&>(*material1), static_cast<const CurvatureMat&>(*material2), *phys);
	interaction->phys = phys;
}

void Ip2_CurvatureMat_CurvatureMat_CurvaturePhys::combine(const CurvatureMat& m1, const CurvatureMat& m2, CurvaturePhys& phys) const
{
	phys.effectiveModulus = superquadric::hertzMindlin::effectiveModulus(m1.young, m1.poisson, m2.young, m2.poisson);
	phys.stiffnessRatio = superquadric::hertzMindlin::stiffnessRatio(m1.young, m1.poisson, m2.young, m2.poisson);
	const Real angle = frictAngle ? (*frictAngle)(m1.id, m2.id, m1.frictionAngle, m2.frictionAngle) : std::min(m1.frictionAngle, m2.frictionAngle);
	phys.tangensOfFrictionAngle = std::tan(angle);
	phys.normalDamping = (m1.normalDamping + m2.normalDamping) / 2;
	phys.tangentialDamping = (m1.tangentialDamping + m2.tangentialDamping) / 2;
	phys.rollingFriction = std::min(m1.rollingFriction, m2.rollingFriction);
}

} // namespace yade
