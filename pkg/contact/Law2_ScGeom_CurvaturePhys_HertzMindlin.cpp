#include "Law2_ScGeom_CurvaturePhys_HertzMindlin.hpp"

#include <core/Scene.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/superquadric/Checks.hpp>
#include <pkg/superquadric/SuperquadricGeom.hpp>

#include <limits>

namespace yade {

YADE_PLUGIN((Law2_ScGeom_CurvaturePhys_HertzMindlin));

namespace hm = superquadric::hertzMindlin;

namespace {
	// A sphere; anything else under YADE's own geometry is flat.
	hm::Side sideOf(const Body& body)
	{
		const auto* sphere = dynamic_cast<const Sphere*>(body.shape.get());
		return sphere ? hm::Side { 1 / sphere->radius, sphere->radius, sphere->radius } : hm::Side { 0, 0, 0 };
	}

	// YADE's functors put the contact point of a sphere and a wall onto the wall; ours, like that of two spheres, is the middle of
	// the overlap, so that spheres and round superquadrics have the same lever arms. The size of a flat side is 0.
	Vector3r middleOfOverlap(const ScGeom& geom, const hm::Side& side1, const Vector3r& position1, const hm::Side& side2, const Vector3r& position2)
	{
		if (side1.smallestHalfSize > 0) return position1 + (side1.smallestHalfSize - geom.penetrationDepth / 2) * geom.normal;
		if (side2.smallestHalfSize > 0) return position2 - (side2.smallestHalfSize - geom.penetrationDepth / 2) * geom.normal;
		return geom.contactPoint;
	}

	// A tangential vector of the last step, turned with the contact; its length stays.
	Vector3r turned(const ScGeom& geom, const SuperquadricGeom* ours, Vector3r vector)
	{
		const Real length = vector.norm();
		if (ours)
			vector = ours->turned(vector);
		else
			geom.rotate(vector);
		vector -= geom.normal.dot(vector) * geom.normal;
		const Real projected = vector.norm();
		return projected > 0 ? Vector3r(vector * (length / projected)) : Vector3r(Vector3r::Zero());
	}
}

void Law2_ScGeom_CurvaturePhys_HertzMindlin::postLoad(Law2_ScGeom_CurvaturePhys_HertzMindlin&)
{
	const Real asked = overlapLimit;
	if (!(asked > 0 && asked < 1)) {
		overlapLimit = acceptedLimit;
		refuse("overlapLimit", "between 0 and 1", asked);
	}
	acceptedLimit = asked;
}

bool Law2_ScGeom_CurvaturePhys_HertzMindlin::go(shared_ptr<IGeom>& iGeom, shared_ptr<IPhys>& iPhys, Interaction* interaction)
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
	const Body &one = *Body::byId(id1, scene), &two = *Body::byId(id2, scene);
	Vector3r shift = Vector3r::Zero(), shiftVelocity = Vector3r::Zero();
	if (scene->isPeriodic) {
		shift = scene->cell->intrShiftPos(interaction->cellDist);
		shiftVelocity = scene->cell->intrShiftVel(interaction->cellDist);
	}
	const MovingBody body1(one, *scene), body2(two, *scene, shift, shiftVelocity);
	ContactLoad now;
	if (ours)
		now = load(*ours, *iPhys, body1, body2);
	else {
		const hm::Side side1 = sideOf(one), side2 = sideOf(two);
		geom.contactPoint = middleOfOverlap(geom, side1, body1.position, side2, body2.position);
		now = load(geom, static_cast<CurvaturePhys&>(*iPhys), Meeting(body1, body2, side1, side2, geom, nullptr));
	}
	scene->forces.addForce(id1, -now.force);
	scene->forces.addForce(id2, now.force);
	scene->forces.addTorque(id1, now.torque1);
	scene->forces.addTorque(id2, now.torque2);
	return true;
}

ContactLoad Law2_ScGeom_CurvaturePhys_HertzMindlin::load(SuperquadricGeom& geom, IPhys& phys, const MovingBody& body1, const MovingBody& body2)
{
	const hm::Side side1 { geom.curvature1, geom.sectionRadius1, geom.smallestHalfSize1 }, side2 { geom.curvature2, geom.sectionRadius2, geom.smallestHalfSize2 };
	return load(geom, static_cast<CurvaturePhys&>(phys), Meeting(body1, body2, side1, side2, geom, &geom));
}

ContactLoad Law2_ScGeom_CurvaturePhys_HertzMindlin::load(const ScGeom& geom, CurvaturePhys& phys, const Meeting& bodies)
{
	const MovingBody &body1 = bodies.body1, &body2 = bodies.body2;
	const Radii radius = radii(geom, bodies);
	const auto massOf = [](Real inverse) { return inverse > 0 ? 1 / inverse : 0; }; // nothing to damp where the motion is prescribed
	phys.effectiveRadius = radius.effective;
	phys.effectiveMass = massOf(body1.inverseMass + body2.inverseMass);
	phys.normalMass = leverArms ? massOf(body1.inverseMassAgainst(geom.contactPoint, geom.normal) + body2.inverseMassAgainst(geom.contactPoint, geom.normal))
	                            : phys.effectiveMass;

	const Response now = response(geom, phys, bodies, radius.rolling);
	const Real hertz = hm::Pair { phys.effectiveModulus, radius.effective, phys.normalMass }.hertz();
	if (scene->trackEnergy) bookEnergy(geom, phys, bodies, now, hertz);

	phys.hertzStiffness = hertz;
	phys.overlap = geom.penetrationDepth;
	phys.kn = now.normal.stiffness;
	phys.ks = phys.kn / phys.stiffnessRatio;
	phys.normalForce = now.normal.total() * geom.normal;
	phys.normalViscous = now.normal.viscous * geom.normal;
	phys.shearDisplacement = now.tangential.displacement;
	phys.shearForce = now.tangential.total();
	phys.shearViscous = now.tangential.viscous;
	phys.shearEnergy = now.tangential.energy;
	phys.rollingCouple = now.couple;
	const Vector3r force = phys.normalForce + phys.shearForce;
	return { force, -(geom.contactPoint - body1.position).cross(force) - now.couple, (geom.contactPoint - body2.position).cross(force) + now.couple };
}

Law2_ScGeom_CurvaturePhys_HertzMindlin::Meeting::Meeting(const MovingBody& one, const MovingBody& two, const hm::Side& side1, const hm::Side& side2, const ScGeom& geom, const SuperquadricGeom* ours)
        : body1(one)
        , body2(two)
        , side1(side1)
        , side2(side2)
        , ours(ours)
        , spin(two.spin - one.spin)
{
	const Vector3r velocity = two.velocityAt(geom.contactPoint) - one.velocityAt(geom.contactPoint);
	approach = -velocity.dot(geom.normal);
	sliding = velocity + approach * geom.normal;
}

Law2_ScGeom_CurvaturePhys_HertzMindlin::Radii
Law2_ScGeom_CurvaturePhys_HertzMindlin::radii(const ScGeom& geom, const Meeting& bodies) const
{
	const Real curvature1 = hm::boundedCurvature(bodies.side1, overlapLimit), curvature2 = hm::boundedCurvature(bodies.side2, overlapLimit);
	// YADE's grids and cylinders, without a sphere: only the radii that their functors give.
	if (curvature1 + curvature2 == 0) return { geom.radius1 * geom.radius2 / (geom.radius1 + geom.radius2), std::min(geom.radius1, geom.radius2) };
	return { 1 / (curvature1 + curvature2), 1 / std::max(curvature1, curvature2) };
}

Law2_ScGeom_CurvaturePhys_HertzMindlin::Response Law2_ScGeom_CurvaturePhys_HertzMindlin::response(
        const ScGeom& geom, const CurvaturePhys& phys, const Meeting& bodies, Real rollingRadius) const
{
	const hm::Pair pair { phys.effectiveModulus, phys.effectiveRadius, phys.normalMass };
	const hm::Friction friction { phys.tangensOfFrictionAngle, phys.stiffnessRatio, phys.tangentialDamping, phys.effectiveMass };
	const Vector3r displacement = turned(geom, bodies.ours, phys.shearDisplacement) + bodies.sliding * scene->dt;
	const Real compliance = bodies.body1.largestInverseInertia() + bodies.body2.largestInverseInertia();
	const Real inertia = compliance > 0 ? 1 / compliance : 0;
	Response now;
	now.normal = hm::normalForce(pair, phys.normalDamping, geom.penetrationDepth, bodies.approach);
	now.tangential = hm::tangentialForce(friction, now.normal.elastic, geom.penetrationDepth, displacement, bodies.sliding);
	now.couple = hm::rollingCouple(phys.rollingFriction, rollingRadius, now.normal.total(), bodies.spin, inertia, scene->dt);
	return now;
}

// Each sum gets the work of its force over the last step, by the mean of the force before and after: with velocities half a step
// apart from the forces, this is the work that the leap-frog integrator does, to second order.
void Law2_ScGeom_CurvaturePhys_HertzMindlin::bookEnergy(
        const ScGeom& geom, const CurvaturePhys& before, const Meeting& bodies, const Response& now, Real hertz)
{
	if (energiesFoundAt.load(std::memory_order_acquire) != scene->iter) findEnergies();
	const auto book = [&](Energy energy, Real value) { scene->energy->energies.add(energyIds[energy], value); };
	const Real halfStep = scene->dt / 2, overlap = geom.penetrationDepth;
	const auto& tangential = now.tangential;

	book(Elastic, hm::normalEnergy(hertz, overlap) + tangential.energy);
	book(NormalViscous, halfStep * bodies.approach * (before.normalViscous.dot(geom.normal) + now.normal.viscous));
	book(TangentialViscous, -halfStep * bodies.sliding.dot(turned(geom, bodies.ours, before.shearViscous) + tangential.viscous));
	book(Rolling, -halfStep * bodies.spin.dot(before.rollingCouple + now.couple));

	const Real slipped = tangential.slip * tangential.elastic.norm();
	book(Friction, slipped);
	const Vector3r draggedBefore = turned(geom, bodies.ours, before.shearForce - before.shearViscous);
	const Real loaded = -halfStep * bodies.sliding.dot(draggedBefore + tangential.elastic);
	Real pressed = 0;
	if (before.overlap > 0) {
		const Real curved = (before.hertzStiffness - hertz) * (hm::normalEnergy(1, before.overlap) + hm::normalEnergy(1, overlap)) / 2;
		const Real elasticBefore = (before.normalForce - before.normalViscous).norm();
		// By how much the bodies' approach misses the growth of the overlap, which moves with X0 along the surfaces.
		pressed = curved + (elasticBefore + now.normal.elastic) / 2 * (bodies.approach * scene->dt - overlap + before.overlap);
	}
	book(ModelError, pressed + loaded - slipped - (tangential.energy - before.shearEnergy));
}

// Finds or makes the entries once a step, all at once and before any thread adds to one: EnergyTracker moves its storage when it
// grows, and O.energy.clear() may have emptied it.
void Law2_ScGeom_CurvaturePhys_HertzMindlin::findEnergies()
{
	static const std::array<const char*, energyCount> names { "elastic", "frictionDissip", "normalViscous", "tangentialViscous", "rolling", "nonconservative" };
	const std::lock_guard<std::mutex> lock(findingEnergies);
	if (energiesFoundAt.load(std::memory_order_relaxed) == scene->iter) return;
	for (int energy = 0; energy < energyCount; ++energy) {
		energyIds[energy] = -1;
		scene->energy->findId(names[energy], energyIds[energy], /*reset each step*/ energy == Elastic);
	}
	energiesFoundAt.store(scene->iter, std::memory_order_release);
}

} // namespace yade
