#include "HollowCylinder.hpp"

#include <pkg/support/Checks.hpp>

namespace yade {

YADE_PLUGIN((HollowCylinder));

void HollowCylinder::postLoad(HollowCylinder&)
{
	accepted.accept({ &radius, &height }, [this] {
		requirePositive("radius", radius);
		if (!(height > 0)) refuse("height", "positive", height);
	});
}

} // namespace yade
