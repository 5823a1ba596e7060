// A material whose particles break: their strengths are Weibull's, and fall with size.
#pragma once

#include "BreakableState.hpp"

#include <pkg/contact/ElastoplasticMat.hpp>
#include <pkg/mechanics/WeibullStrength.hpp>

#include <limits>

namespace yade {

class BreakableMat : public ElastoplasticMat {
public:
	~BreakableMat() override = default;

	shared_ptr<State> newAssocState() const override { return shared_ptr<State>(new BreakableState); }
	bool stateTypeOk(State* state) const override { return dynamic_cast<BreakableState*>(state); }

	superquadric::WeibullStrength law() const { return { characteristicStrength, referenceSize, weibullModulus }; }
	// The strength [Pa] of a particle of that size [m] that the part 1 - `survival` of its like do not reach.
	Real strength(Real size, Real survival) const;

protected:
	void check() const override;
	AcceptedAttributes::References checkedAttributes() override;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BreakableMat, ElastoplasticMat,
		"Material of particles that :yref:`BreakageEngine` may break. Of particles of size d (diameter of the sphere of the same volume) the part "
			"$\\exp(-(d/d_0)^3(\\sigma/\\sigma_0)^m)$ survives the stress $\\sigma$ (Weibull 1951), so that "
		"strength goes as $d^{-3/m}$. It yields as well only if its yieldStress is given. Bodies get a :yref:`BreakableState`. As for "
			":yref:`CurvatureMat`, a refused value raises ValueError and the material stays as it was.",
		((Real, characteristicStrength, std::numeric_limits<Real>::infinity(), Attr::triggerPostLoad, "$\\sigma_0$, positive [Pa]: what the part 1/e "
			"of the particles of referenceSize survive, in the measure of :yref:`BreakageEngine.criterion`. Infinite: never breaks."))
		((Real, referenceSize, 1e-2, Attr::triggerPostLoad, "$d_0$, positive [m]."))
		((Real, weibullModulus, 3, Attr::triggerPostLoad, "$m$, positive [-]."))
		((Real, smallestSize, 0, Attr::triggerPostLoad, "Size below which a particle does not break, not negative [m]."))
		, createIndex(); postLoad(*this);,
		.def("strength", &BreakableMat::strength, (boost::python::arg("size"), boost::python::arg("survival")),
			"Strength [Pa] that the part `survival` (between 0 and 1) of all particles of a size [m] exceed. ValueError for values out of range.")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(BreakableMat, ElastoplasticMat);
};
REGISTER_SERIALIZABLE(BreakableMat);

} // namespace yade
