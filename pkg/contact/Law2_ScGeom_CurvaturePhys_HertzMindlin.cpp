#include "Law2_ScGeom_CurvaturePhys_HertzMindlin.hpp"

#include <core/Scene.hpp>

namespace yade {

YADE_PLUGIN((Law2_ScGeom_CurvaturePhys_HertzMindlin));

namespace hm = superquadric::hertzMindlin;

CurvatureLaw::Load Law2_ScGeom_CurvaturePhys_HertzMindlin::respond(CurvaturePhys& phys, const ContactKinematics& bodies)
{
	const ScGeom& geom = bodies.geom;
	const ContactKinematics::Radii radius = bodies.radii(overlapLimit);
	setMasses(phys, bodies, radius, effectiveMassAtContact);

	const Response now = response(phys, bodies, radius.smaller);
	const Real hertz = hm::Pair { phys.effectiveModulus, radius.effective, phys.normalMass }.hertz();
	if (scene->trackEnergy) bookEnergy(phys, bodies, now, hertz);

	phys.hertzStiffness = hertz;
	phys.overlap = bodies.overlap;
	phys.kn = now.normal.stiffness;
	phys.ks = phys.kn / phys.stiffnessRatio;
	phys.normalForce = now.normal.total() * geom.normal;
	phys.normalViscous = now.normal.viscous * geom.normal;
	phys.shearDisplacement = now.tangential.displacement;
	phys.shearForce = now.tangential.total();
	phys.shearViscous = now.tangential.viscous;
	phys.shearEnergy = now.tangential.energy;
	phys.rollingCouple = now.couple;
	return { phys.normalForce + phys.shearForce, now.couple };
}

Law2_ScGeom_CurvaturePhys_HertzMindlin::Response
Law2_ScGeom_CurvaturePhys_HertzMindlin::response(const CurvaturePhys& phys, const ContactKinematics& bodies, Real rollingRadius) const
{
	const Real overlap = bodies.overlap;
	const hm::Pair pair { phys.effectiveModulus, phys.effectiveRadius, phys.normalMass };
	const hm::Friction friction { phys.tangensOfFrictionAngle, phys.stiffnessRatio, phys.tangentialDamping, phys.effectiveMass };
	const Vector3r displacement = bodies.turned(phys.shearDisplacement) + bodies.sliding * scene->dt;
	const Real compliance = bodies.body1.largestInverseInertia() + bodies.body2.largestInverseInertia();
	const Real inertia = compliance > 0 ? 1 / compliance : 0;
	Response now;
	now.normal = hm::normalForce(pair, phys.normalDamping, overlap, bodies.approach);
	now.tangential = hm::tangentialForce(friction, now.normal.elastic, overlap, displacement, bodies.sliding);
	now.couple = hm::rollingCouple(phys.rollingFriction, rollingRadius, now.normal.total(), bodies.spin, inertia, scene->dt);
	return now;
}

// Each sum gets the work of its force over the last step, by the mean of the force before and after: with velocities half a step
// apart from the forces, this is the work that the leap-frog integrator does, to second order.
void Law2_ScGeom_CurvaturePhys_HertzMindlin::bookEnergy(const CurvaturePhys& before, const ContactKinematics& bodies, const Response& now, Real hertz)
{
	energies.find(*scene);
	const auto book = [&](Energy energy, Real value) { energies.add(*scene, energy, bodies.share * value); };
	const ScGeom& geom = bodies.geom;
	const Real halfStep = scene->dt / 2, overlap = bodies.overlap;
	const auto& tangential = now.tangential;

	book(Elastic, hm::normalEnergy(hertz, overlap) + tangential.energy);
	book(NormalViscous, halfStep * bodies.approach * (before.normalViscous.dot(geom.normal) + now.normal.viscous));
	book(TangentialViscous, -halfStep * bodies.sliding.dot(bodies.turned(before.shearViscous) + tangential.viscous));
	book(Rolling, -halfStep * bodies.spin.dot(before.rollingCouple + now.couple));

	const Real slipped = tangential.slip * tangential.elastic.norm();
	book(Friction, slipped);
	const Vector3r draggedBefore = bodies.turned(before.shearForce - before.shearViscous);
	const Real loaded = -halfStep * bodies.sliding.dot(draggedBefore + tangential.elastic);
	Real pressed = 0;
	if (before.overlap > 0 && overlap > 0) {
		const Real curved = (before.hertzStiffness - hertz) * (hm::normalEnergy(1, before.overlap) + hm::normalEnergy(1, overlap)) / 2;
		const Real elasticBefore = (before.normalForce - before.normalViscous).norm();
		// By how much the bodies' approach misses the growth of the overlap, which moves with X0 along the surfaces.
		pressed = curved + (elasticBefore + now.normal.elastic) / 2 * (bodies.approach * scene->dt - overlap + before.overlap);
	}
	book(ModelError, pressed + loaded - slipped - (tangential.energy - before.shearEnergy));
}

} // namespace yade
