#include "BodyTable.hpp"

#include <pkg/geometry/Tolerances.hpp>

namespace yade {

namespace {
	// With MPI, bodies of other ranks are here for the contacts across the border only.
	bool isOfThisRank(const Body& body, const Scene& scene)
	{
#ifdef YADE_MPI
		return body.subdomain == scene.subdomain;
#else
		return true;
#endif
	}

	bool isOf(const boost::weak_ptr<Shape>& known, const shared_ptr<Shape>& shape) { return !known.owner_before(shape) && !shape.owner_before(known); }
}

bool BodyTable::update(const Scene& scene, int threads)
{
	const auto& bodies = *scene.bodies;
	const long size = bodies.size();
	// Of grains that grow, no two steps have the same shapes.
	bool changed = size != long(rows.size()) || shapes.size() > size_t(2 * size);
	if (changed) forget(size);
#ifdef YADE_OPENMP
#pragma omp parallel for schedule(static) num_threads(threads) reduction(|| : changed)
#endif
	for (long id = 0; id < size; ++id)
		if (refresh(id, bodies[id], scene)) changed = true;
	if (changed) travels.assign(size, 0);
	return changed;
}

void BodyTable::forget(size_t size)
{
	rows = std::vector<Row>(size);
	travels.assign(size, 0);
	shapes.clear();
}

bool BodyTable::refresh(Body::id_t id, const shared_ptr<Body>& body, const Scene& scene)
{
	Row& row = rows[id];
	const bool takesPart = body && !body->isClump() && isOfThisRank(*body, scene);
	const shared_ptr<Shape> none, &shape = takesPart ? body->shape : none;
	const bool changed = !isOf(row.shape, shape);
	if (changed) {
		row.shape = shape;
		row.particle = dynamic_cast<const Superquadric*>(shape.get());
		row.sphere = dynamic_cast<const Sphere*>(shape.get());
		row.placement.reset();
		row.motion.reset();
	}
	if (row.sphere) return refreshSphere(id, *body->state, changed);
	return row.particle ? refreshSuperquadric(id, *body, scene, changed) : changed;
}

bool BodyTable::refreshSuperquadric(Body::id_t id, const Body& body, const Scene& scene, bool changed)
{
	Row& row = rows[id];
	changed |= row.placement && !(row.placement->shape == row.particle->solid()); // attributes set anew
	const std::optional<superquadric::Placement> before = row.placement;
	place(row, *body.state);
	row.motion.emplace(body, scene);
	return changed || !addTravel(id, motionBound(*before, *row.placement), row.placement->shape.boundingRadius());
}

bool BodyTable::refreshSphere(Body::id_t id, const State& state, bool changed)
{
	Row& row = rows[id];
	changed |= row.radius != row.sphere->radius;
	const Real moved = (state.pos - row.centre).norm();
	row.radius = row.sphere->radius;
	row.centre = state.pos;
	return changed || !addTravel(id, moved, row.radius);
}

// False when the sum is used up.
bool BodyTable::addTravel(Body::id_t id, Real moved, Real size)
{
	if (!std::isfinite(moved)) return false; // a place that is not a number proves nothing, coming or going
	if (moved > 0) travels[id] = (travels[id] + moved) * (1 + superquadric::tolerances::sumRounding); // never less than the sum
	return travels[id] < superquadric::tolerances::longestTravel * size;
}

void BodyTable::place(Row& row, const State& state)
{
	const superquadric::Shape& own = row.particle->solid();
	const superquadric::Shape* shared = row.placement && row.placement->shape == own ? &row.placement->shape : nullptr;
	if (!shared) {
		const std::lock_guard<std::mutex> lock(addingShape);
		const Vector3r& sizes = own.halfSizes();
		shared = &shapes.try_emplace({ sizes.x(), sizes.y(), sizes.z(), own.n1(), own.n2() }, own).first->second;
	}
	row.placement.emplace(*shared, state.pos, state.ori.toRotationMatrix());
}

// The rotation by an angle moves a point at the distance R by 2 R sin(angle/2) at most, and changes the matrix by sqrt(8) sin(angle/2).
Real BodyTable::motionBound(const superquadric::Placement& before, const superquadric::Placement& after)
{
	return (after.position - before.position).norm() + after.shape.boundingRadius() * (after.rotation - before.rotation).norm() * M_SQRT1_2;
}

} // namespace yade
