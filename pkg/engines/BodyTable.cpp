#include "BodyTable.hpp"

namespace yade {

bool BodyTable::update(const Scene& scene, int threads)
{
	const auto& bodies = *scene.bodies;
	const long size = bodies.size();
	bool changed = size != long(rows.size());
	if (changed) rows = std::vector<Row>(size);
#ifdef YADE_OPENMP
#pragma omp parallel for schedule(static) num_threads(threads) reduction(|| : changed)
#endif
	for (long id = 0; id < size; ++id)
		if (refresh(rows[id], bodies[id], scene)) changed = true;
	return changed;
}

bool BodyTable::refresh(Row& row, const shared_ptr<Body>& body, const Scene& scene)
{
	const Shape* shape = body && !body->isClump() ? body->shape.get() : nullptr;
	const bool changed = shape != row.shape;
	if (changed) {
		row.shape = shape;
		row.placement.reset();
		row.motion.reset();
	}
	const bool wasSuperquadric = row.placement.has_value();
	const auto* ours = !shape ? nullptr : wasSuperquadric && !changed ? static_cast<const Superquadric*>(shape) : dynamic_cast<const Superquadric*>(shape);
	if (ours) {
		row.placement.emplace(ours->placement(*body->state));
		row.motion.emplace(*body, scene);
	}
	return changed;
}

} // namespace yade
