// What the contact laws on the local curvature have in common: from a contact to the forces on its two bodies.
#pragma once

#include "ContactKinematics.hpp"
#include "CurvaturePhys.hpp"
#include "PairLaw.hpp"

#include <core/Dispatching.hpp>
#include <pkg/support/AcceptedAttributes.hpp>

namespace yade {

// For superquadrics and for YADE's spheres alike, with each other and with walls; no class of its own for YADE.
class CurvatureLaw : public LawFunctor, public PairLaw {
public:
	// Called by YADE's loop, and by ours when a contact begins or ends.
	bool go(shared_ptr<IGeom>& iGeom, shared_ptr<IPhys>& iPhys, Interaction* interaction) override;
	// Called by our loop for superquadrics that go on touching.
	void act(const SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2) override;

protected:
	// What a contact does to its two bodies.
	struct Load {
		Vector3r force; // on body 2; body 1 gets the opposite [N]
		Vector3r couple; // on body 2; body 1 gets the opposite [N m]
	};

	// The law itself.
	virtual Load respond(CurvaturePhys& phys, const ContactKinematics& bodies) = 0;

	// Masses and the effective radius of this step, put down in `phys`.
	static void setMasses(CurvaturePhys& phys, const ContactKinematics& bodies, const ContactKinematics::Radii& radii, bool effectiveMassAtContact);
	// Refused values are put back before the error leaves.
	void checkOverlapLimit(Real& overlapLimit);

private:
	// Fragments that overlap from birth: the overlap that their contact begins with is its rest.
	bool beginsWithABirth(const Interaction& interaction, const Body& one, const Body& two) const;
	static ContactKinematics kinematicsOfSpheres(const Body& one, const Body& two, const MovingBody& body1, const MovingBody& body2, ScGeom& geom);
	// `respond` to the overlap beyond the one at rest, and put the forces on the bodies. All contacts come through here.
	void apply(CurvaturePhys& phys, ContactKinematics bodies);

	AcceptedAttributes accepted;
};

} // namespace yade
