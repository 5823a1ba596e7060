// What a contact of two CurvatureMat bodies remembers: its stiffness and damping, and the history of its tangential displacement.
#pragma once

#include <pkg/dem/FrictPhys.hpp>

namespace yade {

class CurvaturePhys : public FrictPhys {
public:
	~CurvaturePhys() override = default;

	// Of all its springs, as in O.energy['elastic'] [J].
	virtual Real storedEnergy() const;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(CurvaturePhys, FrictPhys,
		"Physics of a contact under :yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin`. All forces are those on body 2 (the opposite acts on body 1). "
			"normalForce and shearForce are "
		"the whole forces, viscous parts included; kn is the tangent stiffness of the normal force and ks that of the tangential force before slip, "
			"its upper bound.",
		((Real, effectiveModulus, NaN, Attr::readonly, "Effective modulus $E^*$ [Pa]."))
		((Real, stiffnessRatio, NaN, Attr::readonly, "Ratio kn/ks of normal to tangential stiffness, $(2-\\nu)/(2(1-\\nu))$ or its generalisation for "
			"unequal materials [-]."))
		((Real, normalDamping, NaN, Attr::readonly, "Coefficient $C_n$ of the viscous normal force [-]."))
		((Real, tangentialDamping, NaN, Attr::readonly, "Coefficient $C_t$ of the viscous tangential force [-]."))
		((Real, rollingFriction, NaN, Attr::readonly, "Coefficient $\\mu_r$ of rolling friction [-]."))
		((Real, effectiveMass, NaN, Attr::readonly, "$m^*=m_1m_2/(m_1+m_2)$, effective mass of the viscous tangential force in this step [kg]. |yupdate|"))
		((Real, normalMass, NaN, Attr::readonly, "Effective mass $m^*$ of the viscous normal force in this step, see "
			":yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin.effectiveMassAtContact` [kg]. |yupdate|"))
		((Real, effectiveRadius, NaN, Attr::readonly, "Effective radius $R^*$ in this step, from bounded curvatures [m]. |yupdate|"))
		((Real, hertzStiffness, 0, Attr::readonly, "Hertz's stiffness $K_n$ in this step [N/m^1.5]. |yupdate|"))
		((Real, overlap, 0, Attr::readonly, "Overlap in this step that the law counts, which is the geometry's less restOverlap [m]. |yupdate|"))
		((Real, restOverlap, 0, Attr::readonly, "Overlap without force: that which the bodies had when one of them came to be by breakage "
			"(:yref:`BreakageEngine`), in the same step as the contact; an overlap that falls below takes it along, it never grows. Zero of all "
			"other contacts [m]. |yupdate|"))
		((Vector3r, shearDisplacement, Vector3r::Zero(), Attr::readonly, "Tangential displacement of body 2 relative to body 1 since the contact "
			"began, less what slipped; turns with the contact [m]. |yupdate|"))
		((Vector3r, normalViscous, Vector3r::Zero(), Attr::readonly, "Viscous part of normalForce [N]. |yupdate|"))
		((Vector3r, shearViscous, Vector3r::Zero(), Attr::readonly, "Viscous part of shearForce [N]. |yupdate|"))
		((Vector3r, rollingCouple, Vector3r::Zero(), Attr::readonly, "Couple of rolling friction on body 2 [N m]. |yupdate|"))
		((Real, shearEnergy, 0, Attr::readonly, "Elastic energy of the tangential displacement in this step [J]. |yupdate|"))
		, createIndex();,
		.def("storedEnergy", &CurvaturePhys::storedEnergy, "Elastic energy of this contact in this step, of all its springs [J].")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(CurvaturePhys, FrictPhys);
};
REGISTER_SERIALIZABLE(CurvaturePhys);

} // namespace yade
