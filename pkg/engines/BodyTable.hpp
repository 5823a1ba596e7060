// The bodies of a scene as the contact loop needs them, side by side in memory, once per step.
#pragma once

#include <core/Scene.hpp>
#include <pkg/contact/MovingBody.hpp>
#include <pkg/superquadric/Superquadric.hpp>

#include <optional>
#include <vector>

namespace yade {

class BodyTable {
public:
	struct Row {
		std::optional<superquadric::Placement> placement; // of a superquadric only
		std::optional<MovingBody> motion; // likewise
		const Shape* shape = nullptr;
	};

	// Takes the present positions and velocities. True when a body has come, gone or changed its shape since the last time.
	bool update(const Scene& scene, int threads);

	const Row& operator[](Body::id_t id) const { return rows[id]; }
	bool isSuperquadric(Body::id_t id) const { return size_t(id) < rows.size() && rows[id].placement.has_value(); }

private:
	static bool refresh(Row& row, const shared_ptr<Body>& body, const Scene& scene);

	std::vector<Row> rows;
};

} // namespace yade
