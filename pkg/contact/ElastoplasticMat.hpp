// The material of the elastoplastic contact: CurvatureMat with a yield stress and the hardening fitted to finite elements.
#pragma once

#include "CurvatureMat.hpp"

#include <pkg/mechanics/ElastoplasticContact.hpp>

#include <limits>

namespace yade {

class ElastoplasticMat : public CurvatureMat {
public:
	~ElastoplasticMat() override = default;
	superquadric::elastoplastic::Material plasticity() const;
	Real yieldPressure() const { return superquadric::elastoplastic::pressureAtYield * yieldStress; }

protected:
	void check() const override;
	AcceptedAttributes::References checkedAttributes() override;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(ElastoplasticMat, CurvatureMat,
		"Material for :yref:`Law2_ScGeom_ElastoplasticPhys_LoadingUnloading`, after Li, Gao, Zhang & Liu (2018): it yields at the mean pressure "
			"$1.6\\sigma_y$, and beyond hardens as "
		"$f_p/f_y=G(R/R_0)((a-a_y)/a_y)^H$ with $G(r)=m_0+m_1r+m_2r^2$. As for :yref:`CurvatureMat`, a refused value raises ValueError and the "
			"material stays as it was. The numbers of the hardening depend on each other and "
		"are checked as soon as yieldStress is finite, so give all of them in the constructor, or several at once by updateAttrs({...}), or "
			"yieldStress last.",
		((Real, yieldStress, std::numeric_limits<Real>::infinity(), Attr::triggerPostLoad, "$\\sigma_y$, positive and below Young's modulus [Pa]; "
			"infinite: never yields."))
		((Real, referenceRadius, superquadric::elastoplastic::Hardening().referenceRadius, Attr::triggerPostLoad, "$R_0$ of the fit, positive [m]."))
		((Real, m0, 0, Attr::triggerPostLoad, "$m_0$ [-]. $G$ must be positive at all radii of the fit."))
		((Real, m1, 0, Attr::triggerPostLoad, "$m_1$ [-]."))
		((Real, m2, 0, Attr::triggerPostLoad, "$m_2$ [-]."))
		((Real, exponent, 0, Attr::triggerPostLoad, "$H$, between 0 and 3 [-]."))
		((Real, smallestRatio, superquadric::elastoplastic::Hardening().smallestRatio, Attr::triggerPostLoad, "Smallest $R/R_0$ of the fit, positive; below, $G$ stays as it is there [-]."))
		((Real, largestRatio, superquadric::elastoplastic::Hardening().largestRatio, Attr::triggerPostLoad, "Largest $R/R_0$ of the fit, at least the smallest; above, $G$ stays as it is there [-]."))
		((Real, rollingDamping, 0, Attr::triggerPostLoad, "Damping of rolling as a part of the critical one, not negative [-]."))
		, createIndex(); postLoad(*this);,
		.add_property("yieldPressure", &ElastoplasticMat::yieldPressure, "Mean pressure at which a contact yields, $1.6\\sigma_y$ [Pa]; infinite where it never "
			"does.")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(ElastoplasticMat, CurvatureMat);
};
REGISTER_SERIALIZABLE(ElastoplasticMat);

} // namespace yade
