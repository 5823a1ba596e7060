// What the contact laws on the local curvature have in common: who meets whom, and where the loads go.
#pragma once

#include "CurvaturePhys.hpp"
#include "ContactKinematics.hpp"
#include "PairLaw.hpp"

#include <core/Dispatching.hpp>

namespace yade {

// For superquadrics and for YADE's spheres alike, with each other and with walls; no class of its own for YADE.
class CurvatureLaw : public LawFunctor, public MovingBodiesLaw {
public:
	bool go(shared_ptr<IGeom>& iGeom, shared_ptr<IPhys>& iPhys, Interaction* interaction) override;
	ContactLoad load(SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2) override;

	// Bodies from this id on have come to be by breakage in this step: their contacts begin without force, however much they overlap.
	void noteBirths(long step, Body::id_t first)
	{
		birthStep = step;
		firstBorn = first;
	}

protected:
	// The law itself.
	virtual ContactLoad respond(CurvaturePhys& phys, const Meeting& bodies) = 0;

	// Masses and the effective radius of this step, put down in `phys`.
	static void noteMasses(CurvaturePhys& phys, const Meeting& bodies, const Meeting::Radii& radii, bool leverArms);
	// Of the force at the contact point and the couple, both on body 2.
	static ContactLoad loadOf(const Meeting& bodies, const Vector3r& force, const Vector3r& couple);
	// A refused overlapLimit is put back before the error leaves.
	void checkOverlapLimit(Real& overlapLimit);

private:
	static Meeting spheresMeeting(const Body& one, const Body& two, const MovingBody& body1, const MovingBody& body2, ScGeom& geom);
	// `respond` to the overlap beyond the one at rest.
	ContactLoad respondToPressure(CurvaturePhys& phys, Meeting bodies);

	Real acceptedLimit = 0.1;
	// Not saved: whoever notes births does so in the same step.
	long birthStep = -1;
	Body::id_t firstBorn = 0;
};

} // namespace yade
