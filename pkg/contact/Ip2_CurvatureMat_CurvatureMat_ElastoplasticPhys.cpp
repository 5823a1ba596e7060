#include "Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys.hpp"

#include "ElastoplasticPhys.hpp"

#include <core/Interaction.hpp>

namespace yade {

YADE_PLUGIN((Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys));

void Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys::go(
        const shared_ptr<Material>& material1, const shared_ptr<Material>& material2, const shared_ptr<Interaction>& interaction)
{
	if (interaction->phys) return;
	const auto phys = shared_ptr<ElastoplasticPhys>(new ElastoplasticPhys);
	combine(static_cast<const CurvatureMat&>(*material1), static_cast<const CurvatureMat&>(*material2), *phys);
	superquadric::elastoplastic::Material plasticity[2];
	Real damping = 0;
	for (const int i : { 0, 1 })
		if (const auto* material = dynamic_cast<const ElastoplasticMat*>((i == 0 ? material1 : material2).get())) {
			plasticity[i] = material->plasticity();
			damping += material->rollingDamping / 2;
		}
	phys->setPlasticity(softer(plasticity[0], plasticity[1]));
	phys->rollingDamping = damping;
	interaction->phys = phys;
}

} // namespace yade
