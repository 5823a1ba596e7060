#include "ElastoplasticPhys.hpp"

namespace yade {

YADE_PLUGIN((ElastoplasticPhys));

Real ElastoplasticPhys::storedEnergy() const
{
	const superquadric::elastoplastic::Pair pair { plasticity(), effectiveModulus, effectiveRadius };
	const Real rolled = rollingStiffness > 0 ? (rollingElastic.squaredNorm() + twistingElastic * twistingElastic) / (2 * rollingStiffness) : 0;
	return superquadric::elastoplastic::normalForce(pair, history(), overlap).elastic + shearEnergy + rolled;
}

void ElastoplasticPhys::setPlasticity(const superquadric::elastoplastic::Material& material)
{
	yieldStress = material.yieldStress;
	referenceRadius = material.hardening.referenceRadius;
	m0 = material.hardening.m0;
	m1 = material.hardening.m1;
	m2 = material.hardening.m2;
	exponent = material.hardening.exponent;
	smallestRatio = material.hardening.smallestRatio;
	largestRatio = material.hardening.largestRatio;
}

superquadric::elastoplastic::History ElastoplasticPhys::history() const
{
	if (!(residualOverlap > 0)) return {};
	return { curveModulus, curveRadius, largestOverlap, residualOverlap, plasticDissipation };
}

void ElastoplasticPhys::setHistory(const superquadric::elastoplastic::History& history)
{
	curveModulus = history.modulus;
	curveRadius = history.radius;
	largestOverlap = history.largest;
	residualOverlap = history.residual;
	plasticDissipation = history.dissipated;
}

} // namespace yade
