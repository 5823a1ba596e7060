// A particle that may break: a body of BreakableMat, a sphere or a superquadric, as BreakageEngine sees it during one call.
#pragma once

#include "BreakableMat.hpp"

#include <core/Scene.hpp>
#include <pkg/geometry/Shape.hpp>

namespace yade {

struct BreakableParticle {
	Body* body;
	const BreakableMat* material;
	BreakableState* state;
	Real size; // [m]
	Real volume; // [m^3]

	bool isBall() const;
	superquadric::Shape solid() const;
	// What is held against its strength, from its contacts of the step before, see BreakageEngine.criterion [Pa].
	Real stress(const std::string& criterion, const Scene& scene) const;
};

} // namespace yade
