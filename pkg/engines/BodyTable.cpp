#include "BodyTable.hpp"

namespace yade {

bool BodyTable::update(const Scene& scene, int threads)
{
	const auto& bodies = *scene.bodies;
	const long size = bodies.size();
	bool changed = size != long(rows.size());
	if (changed) {
		rows = std::vector<Row>(size);
		shapes.clear();
	}
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
		place(row, *ours, *body->state);
		row.motion.emplace(*body, scene);
	}
	return changed;
}

void BodyTable::place(Row& row, const Superquadric& shape, const State& state)
{
	const superquadric::Shape& own = shape.solid();
	const superquadric::Shape* shared = row.placement && row.placement->shape == own ? &row.placement->shape : nullptr;
	if (!shared) {
		const std::lock_guard<std::mutex> lock(addingShape);
		const Vector3r& sizes = own.halfSizes();
		shared = &shapes.try_emplace({ sizes.x(), sizes.y(), sizes.z(), own.n1(), own.n2() }, own).first->second;
	}
	row.placement.emplace(*shared, state.pos, state.ori.toRotationMatrix());
}

} // namespace yade
