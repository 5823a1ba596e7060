#pragma once

#include "SuperquadricGeomFunctor.hpp"

namespace yade {

class Ig2_Superquadric_Superquadric_SuperquadricGeom : public SuperquadricGeomFunctor {
public:
	FUNCTOR2D(Superquadric, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Superquadric, Superquadric);
	// The functor's work in two parts, for a loop that has the placements at hand: what the solver says, and what the interaction gets.
	superquadric::Contact solveAt(const superquadric::Placement& body1, const superquadric::Placement& body2, superquadric::WarmStart& warm);
	static bool describe(const superquadric::Contact& contact, const superquadric::Placement& body1, const superquadric::Placement& body2,
	        const ContactPair& pair, const superquadric::WarmStart& warm);
	// Pairs that a loop knew to be apart without asking.
	void countStillApart(unsigned long pairs) { solverCounters.ofThisThread().stillApart += pairs; }

	// clang-format off
	YADE_CLASS_BASE_DOC(Ig2_Superquadric_Superquadric_SuperquadricGeom, SuperquadricGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of two :yref:`superquadrics<Superquadric>`. Every answer is proved by a point "
		"inside both or by a plane between them; a pair that is apart keeps that plane in a parked geometry, which settles most later steps at "
		"once. The counts tell how; the entry uncertified must stay 0."
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;
};
REGISTER_SERIALIZABLE(Ig2_Superquadric_Superquadric_SuperquadricGeom);

} // namespace yade
