// What all contact functors of this package share: they hand the solver's answer to the interaction.
#pragma once

#include "Superquadric.hpp"
#include "SuperquadricGeom.hpp"
#include "ThreadCounters.hpp"

#include <core/Dispatching.hpp>
#include <core/Scene.hpp>

namespace yade {

// The two bodies of an interaction, as YADE passes them to a functor.
struct ContactPair {
	const State &state1, &state2;
	const Vector3r& shift2; // of body 2's periodic image [m]
	const bool force; // the user asks for an interaction even of bodies that do not touch
	const shared_ptr<Interaction>& interaction;
	const Scene* scene;

	Vector3r position2() const { return state2.pos + shift2; }
	// A contact that lives, or must, is followed wherever it goes; others are looked at only where they may begin.
	bool mustBeKept() const { return force || interaction->isReal(); }
	superquadric::WarmStart warmStart() const;

	// Both take the solver's answer, `touch` that of bodies that touch, `part` any other, and give what the functor returns.
	bool touch(const superquadric::Contact& contact, const SuperquadricGeom::Side& side1, const SuperquadricGeom::Side& side2,
	        const superquadric::WarmStart& warm = {}) const;
	bool part(const superquadric::Contact& contact, const superquadric::WarmStart& warm = {}) const;

private:
	SuperquadricGeom& geom() const;
};

// Whether the law has something to do: rounding may leave a proven overlap without depth.
inline bool touches(const superquadric::Contact& contact) { return contact.overlapping() && contact.overlap > 0; }

// A superquadric at a contact, where the surface point has the given curvature.
SuperquadricGeom::Side sideOf(const superquadric::Placement& body, const Vector3r& surface, const Vector3r& normal, Real curvature);

// Base of the functors.
class SuperquadricGeomFunctor : public IGeomFunctor {
public:
	bool go(const shared_ptr<Shape>& shape1, const shared_ptr<Shape>& shape2, const State& state1, const State& state2,
	        const Vector3r& shift2, const bool& force, const shared_ptr<Interaction>& interaction) override
	{
		return solve(*shape1, *shape2, { state1, state2, shift2, force, interaction, scene });
	}
	// The shapes come in the other order: name the bodies the other way round, then all is as above.
	bool goReverse(const shared_ptr<Shape>& shape1, const shared_ptr<Shape>& shape2, const State& state1, const State& state2,
	        const Vector3r& shift2, const bool& force, const shared_ptr<Interaction>& interaction) override
	{
		interaction->swapOrder();
		return go(shape2, shape1, state2, state1, -shift2, force, interaction); // NOLINT(readability-suspicious-call-argument)
	}
	boost::python::dict counters() const { return solverCounters.asDict(); }
	void resetCounters() { solverCounters.reset(); }

protected:
	// The shapes are of the functor's two types, in its order. May run in several threads, on different interactions.
	virtual bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair);

	ThreadCounters solverCounters;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(SuperquadricGeomFunctor, IGeomFunctor,
		"Base of the functors that create and update a :yref:`SuperquadricGeom`; not to be used by itself."
		, , , .def("counters", &SuperquadricGeomFunctor::counters, "Dictionary of the contact solver's counts since the functor was made or "
			"resetCounters was called, all threads together. The entry uncertified must stay 0.")
		.def("resetCounters", &SuperquadricGeomFunctor::resetCounters, "Set the solver's counts to zero.")
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(SuperquadricGeomFunctor);

} // namespace yade
