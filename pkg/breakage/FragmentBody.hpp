// From a piece to a body of YADE.
#pragma once

#include <core/Body.hpp>
#include <pkg/mechanics/Fragments.hpp>
#include <pkg/geometry/Shape.hpp>

namespace yade {

// A fragment of `old`, which has the shape `whole` and a BreakableState: of the same kind, material and look, born at `step` but not yet in the
// scene. The offset from the parent's centre [m] and the spin [rad/s] are along the axes of space.
shared_ptr<Body> fragmentOf(const Body& old, const superquadric::Shape& whole, const superquadric::fragments::Piece& piece, const Vector3r& offset,
        const Vector3r& spin, long step);

} // namespace yade
