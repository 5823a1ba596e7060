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
	constexpr Real infinite = std::numeric_limits<Real>::infinity();

	// A member of a clump moves with the clump.
	const State& moving(const Body& body, Scene* scene)
	{
		return body.isClumpMember() ? *Body::byId(body.clumpId, scene)->state : *body.state;
	}

	Real massOf(const State& state)
	{
		const bool held = (state.blockedDOFs & State::DOF_XYZ) == State::DOF_XYZ;
		return held || !(state.mass > 0) ? infinite : state.mass;
	}

	Real smallestInertiaOf(const State& state)
	{
		const bool held = (state.blockedDOFs & State::DOF_RXRYRZ) == State::DOF_RXRYRZ;
		const Real smallest = state.inertia.minCoeff();
		return held || !(smallest > 0) ? infinite : smallest;
	}

	// What a body sets against a unit push `normal` at `arm` from its centre.
	Real massAgainst(const State& state, const Vector3r& arm, const Vector3r& normal)
	{
		const bool turns = (state.blockedDOFs & State::DOF_RXRYRZ) != State::DOF_RXRYRZ;
		const Vector3r lever = turns ? Vector3r(state.ori.conjugate() * arm.cross(normal)) : Vector3r(Vector3r::Zero());
		return hm::massAgainstPush(massOf(state), lever, state.inertia);
	}

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
	Vector3r turned(const ScGeom& geom, Vector3r vector)
	{
		const Real length = vector.norm();
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
	const auto* ours = dynamic_cast<const SuperquadricGeom*>(&geom);
	if (!(geom.penetrationDepth > 0)) {
		// A superquadric's pair is parked with the solver's memory (SuperquadricGeom.hpp), any other is reset by YADE.
		if (!ours) return false;
		iPhys.reset();
		return true;
	}
	auto& phys = static_cast<CurvaturePhys&>(*iPhys);
	const Meeting bodies = meeting(geom, ours, *interaction);
	const Radii radius = radii(geom, bodies);
	phys.effectiveRadius = radius.effective;
	phys.effectiveMass = hm::reduced(massOf(moving(bodies.body1, scene)), massOf(moving(bodies.body2, scene)));
	phys.normalMass = leverArms ? normalMass(geom, bodies) : phys.effectiveMass;

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
	apply(geom, phys, bodies);
	return true;
}

Law2_ScGeom_CurvaturePhys_HertzMindlin::Meeting
Law2_ScGeom_CurvaturePhys_HertzMindlin::meeting(ScGeom& geom, const SuperquadricGeom* ours, const Interaction& interaction) const
{
	const Body &body1 = *Body::byId(interaction.getId1(), scene), &body2 = *Body::byId(interaction.getId2(), scene);
	Vector3r shift = Vector3r::Zero(), shiftVelocity = Vector3r::Zero();
	if (scene->isPeriodic) {
		shift = scene->cell->intrShiftPos(interaction.cellDist);
		shiftVelocity = scene->cell->intrShiftVel(interaction.cellDist);
	}
	const State &state1 = *body1.state, &state2 = *body2.state;
	const Vector3r position2 = state2.pos + shift;
	const hm::Side side1 = ours ? hm::Side { ours->curvature1, ours->sectionRadius1, ours->smallestHalfSize1 } : sideOf(body1);
	const hm::Side side2 = ours ? hm::Side { ours->curvature2, ours->sectionRadius2, ours->smallestHalfSize2 } : sideOf(body2);
	if (!ours) geom.contactPoint = middleOfOverlap(geom, side1, state1.pos, side2, position2);
	const Vector3r velocity = geom.getIncidentVel(&state1, &state2, scene->dt, shift, shiftVelocity, /*avoidGranularRatcheting*/ false);
	const Real approach = -velocity.dot(geom.normal);
	return { body1, body2, side1, side2, state1.pos, position2, approach, velocity + approach * geom.normal, state2.angVel - state1.angVel };
}

Real Law2_ScGeom_CurvaturePhys_HertzMindlin::normalMass(const ScGeom& geom, const Meeting& bodies) const
{
	const State &moving1 = moving(bodies.body1, scene), &moving2 = moving(bodies.body2, scene);
	const Vector3r arm1 = geom.contactPoint - bodies.position1 + bodies.body1.state->pos - moving1.pos;
	const Vector3r arm2 = geom.contactPoint - bodies.position2 + bodies.body2.state->pos - moving2.pos;
	return hm::reduced(massAgainst(moving1, arm1, geom.normal), massAgainst(moving2, arm2, geom.normal));
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
	const Vector3r displacement = turned(geom, phys.shearDisplacement) + bodies.sliding * scene->dt;
	const Real inertia = hm::reduced(smallestInertiaOf(moving(bodies.body1, scene)), smallestInertiaOf(moving(bodies.body2, scene)));
	Response now;
	now.normal = hm::normalForce(pair, phys.normalDamping, geom.penetrationDepth, bodies.approach);
	now.tangential = hm::tangentialForce(friction, now.normal.elastic, geom.penetrationDepth, displacement, bodies.sliding);
	now.couple = hm::rollingCouple(phys.rollingFriction, rollingRadius, now.normal.total(), bodies.spin, inertia, scene->dt);
	return now;
}

void Law2_ScGeom_CurvaturePhys_HertzMindlin::apply(const ScGeom& geom, const CurvaturePhys& phys, const Meeting& bodies) const
{
	const Vector3r force = phys.normalForce + phys.shearForce; // on body 2
	const Body::id_t id1 = bodies.body1.getId(), id2 = bodies.body2.getId();
	scene->forces.addForce(id1, -force);
	scene->forces.addForce(id2, force);
	scene->forces.addTorque(id1, -(geom.contactPoint - bodies.position1).cross(force) - phys.rollingCouple);
	scene->forces.addTorque(id2, (geom.contactPoint - bodies.position2).cross(force) + phys.rollingCouple);
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
	book(TangentialViscous, -halfStep * bodies.sliding.dot(turned(geom, before.shearViscous) + tangential.viscous));
	book(Rolling, -halfStep * bodies.spin.dot(before.rollingCouple + now.couple));

	const Real slipped = tangential.slip * tangential.elastic.norm();
	book(Friction, slipped);
	const Vector3r draggedBefore = turned(geom, before.shearForce - before.shearViscous);
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
