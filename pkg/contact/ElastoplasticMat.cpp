#include "ElastoplasticMat.hpp"

#include <pkg/support/Checks.hpp>

namespace yade {

YADE_PLUGIN((ElastoplasticMat));

superquadric::elastoplastic::Material ElastoplasticMat::plasticity() const
{
	return { yieldStress, { referenceRadius, m0, m1, m2, exponent, smallestRatio, largestRatio } };
}

void ElastoplasticMat::check() const
{
	CurvatureMat::check();
	const auto material = plasticity();
	try {
		superquadric::elastoplastic::check(material);
	} catch (const std::invalid_argument& error) {
		if (!(yieldStress > 0 && material.yields())) throw;
		throw std::invalid_argument(std::string(error.what()) + " (the hardening counts as soon as yieldStress is finite: set both at once)");
	}
	if (material.yields() && !(yieldStress < young)) refuse("yieldStress", "below Young's modulus", yieldStress);
	requireNotNegative("rollingDamping", rollingDamping);
}

AcceptedAttributes::References ElastoplasticMat::checkedAttributes()
{
	auto all = CurvatureMat::checkedAttributes();
	for (Real* own : { &yieldStress, &referenceRadius, &m0, &m1, &m2, &exponent, &smallestRatio, &largestRatio, &rollingDamping })
		all.push_back(own);
	return all;
}

} // namespace yade
