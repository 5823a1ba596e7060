// YADE's side of the contact law of Wang & Ji (2018); the law itself is in pkg/mechanics/HertzMindlin.hpp.
#pragma once

#include "CurvatureLaw.hpp"
#include "EnergyEntries.hpp"

namespace yade {

class Law2_ScGeom_CurvaturePhys_HertzMindlin : public CurvatureLaw {
public:
	~Law2_ScGeom_CurvaturePhys_HertzMindlin() override = default;
	FUNCTOR2D(ScGeom, CurvaturePhys);

	// Called by YADE after the attributes were set or loaded.
	void postLoad(Law2_ScGeom_CurvaturePhys_HertzMindlin&) { checkOverlapLimit(overlapLimit); }

protected:
	Load respond(CurvaturePhys& phys, const ContactKinematics& bodies) override;

private:
	struct Response {
		superquadric::hertzMindlin::NormalForce normal;
		superquadric::hertzMindlin::TangentialForce tangential;
		Vector3r couple;
	};
	enum Energy {
		Elastic,
		Friction,
		NormalViscous,
		TangentialViscous,
		Rolling,
		ModelError,
	};

	Response response(const CurvaturePhys& phys, const ContactKinematics& bodies, Real rollingRadius) const;
	void bookEnergy(const CurvaturePhys& before, const ContactKinematics& bodies, const Response& now, Real hertz);

	EnergyEntries energies { { "elastPotential", "plastDissip", "normDampDissip", "shearDampDissip", "rollingDissip", "nonconservative" } };

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_DEPREC_INIT_CTOR_PY(Law2_ScGeom_CurvaturePhys_HertzMindlin, LawFunctor,
		"Contact law of [Wang2018]_ with the radius of curvature at the contact: for :yref:`Superquadric` and for YADE's :yref:`Sphere` "
			"alike, with each other and with walls. "
		"A partner that is neither is flat. What the paper leaves open:\n\n"
		"* radii of curvature are bounded, see overlapLimit;\n"
		"* the viscous part never makes the normal force attractive; viscous and elastic tangential force together obey Coulomb's limit $\\mu K_n "
			"d^{3/2}$;\n"
		"* the tangential displacement is a vector that turns with the contact; beyond $\\delta_{t,max}$ it slips and is shortened, also when "
			"$\\delta_{t,max}$ shrinks with the overlap;\n"
		"* the radius $R_i$ of rolling friction is the smaller radius of the two, which is the paper's for equal bodies and at a wall. The couple acts "
		"against the whole "
		"relative angular velocity, with opposite signs on both bodies, and never exceeds what stops that within one step;\n"
		"* bodies that cannot move (blocked or without mass) count as infinitely heavy in $m^*$.\n\n"
		"With O.trackEnergy, O.energy has: 'elastPotential' (stored now, normal and tangential); the sums 'plastDissip' (slip), 'normDampDissip', "
			"'shearDampDissip', 'rollingDissip'; and "
		"'nonconservative', what the elastic forces take out (negative: put in) because they have no potential: $K_n$ follows the radius of "
			"curvature and the tangential stiffness the overlap, and "
		"a rolling or sliding contact point changes the overlap a little other than the approach does. Kinetic energy plus these is constant up to "
			"the error of the time integration.",
		((Real, overlapLimit, superquadric::hertzMindlin::defaultOverlapLimit, Attr::triggerPostLoad, "Largest overlap the model is meant for, as a "
			"part of the smallest half size; between 0 "
			"and 1 [-]. It bounds the radius of curvature: at least that "
			"overlap (Hertz needs an overlap below the radius); and at most so large that at that overlap the disc of contact is as wide as the "
				"section of the body across the normal."))
		((bool, effectiveMassAtContact, true, , "Whether the effective mass $m^*$ of the viscous normal force counts that an off-centre push also turns "
			"the bodies: $1/m^* = \\sum "
			"1/m_i + \\mathbf{l}_i\\cdot I_i^{-1}\\mathbf{l}_i$ "
			"with the levers $\\mathbf{l}_i=(\\mathbf{x}_c-\\mathbf{x}_i)\\times\\mathbf{n}$. Then $C_n$ sets the restitution whatever the lever, "
				"which the paper's own check, a tilted cylinder with the restitution 0.85 at every angle, "
			"supposes. False: the paper's $m_1m_2/(m_1+m_2)$ to the letter, which damps eccentric impacts more. No difference for spheres."))
		, ((leverArms, effectiveMassAtContact, "renamed in 0.2"))
		, , postLoad(*this);,
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Law2_ScGeom_CurvaturePhys_HertzMindlin);

} // namespace yade
