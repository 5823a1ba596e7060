// Breaks particles into smaller ones: YADE's side of pkg/mechanics/Fragments.hpp, FragmentMotion.hpp and ParticleStress.hpp.
#pragma once

#include "BreakableParticle.hpp"

#include <core/Scene.hpp>
#include <pkg/common/PeriodicEngines.hpp>
#include <pkg/mechanics/FragmentMotion.hpp>
#include <pkg/support/AcceptedAttributes.hpp>

#include <optional>
#include <vector>

namespace yade {

class BreakageEngine : public PeriodicEngine {
public:
	void action() override;

	// Called by YADE after the attributes were set or loaded. Refused values are put back before the error leaves.
	void postLoad(BreakageEngine&);

	// The log as a list of dicts.
	boost::python::list events() const;

private:
	// A particle that breaks.
	struct Event {
		BreakableParticle parent;
		Real value; // of the criterion [Pa]
		bool forced;
	};

	AcceptedAttributes::References checkedAttributes();
	void check() const;
	void releaseErased();
	void checkOrder() const;

	std::vector<Event> collect();
	std::optional<BreakableParticle> candidate(Body& body);
	Real volumeOf(const Body& body);
	superquadric::fragments::Least least(const Body& body, Real size) const;
	bool canBeCut(const Body& body, Real size) const;
	std::vector<superquadric::fragments::Pieces> cutAll(const std::vector<Event>& events);
	superquadric::fragments::Pieces cut(const BreakableParticle& parent, int& even) const;
	void breakUp(const Event& event, const superquadric::fragments::Pieces& pieces);
	void checkLaws() const;
	void addInertia(Body& fragment, Real parentFactor) const;
	void checkFragments(const BreakableMat& material, const superquadric::Shape& shape, const superquadric::fragments::Pieces& pieces) const;
	void log(const Event& event, const superquadric::fragments::Pieces& pieces, Real elasticLoss, Real spinLoss);

	AcceptedAttributes accepted;
	// What has been erased since the last call. Bodies made by Python, and their shapes, which the contact loop holds for one more step, must be let
	// go with Python's lock.
	std::vector<shared_ptr<Body>> gone;
	std::vector<std::pair<long, Real>> volumes; // of superquadrics by id, with the shape's fingerprint; 0: not known yet [m^3]

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BreakageEngine, PeriodicEngine,
		"Breaks particles (:yref:`Sphere` and :yref:`Superquadric` of a :yref:`BreakableMat`, not members of clumps, not with all degrees of freedom "
			"blocked) whose stress has reached their strength: each is replaced by its fragments, after Zhao & Chi, "
		"J. Northeastern Univ. Nat. Sci. 44(3), 408 (2023). Mass, momentum, angular momentum and centre of mass stay, and no energy is created: what "
			"the parent's contacts had stored and what rotation loses is booked in O.energy['breakage'].\n\n"
		"It goes first into O.engines, before the collider: it judges by the contacts of the step before, and its fragments take part in the step at "
			"once. By default it is called at every step (iterPeriod = 1, initRun = True). "
		"The contact law must be one on the local curvature (:yref:`Law2_ScGeom_CurvaturePhys_HertzMindlin`, "
			":yref:`Law2_ScGeom_ElastoplasticPhys_LoadingUnloading`): contacts in which fragments are born start without force, see "
		":yref:`CurvaturePhys.restOverlap`.\n\n"
		"Strengths and cuts are drawn from seed and the particle's id alone: a run repeats, also from a saved scene. A value that is refused raises "
			"ValueError naming the parameter and the value; the engine then stays as it was.",
		((std::string, criterion, "octahedral", Attr::triggerPostLoad, "The stress that is held against :yref:`BreakableState.strength`. "
			"'octahedral': the octahedral shear stress $\\sqrt{(\\sigma_1-\\sigma_2)^2+(\\sigma_2-\\sigma_3)^2+(\\sigma_3-\\sigma_1)^2}/3$ "
			"of the particle's mean stress (McDowell & de Bono 2013). 'force': the largest force of its contacts over its size squared."))
		((std::string, mode, "cube", Attr::triggerPostLoad, "Fragments of a sphere. 'cube': eight balls with the volumes of the blocks into which "
			"three planes cut a cube through a random point; 'balls4', 'balls18': so many equal balls. Superquadrics know 'cube' only: "
			"eight superquadrics of the same exponents, each in its block of the parent's box."))
		((Real, cutExponent, 2, Attr::triggerPostLoad, "p: the cut's coordinates are $u^p$ with u uniform on (0, 1), positive [-]."))
		((Real, smallestFragment, 0, Attr::triggerPostLoad, "Size below which no fragment is made, of a superquadric none of its three widths, not "
			"negative [m]: a cut that would make one is drawn anew; a particle that cannot be cut without does not break. 0: as published; but a "
			"fragment whose critical time step is below O.dt raises ValueError at the call in which it would be made, unless a :yref:`TimeStepper` "
			"is active or inertialSize helps, and so does one with a half size below 1e-30 m."))
		((Real, inertialSize, 0, Attr::triggerPostLoad, "For quasi-static loading, from 0 to 1e30 [m]: fragments of a width w below it are born with "
			"$(inertialSize/w)^2$ times their mass and inertia, with which their critical time step is that of a width of inertialSize. "
			"Shape, volume, stiffness and velocity are their own; that factor is in :yref:`BreakableState.inertiaFactor`. Momentum and energy of "
				"motion are those of the true masses up to the birth, and grow by the factor then. 0: none."))
		((int, maxEvents, 100, Attr::triggerPostLoad, "Particles that break at one call, at least 1: those with the largest stress over strength; "
			"the others wait."))
		((int, seed, 0, Attr::triggerPostLoad, "Of strengths, cuts and orientations, not negative."))
		((std::vector<int>, forced, , , "Ids of particles that break at the next call whatever their stress is, maxEvents notwithstanding; then "
			"emptied. ValueError at that call for bodies that cannot break."))
		((int, waiting, 0, Attr::readonly, "Particles that had reached their strength at the last call and were left for the next."))
		((int, evenCuts, 0, Attr::readonly, "Cuts through the middle because no other was found without a fragment below smallestFragment, so far."))
		((int, spinGains, 0, Attr::readonly, "Events in which no arrangement was found that keeps the energy of rotation from growing, so far: to be "
			"0."))
		((std::vector<Real>, eventTimes, , Attr::readonly, "Of each event so far: O.time [s]; the lists up to childNumbers grow together. See "
			"events() for all as dicts."))
		((std::vector<int>, eventSteps, , Attr::readonly, "O.iter."))
		((std::vector<int>, eventParents, , Attr::readonly, "Id of the particle that broke."))
		((std::vector<int>, eventGenerations, , Attr::readonly, "Its generation."))
		((std::vector<Real>, eventSizes, , Attr::readonly, "Its size [m]."))
		((std::vector<Real>, eventValues, , Attr::readonly, "Its stress [Pa]."))
		((std::vector<Real>, eventStrengths, , Attr::readonly, "Its strength [Pa]."))
		((std::vector<Real>, eventElasticLosses, , Attr::readonly, "Elastic energy of its contacts [J]."))
		((std::vector<Real>, eventSpinLosses, , Attr::readonly, "Energy of rotation that was lost [J]."))
		((std::vector<int>, childNumbers, , Attr::readonly, "Number of its fragments."))
		((std::vector<int>, childIds, , Attr::readonly, "Ids of all fragments, event after event."))
		((std::vector<Real>, childSizes, , Attr::readonly, "Their sizes [m]."))
		, iterPeriod = 1; initRun = true; accepted.remember(checkedAttributes());,
		.def("events", &BreakageEngine::events, "All events so far, as a list of dicts: time [s], step, parent (id), generation, size [m], value and "
			"strength [Pa], elasticLoss and spinLoss [J], children (ids), childSizes [m].")
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(BreakageEngine);

} // namespace yade
