// From two materials to the parameters of their contact.
#pragma once

#include "CurvatureMat.hpp"

#include <core/Dispatching.hpp>
#include <pkg/common/MatchMaker.hpp>

namespace yade {

class CurvaturePhys;

class Ip2_CurvatureMat_CurvatureMat_CurvaturePhys : public IPhysFunctor {
public:
	~Ip2_CurvatureMat_CurvatureMat_CurvaturePhys() override = default;
	void go(const shared_ptr<Material>& material1, const shared_ptr<Material>& material2, const shared_ptr<Interaction>& interaction) override;
	FUNCTOR2D(CurvatureMat, CurvatureMat);

protected:
	void combine(const CurvatureMat& m1, const CurvatureMat& m2, CurvaturePhys& phys) const;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS(Ip2_CurvatureMat_CurvatureMat_CurvaturePhys, IPhysFunctor,
		"Creates :yref:`CurvaturePhys` when a contact begins. The paper has one material only; for two: $1/E^*=(1-\\nu_1^2)/E_1+(1-\\nu_2^2)/E_2$; "
			"the "
		"ratio of normal to tangential stiffness is $E^*/(4G^*)$ with $1/G^*=(2-\\nu_1)/G_1+(2-\\nu_2)/G_2$; the smaller sliding and the smaller "
		"rolling friction (the weaker "
			"partner "
		"yields first); the mean of the damping coefficients. Equal materials give the paper's formulas.",
		((shared_ptr<MatchMaker>, frictAngle, , , "How the angle of sliding friction follows from those of the materials [rad]; the smaller one if "
			"None. Its result must not be negative."))
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Ip2_CurvatureMat_CurvatureMat_CurvaturePhys);

} // namespace yade
