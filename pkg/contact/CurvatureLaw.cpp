#include "CurvatureLaw.hpp"

#include "BirthState.hpp"

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

	bool isBornAt(long step, const Body& body)
	{
		const auto* state = dynamic_cast<const BirthState*>(body.state.get());
		return state && state->birthStep == step;
	}
}

bool CurvatureLaw::go(shared_ptr<IGeom>& iGeom, shared_ptr<IPhys>& iPhys, Interaction* interaction)
{
	auto& geom = static_cast<ScGeom&>(*iGeom);
	auto* superquadricGeom = dynamic_cast<SuperquadricGeom*>(&geom);
	if (!(geom.penetrationDepth > 0)) {
		// A superquadric's pair is parked with the solver's memory (SuperquadricGeom.hpp), any other is reset by YADE.
		if (!superquadricGeom) return false;
		iPhys.reset();
		return true;
	}
	auto& phys = static_cast<CurvaturePhys&>(*iPhys);
	const Body &one = *Body::byId(interaction->getId1(), scene), &two = *Body::byId(interaction->getId2(), scene);
	if (beginsWithABirth(*interaction, one, two)) phys.restOverlap = geom.penetrationDepth;
	Vector3r shift = Vector3r::Zero(), shiftVelocity = Vector3r::Zero();
	if (scene->isPeriodic) {
		shift = scene->cell->intrShiftPos(interaction->cellDist);
		shiftVelocity = scene->cell->intrShiftVel(interaction->cellDist);
	}
	const MovingBody body1(one, *scene), body2(two, *scene, shift, shiftVelocity);
	ContactKinematics bodies = superquadricGeom ? ContactKinematics(body1, body2, *superquadricGeom) : kinematicsOfSpheres(one, two, body1, body2, geom);
	bodies.share = shareOf(one, two);
	apply(phys, bodies);
	return true;
}

void CurvatureLaw::act(const SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2)
{
	apply(static_cast<CurvaturePhys&>(phys), ContactKinematics(body1, body2, geom));
}

bool CurvatureLaw::beginsWithABirth(const Interaction& interaction, const Body& one, const Body& two) const
{
	return interaction.iterMadeReal == scene->iter && (isBornAt(scene->iter, one) || isBornAt(scene->iter, two));
}

// Under YADE's geometry.
ContactKinematics CurvatureLaw::kinematicsOfSpheres(const Body& one, const Body& two, const MovingBody& body1, const MovingBody& body2, ScGeom& geom)
{
	const auto side1 = ContactKinematics::flatOrSphere(one), side2 = ContactKinematics::flatOrSphere(two);
	geom.contactPoint = ContactKinematics::middleOfOverlap(geom, side1, body1.position, side2, body2.position);
	return ContactKinematics(body1, body2, side1, side2, geom);
}

void CurvatureLaw::apply(CurvaturePhys& phys, ContactKinematics bodies)
{
	// The overlap at rest gives way to bodies that part, while there is no force: so no energy comes of it.
	if (phys.restOverlap > 0) {
		phys.restOverlap = std::min(phys.restOverlap, bodies.overlap);
		bodies.overlap -= phys.restOverlap;
	}
	const Load load = respond(phys, bodies);
	const Vector3r& point = bodies.geom.contactPoint;
	scene->forces.addForce(bodies.body1.id, -load.force);
	scene->forces.addForce(bodies.body2.id, load.force);
	scene->forces.addTorque(bodies.body1.id, -(point - bodies.body1.position).cross(load.force) - load.couple);
	scene->forces.addTorque(bodies.body2.id, (point - bodies.body2.position).cross(load.force) + load.couple);
}

void CurvatureLaw::setMasses(CurvaturePhys& phys, const ContactKinematics& bodies, const ContactKinematics::Radii& radii, bool effectiveMassAtContact)
{
	phys.effectiveRadius = radii.effective;
	phys.effectiveMass = bodies.mass();
	phys.normalMass = effectiveMassAtContact ? bodies.normalMass() : phys.effectiveMass;
}

void CurvatureLaw::checkOverlapLimit(Real& overlapLimit)
{
	accepted.accept({ &overlapLimit }, [&] {
		if (!(overlapLimit > 0 && overlapLimit < 1)) refuse("overlapLimit", "between 0 and 1", overlapLimit);
	});
}

} // namespace yade
