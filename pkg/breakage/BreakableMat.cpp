#include "BreakableMat.hpp"

#include <pkg/support/Checks.hpp>

namespace yade {

YADE_PLUGIN((BreakableMat)(BreakableState));

void BreakableMat::check() const
{
	ElastoplasticMat::check();
	if (!(characteristicStrength > 0)) refuse("characteristicStrength", "positive", characteristicStrength);
	requirePositive("referenceSize", referenceSize);
	requirePositive("weibullModulus", weibullModulus);
	requireNotNegative("smallestSize", smallestSize);
}

AcceptedAttributes::References BreakableMat::checkedAttributes()
{
	auto all = ElastoplasticMat::checkedAttributes();
	for (Real* own : { &characteristicStrength, &referenceSize, &weibullModulus, &smallestSize })
		all.push_back(own);
	return all;
}

Real BreakableMat::strength(Real size, Real survival) const
{
	requirePositive("size", size);
	if (!(survival > 0 && survival < 1)) refuse("survival", "between 0 and 1", survival);
	return law().quantile(size, survival);
}

} // namespace yade
