#include "CurvatureLaw.hpp"

#include <core/Scene.hpp>
#include <pkg/support/Checks.hpp>
#include <pkg/superquadric/SuperquadricGeom.hpp>

namespace yade {

namespace {
	// Bodies of rank 0 (walls) are met by the other body's process only.
	Real shareOf(const Body& one, const Body& two)
	{
#ifdef YADE_MPI
		if (one.subdomain != two.subdomain && one.subdomain > 0 && two.subdomain > 0) return 0.5;
#endif
		return 1;
	}
}

bool CurvatureLaw::go(shared_ptr<IGeom>& iGeom, shared_ptr<IPhys>& iPhys, Interaction* interaction)
{
	auto& geom = static_cast<ScGeom&>(*iGeom);
	auto* ours = dynamic_cast<SuperquadricGeom*>(&geom);
	if (!(geom.penetrationDepth > 0)) {
		// A superquadric's pair is parked with the solver's memory (SuperquadricGeom.hpp), any other is reset by YADE.
		if (!ours) return false;
		iPhys.reset();
		return true;
	}
	const Body::id_t id1 = interaction->getId1(), id2 = interaction->getId2();
	auto& phys = static_cast<CurvaturePhys&>(*iPhys);
	if (scene->iter == birthStep && std::max(id1, id2) >= firstBorn) phys.restOverlap = geom.penetrationDepth;
	const Body &one = *Body::byId(id1, scene), &two = *Body::byId(id2, scene);
	Vector3r shift = Vector3r::Zero(), shiftVelocity = Vector3r::Zero();
	if (scene->isPeriodic) {
		shift = scene->cell->intrShiftPos(interaction->cellDist);
		shiftVelocity = scene->cell->intrShiftVel(interaction->cellDist);
	}
	const MovingBody body1(one, *scene), body2(two, *scene, shift, shiftVelocity);
	Meeting bodies = ours ? Meeting(body1, body2, *ours) : spheresMeeting(one, two, body1, body2, geom);
	bodies.share = shareOf(one, two);
	const ContactLoad now = respondToPressure(phys, bodies);
	scene->forces.addForce(id1, -now.force);
	scene->forces.addForce(id2, now.force);
	scene->forces.addTorque(id1, now.torque1);
	scene->forces.addTorque(id2, now.torque2);
	return true;
}

// Under YADE's geometry.
Meeting CurvatureLaw::spheresMeeting(const Body& one, const Body& two, const MovingBody& body1, const MovingBody& body2, ScGeom& geom)
{
	const auto side1 = Meeting::flatOrSphere(one), side2 = Meeting::flatOrSphere(two);
	geom.contactPoint = Meeting::middleOfOverlap(geom, side1, body1.position, side2, body2.position);
	return Meeting(body1, body2, side1, side2, geom);
}

ContactLoad CurvatureLaw::load(SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2)
{
	return respondToPressure(static_cast<CurvaturePhys&>(phys), Meeting(body1, body2, geom));
}

// The overlap at rest gives way to bodies that part, while there is no force: so no energy comes of it.
ContactLoad CurvatureLaw::respondToPressure(CurvaturePhys& phys, Meeting bodies)
{
	if (phys.restOverlap > 0) {
		phys.restOverlap = std::min(phys.restOverlap, bodies.overlap);
		bodies.overlap -= phys.restOverlap;
	}
	return respond(phys, bodies);
}

void CurvatureLaw::noteMasses(CurvaturePhys& phys, const Meeting& bodies, const Meeting::Radii& radii, bool leverArms)
{
	phys.effectiveRadius = radii.effective;
	phys.effectiveMass = bodies.mass();
	phys.normalMass = leverArms ? bodies.normalMass() : phys.effectiveMass;
}

ContactLoad CurvatureLaw::loadOf(const Meeting& bodies, const Vector3r& force, const Vector3r& couple)
{
	const Vector3r& point = bodies.geom.contactPoint;
	return { force, -(point - bodies.body1.position).cross(force) - couple, (point - bodies.body2.position).cross(force) + couple };
}

void CurvatureLaw::checkOverlapLimit(Real& overlapLimit)
{
	const Real asked = overlapLimit;
	if (!(asked > 0 && asked < 1)) {
		overlapLimit = acceptedLimit;
		refuse("overlapLimit", "between 0 and 1", asked);
	}
	acceptedLimit = asked;
}

} // namespace yade
