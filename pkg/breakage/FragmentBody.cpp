#include "FragmentBody.hpp"

#include "BreakableMat.hpp"

#include <pkg/common/Sphere.hpp>
#include <pkg/mechanics/FragmentMotion.hpp>
#include <pkg/geometry/Tolerances.hpp>
#include <pkg/superquadric/Superquadric.hpp>

namespace yade {

namespace fragments = superquadric::fragments;

namespace {
	shared_ptr<Shape> fragmentShape(const Shape& old, const superquadric::Shape& part)
	{
		shared_ptr<Shape> shape;
		if (dynamic_cast<const Sphere*>(&old)) {
			const shared_ptr<Sphere> ball(new Sphere);
			ball->radius = part.smallestHalfSize();
			shape = ball;
		} else {
			const shared_ptr<Superquadric> block(new Superquadric);
			block->n1 = part.n1();
			block->n2 = part.n2();
			block->setExtents(part.halfSizes());
			shape = block;
		}
		shape->color = old.color;
		shape->wire = old.wire;
		shape->highlight = old.highlight;
		return shape;
	}
}

shared_ptr<Body> fragmentOf(const Body& old, const superquadric::Shape& whole, const fragments::Piece& piece, const Vector3r& offset, const Vector3r& spin,
        long step)
{
	const auto& parent = static_cast<const BreakableState&>(*old.state);
	const superquadric::Shape part(whole.halfSizes().cwiseProduct(piece.scale), whole.n1(), whole.n2());
	const shared_ptr<Body> body(new Body);
	body->shape = fragmentShape(*old.shape, part);
	body->material = old.material;
	body->groupMask = old.groupMask;
#ifdef YADE_MPI
	body->subdomain = old.subdomain;
#endif
	body->state = static_cast<const BreakableMat&>(*old.material).newAssocState(); // a plain Material would make a State, too small for what follows
	auto& state = static_cast<BreakableState&>(*body->state);
	state.pos = state.refPos = parent.pos + offset;
	state.ori = state.refOri = parent.ori;
	state.vel = parent.vel + spin.cross(offset);
	state.angVel = spin;
	state.mass = piece.share * parent.mass;
	state.inertia = state.mass * fragments::inertiaOfUnitMass(part);
	state.angMom = state.ori * state.inertia.cwiseProduct(state.ori.conjugate() * spin);
	state.blockedDOFs = parent.blockedDOFs;
	state.isDamped = parent.isDamped;
	state.densityScaling = parent.densityScaling;
	state.birthStep = step;
	state.generation = parent.generation + 1;
	state.parent = old.getId();
	state.ancestor = parent.ancestor >= 0 ? parent.ancestor : old.getId();
	body->setAspherical(state.inertia.maxCoeff() - state.inertia.minCoeff() > superquadric::tolerances::isotropic * state.inertia.maxCoeff());
	return body;
}

} // namespace yade
