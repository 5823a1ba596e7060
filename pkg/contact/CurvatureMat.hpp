// The material of the contact law of Wang & Ji (2018): FrictMat with damping and rolling friction.
#pragma once

#include <pkg/common/ElastMat.hpp>
#include <pkg/support/AcceptedAttributes.hpp>

namespace yade {

class CurvatureMat : public FrictMat {
public:
	~CurvatureMat() override = default;

	// Critical (Rayleigh) time step [s] for a smallest half size [m].
	Real criticalTimeStep(Real minHalfSize) const;

	// Called by YADE after the attributes were set or loaded. Refused values are put back before the error leaves.
	void postLoad(CurvatureMat&);

	// FrictMat's own attributes have no check behind them: Python sets them through this one.
	template <class Base, Real Base::* attribute> static void setInherited(CurvatureMat& material, Real value)
	{
		material.*attribute = value;
		material.callPostLoad();
	}
	template <class Base, Real Base::* attribute> static Real getInherited(const CurvatureMat& material) { return material.*attribute; }

protected:
	// Throws std::invalid_argument with name and value of what is wrong.
	virtual void check() const;
	// All that check() looks at.
	virtual AcceptedAttributes::References checkedAttributes();

private:
	AcceptedAttributes accepted;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(CurvatureMat, FrictMat,
		"Material for :yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin`, with the parameters of [Wang2018]_. A value that is refused raises ValueError "
			"naming "
		"the parameter and the value; the material then stays as it was. A change reaches contacts that begin after it.",
		((Real, normalDamping, 0, Attr::triggerPostLoad, "Coefficient $C_n$ of the viscous normal force, within [0, 1) [-]. The restitution is 0.847 "
			"for 0.05, 0.820 for 0.06 and "
			"0.725 for 0.1, at any speed."))
		((Real, tangentialDamping, 0, Attr::triggerPostLoad, "Coefficient $C_t$ of the viscous tangential force, not negative [-]."))
		((Real, rollingFriction, 0, Attr::triggerPostLoad, "Coefficient $\\mu_r$ of rolling friction, not negative [-]."))
		, createIndex(); postLoad(*this);,
		.add_property("density", &CurvatureMat::getInherited<Material, &Material::density>, &CurvatureMat::setInherited<Material, &Material::density>,
			"Density, positive [kg/m^3].")
		.add_property("young", &CurvatureMat::getInherited<ElastMat, &ElastMat::young>, &CurvatureMat::setInherited<ElastMat, &ElastMat::young>,
			"Young's modulus, positive [Pa].")
		.add_property("poisson", &CurvatureMat::getInherited<ElastMat, &ElastMat::poisson>, &CurvatureMat::setInherited<ElastMat, &ElastMat::poisson>,
			"Poisson's ratio, between -1 and 0.5 [-].")
		.add_property("frictionAngle", &CurvatureMat::getInherited<FrictMat, &FrictMat::frictionAngle>,
			&CurvatureMat::setInherited<FrictMat, &FrictMat::frictionAngle>,
			"Angle of sliding friction, the arc tangent of the friction coefficient $\\mu_s$, within [0, pi/2) [rad].")
		.def("criticalTimeStep", &CurvatureMat::criticalTimeStep, (boost::python::arg("minHalfSize")),
			"Critical (Rayleigh) time step $t_{max}$ [s] for the smallest half size among the particles [m]; steps of at most 0.1 $t_{max}$ are advised. "
			"ValueError unless "
				"minHalfSize is positive.")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(CurvatureMat, FrictMat);
};
REGISTER_SERIALIZABLE(CurvatureMat);

} // namespace yade
