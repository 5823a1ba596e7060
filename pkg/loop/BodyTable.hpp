// The bodies of a scene as the contact loop needs them, side by side in memory, once per step.
#pragma once

#include <core/Scene.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/support/MovingBody.hpp>
#include <pkg/superquadric/Superquadric.hpp>

#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace yade {

class BodyTable {
public:
	struct Row {
		std::optional<superquadric::Placement> placement; // of a superquadric only
		std::optional<MovingBody> motion; // likewise
		// Known by its owner, so that no other can take its address unnoticed; but not kept alive: a shape made in Python must be let go of by a
		// thread that holds Python's lock.
		boost::weak_ptr<Shape> shape;
		const Superquadric* particle = nullptr; // the same, if it is one
		const Sphere* sphere = nullptr; // likewise
		Vector3r centre; // of a sphere only [m]
		Real radius = 0; // likewise
	};

	// Takes the present positions and velocities. True when a body has come, gone or changed its shape since the last time, or when the sums of
	// travel are used up: all travels are then zero again.
	bool update(const Scene& scene, int threads);

	const Row& operator[](Body::id_t id) const { return rows[id]; }
	// How far any point of a superquadric, or a sphere's centre, may have moved in all, since the table was last made anew [m].
	Real travel(Body::id_t id) const { return travels[id]; }
	bool isSuperquadric(Body::id_t id) const { return size_t(id) < rows.size() && rows[id].placement.has_value(); }
	bool isSphere(Body::id_t id) const { return size_t(id) < rows.size() && rows[id].sphere; }

private:
	void forget(size_t size);
	bool refresh(Body::id_t id, const shared_ptr<Body>& body, const Scene& scene);
	bool refreshSuperquadric(Body::id_t id, const Body& body, const Scene& scene, bool changed);
	bool refreshSphere(Body::id_t id, const State& state, bool changed);
	bool addTravel(Body::id_t id, Real moved, Real size);
	void place(Row& row, const State& state);
	static Real motionBound(const superquadric::Placement& before, const superquadric::Placement& after);

	std::vector<Row> rows;
	std::vector<Real> travels;
	// Equal bodies share one shape, which so stays in the processor's nearest memory; by half sizes and exponents.
	std::map<std::array<double, 5>, superquadric::Shape> shapes;
	std::mutex addingShape;
};

} // namespace yade
