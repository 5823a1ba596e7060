#pragma once

#include "BodyTable.hpp"
#include "PairTable.hpp"

#include <core/InteractionLoop.hpp>
#include <pkg/contact/PairLaw.hpp>
#include <pkg/superquadric/Ig2_Superquadric_Superquadric_SuperquadricGeom.hpp>

#include <vector>

namespace yade {

class SuperquadricInteractionLoop : public InteractionLoop {
public:
	void action() override;
	// Called by YADE before the engine is saved, which is before the interactions are.
	void preSave(SuperquadricInteractionLoop&);

private:
	using Callback = std::pair<IntrCallback*, IntrCallback::FuncPtr>;

	void prepare();
	bool isStillApart(const PairTable::Row& row) const;
	void solve(PairTable::Row& row);
	bool spheresAreApart(PairTable::Row& row) const;
	Real apartUntil(const PairTable::Row& row, Real gap, Real size) const;
	void keepTouching(const PairTable::Row& row, const superquadric::Contact& contact);
	void beginOrEnd(const PairTable::Row& row, const superquadric::Contact& contact) const;
	void fetch(const PairTable::Row& row) const;
	void dispatch(PairTable::Row& row);
	bool isForeign(const Body& body1, const Body& body2) const;
	bool findGeometry(PairTable::Row& row, Body& body1, Body& body2) const;
	void makePhysics(const shared_ptr<Interaction>& interaction, Body& body1, Body& body2) const;
	void findLaw(Interaction& interaction) const;
	void applyLaw(const shared_ptr<Interaction>& interaction) const;
	void callBack(Interaction& interaction) const;
	// Some colliders leave it to the loop to erase the interactions that they have not seen.
	void eraseUnseen();

	BodyTable bodies;
	PairTable pairs;
	// Of this step.
	shared_ptr<Ig2_Superquadric_Superquadric_SuperquadricGeom> geometry;
	Real sphereReach = 0; // radii are counted so many times when spheres are looked at; 0: YADE's functor for them is not there
	LawFunctor* fastLaw = nullptr; // the one behind `pairLaw`
	PairLaw* pairLaw = nullptr;
	std::vector<Callback> activeCallbacks;

	// clang-format off
	YADE_CLASS_BASE_DOC(SuperquadricInteractionLoop, InteractionLoop,
		"An :yref:`InteractionLoop` for scenes of many superquadrics: the same functors, results and interactions, in less time. What belongs to a "
			"body (rotation matrix, inverse inertia) is "
		"computed once per step; pairs of superquadrics are kept side by side in memory with what the solver remembers of them, so that a pair that "
			"does not touch is sent away without its interaction being "
		"looked at. Pairs of spheres that have not yet moved by the gap between them are left alone as well; all others are dispatched as YADE does "
			"it.\n\n"
		"Contacts are always visited in the order of the bodies' ids, so that on one thread sums of forces do not depend on the history of the list "
			"of interactions: loopOnSortedInteractions has no effect."
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(SuperquadricInteractionLoop);

} // namespace yade
