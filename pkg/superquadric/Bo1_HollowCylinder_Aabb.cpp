#include "Bo1_HollowCylinder_Aabb.hpp"

namespace yade {

YADE_PLUGIN((Bo1_HollowCylinder_Aabb));

void Bo1_HollowCylinder_Aabb::go(const shared_ptr<Shape>& shape, shared_ptr<Bound>& bound, const Se3r& se3, const Body*)
{
	if (scene->isPeriodic && scene->cell->hasShear()) throw std::logic_error("HollowCylinder is not supported in a sheared cell.");
	if (!bound) bound = shared_ptr<Bound>(new Aabb);
	const HollowCylinder* cylinder = static_cast<HollowCylinder*>(shape.get());
	const Vector3r axis = se3.orientation * Vector3r::UnitZ();
	Vector3r half;
	for (int i = 0; i < 3; ++i) {
		const Real along = std::abs(axis[i]);
		const Real across = std::sqrt(std::max(0., 1 - along * along));
		// An infinite height times no component along it is no extent at all.
		half[i] = cylinder->radius * across + (along > 0 ? along * cylinder->height / 2 : 0);
	}
	bound->min = se3.position - half;
	bound->max = se3.position + half;
}

} // namespace yade
