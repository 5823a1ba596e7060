// What an elastoplastic contact remembers: dents, springs, and the numbers of the material that yields.
#pragma once

#include "CurvaturePhys.hpp"

#include <pkg/mechanics/ElastoplasticContact.hpp>

#include <limits>

namespace yade {

class ElastoplasticPhys : public CurvaturePhys {
public:
	~ElastoplasticPhys() override = default;
	Real storedEnergy() const override;

	superquadric::elastoplastic::Material plasticity() const
	{
		return { yieldStress, { referenceRadius, m0, m1, m2, exponent, smallestRatio, largestRatio } };
	}
	void setPlasticity(const superquadric::elastoplastic::Material& material);
	// History{} until the contact has yielded.
	superquadric::elastoplastic::History history() const;
	void setHistory(const superquadric::elastoplastic::History& history);

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR(ElastoplasticPhys, CurvaturePhys,
		"Physics of a contact under :yref:`Law2_ScGeom_ElastoplasticPhys_LoadingUnloading`. kn is the tangent stiffness of the unloading branch, the largest "
			"one at this overlap, ks = kn/stiffnessRatio; shearDisplacement is the stretch of the "
		"tangential spring, shearEnergy its energy.",
		((Real, yieldStress, std::numeric_limits<Real>::infinity(), Attr::readonly, "Of the material that yields, as are the numbers of its "
			"hardening; see :yref:`ElastoplasticMat` [Pa]."))
		((Real, referenceRadius, NaN, Attr::readonly, "[m]"))
		((Real, m0, NaN, Attr::readonly, "[-]"))
		((Real, m1, NaN, Attr::readonly, "[-]"))
		((Real, m2, NaN, Attr::readonly, "[-]"))
		((Real, exponent, NaN, Attr::readonly, "[-]"))
		((Real, smallestRatio, NaN, Attr::readonly, "[-]"))
		((Real, largestRatio, NaN, Attr::readonly, "[-]"))
		((Real, rollingDamping, 0, Attr::readonly, "Part of the critical damping of rolling [-]."))
		((Real, curveModulus, 0, Attr::readonly, "$E^*$ of the loading curve: once the contact has yielded, that of the step when it did [Pa]. "
			"|yupdate|"))
		((Real, curveRadius, 0, Attr::readonly, "$R$ of the loading curve: once the contact has yielded, that of the step when it did [m]. "
			"|yupdate|"))
		((Real, largestOverlap, 0, Attr::readonly, "$d_{max}$ of a contact that has yielded; the overlap before [m]. |yupdate|"))
		((Real, residualOverlap, 0, Attr::readonly, "$d_R$, where the force ends on unloading; zero until the contact has yielded [m]. |yupdate|"))
		((Real, plasticDissipation, 0, Attr::readonly, "Plastic work of this contact so far [J]. |yupdate|"))
		((Vector3r, shearElastic, Vector3r::Zero(), Attr::readonly, "Elastic part of shearForce [N]. |yupdate|"))
		((Vector3r, rollingElastic, Vector3r::Zero(), Attr::readonly, "Elastic part of rollingCouple in the contact plane [N m]. |yupdate|"))
		((Real, twistingElastic, 0, Attr::readonly, "Elastic part of rollingCouple along the normal [N m]. |yupdate|"))
		((Vector3r, rollingViscous, Vector3r::Zero(), Attr::readonly, "Viscous part of rollingCouple [N m]. |yupdate|"))
		((Real, rollingStiffness, 0, Attr::readonly, "$k_r$ [N m/rad]. |yupdate|"))
		, createIndex();
	);
	// clang-format on
	REGISTER_CLASS_INDEX(ElastoplasticPhys, CurvaturePhys);
};
REGISTER_SERIALIZABLE(ElastoplasticPhys);

} // namespace yade
