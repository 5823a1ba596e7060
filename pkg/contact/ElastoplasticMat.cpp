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
	superquadric::elastoplastic::check(material);
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
