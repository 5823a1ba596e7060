#include "HollowCylinder.hpp"

#include <pkg/support/Checks.hpp>

namespace yade {

YADE_PLUGIN((HollowCylinder));

void HollowCylinder::postLoad(HollowCylinder&)
{
	try {
		requirePositive("radius", radius);
		if (!(height > 0)) refuse("height", "positive", height);
	} catch (const std::invalid_argument&) {
		radius = validRadius;
		height = validHeight;
		throw;
	}
	validRadius = radius;
	validHeight = height;
}

} // namespace yade
