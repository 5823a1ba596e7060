// From two materials to the parameters of their contact, where one may yield.
#pragma once

#include "ElastoplasticMat.hpp"
#include "Ip2_CurvatureMat_CurvatureMat_CurvaturePhys.hpp"

namespace yade {

class Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys : public Ip2_CurvatureMat_CurvatureMat_CurvaturePhys {
public:
	~Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys() override = default;
	void go(const shared_ptr<Material>& material1, const shared_ptr<Material>& material2, const shared_ptr<Interaction>& interaction) override;
	FUNCTOR2D(CurvatureMat, CurvatureMat);

	// clang-format off
	YADE_CLASS_BASE_DOC(Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys, Ip2_CurvatureMat_CurvatureMat_CurvaturePhys,
		"Creates :yref:`ElastoplasticPhys` when a contact begins, for :yref:`ElastoplasticMat` and :yref:`CurvatureMat` (which never yields) in any "
			"combination. The contact yields as the material with the smaller yield stress "
		"does: both feel the same pressure. The damping of rolling is the mean of both, as that of the other dampings; all else is as in "
			":yref:`Ip2_CurvatureMat_CurvatureMat_CurvaturePhys`."
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Ip2_CurvatureMat_CurvatureMat_ElastoplasticPhys);

} // namespace yade
