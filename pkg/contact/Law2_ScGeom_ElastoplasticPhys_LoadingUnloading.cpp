#include "Law2_ScGeom_ElastoplasticPhys_LoadingUnloading.hpp"

#include <core/Scene.hpp>
#include <pkg/mechanics/CoulombLimit.hpp>

namespace yade {

YADE_PLUGIN((Law2_ScGeom_ElastoplasticPhys_LoadingUnloading));

namespace ep = superquadric::elastoplastic;

CurvatureLaw::Load Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::respond(CurvaturePhys& curvaturePhys, const ContactKinematics& bodies)
{
	auto& phys = static_cast<ElastoplasticPhys&>(curvaturePhys);
	const Vector3r& normal = bodies.geom.normal;
	setMasses(phys, bodies, bodies.radii(overlapLimit), effectiveMassAtContact);
	phys.hertzStiffness = superquadric::hertzMindlin::Pair { phys.effectiveModulus, phys.effectiveRadius, phys.normalMass }.hertz();

	const Response now = response(phys, bodies);
	if (scene->trackEnergy) bookEnergy(phys, bodies, now);

	phys.overlap = bodies.overlap;
	phys.setHistory(now.normal.history);
	phys.kn = now.normal.unloadingStiffness;
	phys.normalViscous = now.normalViscous * normal;
	phys.normalForce = (now.normal.force + now.normalViscous) * normal;
	const superquadric::Spring &sheared = now.tangential.elastic.spring, &rolled = now.rolling.elastic.spring;
	phys.ks = sheared.stiffness;
	phys.shearElastic = sheared.force;
	phys.shearDisplacement = sheared.stretch();
	phys.shearEnergy = sheared.energy();
	phys.shearViscous = now.tangential.viscous;
	phys.shearForce = now.tangential.total();
	phys.rollingStiffness = rolled.stiffness;
	phys.twistingElastic = rolled.force.dot(normal);
	phys.rollingElastic = rolled.force - phys.twistingElastic * normal;
	phys.rollingViscous = now.rolling.viscous;
	phys.rollingCouple = now.rolling.total();
	return { phys.normalForce + phys.shearForce, phys.rollingCouple };
}

Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::Response
Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::response(const ElastoplasticPhys& phys, const ContactKinematics& bodies) const
{
	Response now;
	const ep::Pair pair { phys.plasticity(), phys.effectiveModulus, phys.effectiveRadius };
	now.normal = ep::normalForce(pair, phys.history(), bodies.overlap);
	now.normalViscous = ep::viscousForce(now.normal, phys.normalDamping, phys.normalMass, bodies.approach);
	now.tangential = tangential(phys, bodies, now.normal);
	now.rolling = rolling(phys, bodies, now.normal);
	return now;
}

Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::SpringAndDashpot
Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::tangential(const ElastoplasticPhys& phys, const ContactKinematics& bodies, const ep::State& normal) const
{
	const Real stiffness = normal.unloadingStiffness / phys.stiffnessRatio, limit = phys.tangensOfFrictionAngle * normal.force;
	SpringAndDashpot now;
	now.elastic = superquadric::follow({ bodies.turned(phys.shearElastic), phys.ks }, stiffness, limit, bodies.sliding * scene->dt);
	const Vector3r viscous = superquadric::dashpot(phys.tangentialDamping, phys.effectiveMass, stiffness, bodies.sliding);
	now.viscous = superquadric::partUpTo(limit, now.elastic.spring.force, viscous) * viscous;
	return now;
}

Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::SpringAndDashpot
Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::rolling(const ElastoplasticPhys& phys, const ContactKinematics& bodies, const ep::State& normal) const
{
	const Real stiffness = superquadric::rollingStiffness(normal.unloadingStiffness, phys.rollingFriction, phys.effectiveRadius);
	const Real limit = phys.rollingFriction * phys.effectiveRadius * normal.force;
	const superquadric::Spring before { bodies.turned(phys.rollingElastic) + phys.twistingElastic * bodies.geom.normal, phys.rollingStiffness };
	SpringAndDashpot now;
	now.elastic = superquadric::follow(before, stiffness, limit, bodies.spin * scene->dt);
	const auto inverseInertia = [&](const MovingBody& body) {
		const Real distance = (bodies.geom.contactPoint - body.centreOfMass).norm();
		return superquadric::inverseRollingInertia(body.inverseMass, body.largestInverseInertia(), distance);
	};
	const Real compliance = inverseInertia(bodies.body1) + inverseInertia(bodies.body2);
	if (!now.elastic.slips && compliance > 0) now.viscous = superquadric::dashpot(phys.rollingDamping, 1 / compliance, stiffness, bodies.spin);
	return now;
}

// The work of the viscous forces is that of the leap-frog integrator: of the mean of the vectors before, which had the last normal, and after,
// on the velocity between. The springs and the plastic part know what becomes of theirs.
void Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::bookEnergy(const ElastoplasticPhys& before, const ContactKinematics& bodies, const Response& now)
{
	energies.find(*scene);
	const auto book = [&](Energy energy, Real value) { energies.add(*scene, energy, bodies.share * value); };
	const Real halfStep = scene->dt / 2;
	book(Elastic, now.normal.elastic + now.tangential.elastic.spring.energy() + now.rolling.elastic.spring.energy());
	book(Plastic, now.normal.history.dissipated - before.plasticDissipation);
	book(NormalViscous, halfStep * (now.normalViscous * bodies.approach - before.normalViscous.dot(bodies.velocity)));
	book(TangentialViscous, -halfStep * bodies.velocity.dot(before.shearViscous + now.tangential.viscous));
	book(Friction, now.tangential.lost());
	book(RollingViscous, -halfStep * bodies.spin.dot(before.rollingViscous + now.rolling.viscous));
	book(RollingFriction, now.rolling.lost());
	book(ModelError, modelError(before, bodies, now.normal));
}

// What the normal force takes out because its radius has changed, and because the bodies' approach misses the growth of the overlap, which
// moves with the contact point along the surfaces.
Real Law2_ScGeom_ElastoplasticPhys_LoadingUnloading::modelError(const ElastoplasticPhys& before, const ContactKinematics& bodies, const ep::State& now) const
{
	const Real overlap = bodies.overlap;
	if (!(before.overlap > 0 && overlap > 0)) return 0;
	Real curved = 0;
	if (before.curveRadius != now.history.radius) {
		const ep::Pair old { before.plasticity(), before.curveModulus, before.curveRadius };
		const ep::Pair present { old.material, now.history.modulus, now.history.radius };
		for (const Real depth : { before.overlap, overlap })
			curved += (ep::normalForce(old, {}, depth).work() - ep::normalForce(present, {}, depth).work()) / 2;
	}
	const Vector3r elasticBefore = before.normalForce - before.normalViscous;
	const Real work = (now.force * bodies.approach - elasticBefore.dot(bodies.velocity)) / 2 * scene->dt;
	return curved + work - (elasticBefore.norm() + now.force) / 2 * (overlap - before.overlap);
}

} // namespace yade
