// The container's wall: the inside of a rigid cylinder.
#pragma once

#include <core/Shape.hpp>
#include <core/State.hpp>
#include <pkg/support/AcceptedAttributes.hpp>

namespace yade {

class HollowCylinder : public Shape {
public:
	~HollowCylinder() override = default;

	// Unit vector along the axis, in space.
	static Vector3r axis(const State& state) { return state.ori * Vector3r::UnitZ(); }
	// Whether a point lies between the two ends.
	bool spans(const Vector3r& point, const State& state) const { return std::abs((point - state.pos).dot(axis(state))) <= height / 2; }
	// Distance of a point from the axis [m].
	static Real distanceFromAxis(const Vector3r& point, const State& state) { return axis(state).cross(point - state.pos).norm(); }

	// As of a wall, see Superquadric::getVolume.
	Real getVolume() { return 0; }

	// Called by YADE after the attributes were set or loaded. Refused values are put back before the error leaves.
	void postLoad(HollowCylinder&);

private:
	AcceptedAttributes accepted;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(HollowCylinder, Shape,
		"Inside of a rigid circular cylinder: a container's wall, exact, without facets. The axis is the body's local z axis through "
		"its position, which is the middle of the axis. Only the inner side holds particles back: a contact begins only for a particle "
		"whose centre is inside, and only where the particle's deepest point lies between the ends, at axial coordinates within "
		"[-height/2, height/2]; the rim is not modelled. The cylinder has no bottom: add a :yref:`Wall`. "
		"Refused values raise ValueError naming the parameter and the value; the shape then stays as it was.",
		((Real, radius, 1, Attr::triggerPostLoad, "Inner radius [m]; positive and finite."))
		((Real, height, 1, Attr::triggerPostLoad, "Length along the axis [m]; positive, may be infinite."))
		, createIndex(); postLoad(*this);,
		.def("getVolume", &HollowCylinder::getVolume, "Volume [m^3], as of YADE's walls since YADE 2026.1: 0.")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(HollowCylinder, Shape);
};
REGISTER_SERIALIZABLE(HollowCylinder);

} // namespace yade
