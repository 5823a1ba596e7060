// YADE's side of the elastoplastic contact law; the law itself is in pkg/mechanics/ElastoplasticContact.hpp and IncrementalSpring.hpp.
#pragma once

#include "CurvatureLaw.hpp"
#include "ElastoplasticPhys.hpp"
#include "EnergyEntries.hpp"

#include <pkg/mechanics/IncrementalSpring.hpp>

namespace yade {

class Law2_ScGeom_ElastoplasticPhys_LoadingUnloading : public CurvatureLaw {
public:
	~Law2_ScGeom_ElastoplasticPhys_LoadingUnloading() override = default;
	FUNCTOR2D(ScGeom, ElastoplasticPhys);

	// Called by YADE after the attributes were set or loaded.
	void postLoad(Law2_ScGeom_ElastoplasticPhys_LoadingUnloading&) { checkOverlapLimit(overlapLimit); }

protected:
	Load respond(CurvaturePhys& phys, const ContactKinematics& bodies) override;

private:
	// A spring with a dashpot beside it.
	struct SpringAndDashpot {
		superquadric::SpringStep elastic;
		Vector3r viscous = Vector3r::Zero();

		Vector3r total() const { return elastic.spring.force + viscous; }
		Real lost() const { return elastic.slipWork + elastic.softening; }
	};
	struct Response {
		superquadric::elastoplastic::State normal;
		Real normalViscous;
		SpringAndDashpot tangential, rolling;
	};
	enum Energy {
		Elastic,
		Plastic,
		NormalViscous,
		TangentialViscous,
		Friction,
		RollingViscous,
		RollingFriction,
		ModelError,
	};

	Response response(const ElastoplasticPhys& phys, const ContactKinematics& bodies) const;
	SpringAndDashpot tangential(const ElastoplasticPhys& phys, const ContactKinematics& bodies, const superquadric::elastoplastic::State& normal) const;
	SpringAndDashpot rolling(const ElastoplasticPhys& phys, const ContactKinematics& bodies, const superquadric::elastoplastic::State& normal) const;
	void bookEnergy(const ElastoplasticPhys& before, const ContactKinematics& bodies, const Response& now);
	Real modelError(const ElastoplasticPhys& before, const ContactKinematics& bodies, const superquadric::elastoplastic::State& now) const;

	EnergyEntries energies { { "elastPotential", "yieldDissip", "normDampDissip", "shearDampDissip", "plastDissip", "rollingDampDissip", "rollingDissip",
		"nonconservative" } };

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_DEPREC_INIT_CTOR_PY(Law2_ScGeom_ElastoplasticPhys_LoadingUnloading, LawFunctor,
		"Contact law for spheres and superquadrics that yield, after Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39(8), 2018. All forces "
			"are those on body 2.\n\n"
		"* Normal force on four paths: elastic loading (Hertz), plastic loading, elastic unloading and reloading, further plastic loading. Until the "
			"contact yields it follows the local radius of curvature, bounded as in "
		":yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin`; then it keeps the one with which it yielded. When the bodies part, the contact forgets.\n"
		"* Its viscous part $2 C_n\\sqrt{m^* k_n}v_n$, with the tangent stiffness $k_n$ of the unloading branch, acts on the elastic paths only and "
			"never makes the whole attractive.\n"
		"* Tangential force: Mindlin's, in increments $-k_s\\,\\Delta u$ with $k_s=k_n$/stiffnessRatio. It turns with the contact, falls in "
			"proportion when $k_s$ falls (Thornton, Cummins & Cleary 2013), and slips at $\\mu f_n$ with the elastic normal force. "
		"Its viscous part $2 C_t\\sqrt{m k_s}v_t$ is cut where both together would exceed that limit.\n"
		"* Rolling: type C of Ai, Chen, Rotter & Ooi (2011), a spring of $k_r=2.25k_n(\\mu_r R)^2$ that slips at the couple $\\mu_r R f_n$, "
			"$1/R=1/R_1+1/R_2$, and a dashpot of rollingDamping $\\times 2\\sqrt{I_r k_r}$ that acts while it does not, with the "
		"inertia $I_r$ about the contact. Against the whole relative rotation, twisting included.\n\n"
		"With O.trackEnergy, O.energy has 'elastPotential' (stored now in all three springs) and the sums 'yieldDissip', 'normDampDissip', 'shearDampDissip', "
			"'plastDissip', 'rollingDampDissip', 'rollingDissip'. What the tangential and the rolling "
		"spring lose when their stiffness changes, never negative, counts as micro-slip with their friction. 'nonconservative' is what the normal "
			"force takes out (negative: puts in) because it has no potential: until the contact yields it "
		"follows the radius of curvature, and a rolling or sliding contact point changes the overlap a little other than the approach does. Kinetic "
			"energy plus all of these is constant up to the error of the time integration.",
		((Real, overlapLimit, superquadric::hertzMindlin::defaultOverlapLimit, Attr::triggerPostLoad, "Largest overlap the model is meant for, as a part of the smallest half size; between 0 "
			"and 1 [-]. It bounds the radius of curvature, see :yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin`."))
		((bool, effectiveMassAtContact, true, , "Whether $m^*$ of the normal damping counts that an off-centre push also turns the bodies, see "
			":yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin`."))
		, ((leverArms, effectiveMassAtContact, "renamed in 0.2"))
		, , postLoad(*this);,
			; thisScope.attr("Law2_ScGeom_ElastoplasticPhys_FourPath") = _classObj; // its name until 0.1
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Law2_ScGeom_ElastoplasticPhys_LoadingUnloading);

} // namespace yade
