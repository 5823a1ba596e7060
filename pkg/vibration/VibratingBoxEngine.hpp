// A rigid box on springs, driven by a harmonic force: YADE's side of pkg/mechanics/Oscillator.hpp.
#pragma once

#include <core/PartialEngine.hpp>
#include <core/Scene.hpp>
#include <pkg/support/AcceptedAttributes.hpp>

namespace yade {

class VibratingBoxEngine : public PartialEngine {
public:
	void action() override;

	// Called by YADE after the attributes were set or loaded. Refused values are put back before the error leaves.
	void postLoad(VibratingBoxEngine&);

	// By value and through the check: a reference would let `box.stiffness[2] = -1` pass.
	template <Vector3r VibratingBoxEngine::* attribute>
	static void setVector(VibratingBoxEngine& box, const Vector3r& value)
	{
		box.*attribute = value;
		box.callPostLoad();
	}
	template <Vector3r VibratingBoxEngine::* attribute>
	static Vector3r getVector(const VibratingBoxEngine& box) { return box.*attribute; }

private:
	// What acts on the box at a step, beside its springs.
	struct Load {
		Vector3r contacts, weight, drive; // [N]
		Real mass; // of the box and its members [kg]
	};

	AcceptedAttributes::References checkedAttributes();
	void check() const;
	State& member(Body::id_t id) const;
	void findReferences();
	Load load() const;
	void requireFiniteStep(const Load& now, const Vector3r& next) const;
	Vector3r gravity() const;
	Vector3r freePart(const Vector3r& vector) const;
	void book(const Load& now, const Vector3r& dashpot, const Vector3r& before) const;
	void moveMembers() const;

	AcceptedAttributes accepted;

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(VibratingBoxEngine, PartialEngine,
		"Moves the bodies :yref:`ids<PartialEngine.ids>` (walls, facets, particles frozen to them) together as one rigid box that does not turn: "
			"along each of the freeAxes it has a mass on a spring and a dashpot, "
		"driven by the harmonic force forceAmplitude sin(2 pi frequency O.time + phase) and by all the forces that act on its members. It is "
			"integrated by YADE's leap-frog.\n\n"
		"It goes into O.engines after the contact loop and before :yref:`NewtonIntegrator`, which moves the members with the velocity that they are "
			"given here. Members must have all degrees of freedom blocked and belong to no "
		"clump. Where they are when they are first seen belongs to the displacement of that time; from then on they are kept there relative to the "
			"box, to the last digit. A change of displacement moves them in the next step.\n\n"
		"The box weighs mass plus the masses of its members (walls have none). The members are under the gravity of NewtonIntegrator, the box itself "
			"is by default not: displacement then counts from where the springs carry "
		"the empty box (ownWeight). For the contact law the box counts as infinitely heavy.\n\n"
		"With O.trackEnergy, O.energy has: 'boxKinetic' (of mass, without the members': those are in YADE's 'kinetic') and 'boxSpring', now; the "
			"sums 'boxDashpot' (taken out) and 'boxDrive' (the work of the drive, negative like YADE's 'gravWork', "
		"because it comes from outside). Those of a linear box alone add up to a constant to rounding; together with what contacts, particles and "
			"gravity have booked, to a constant up to the error of the time step. YADE's 'kinetic' "
		"belongs to half a step before all others; what it has of members, to half a step after.\n\n"
		"A value that is refused raises ValueError naming the parameter and the value; the box then stays as it was. Members that cannot be raise it "
			"at the step, before anything moves.",
		((std::string, freeAxes, "z", Attr::triggerPostLoad, "Axes along which the box is free: each of x, y, z at most once. Along the others it is "
			"held where it is; '' holds it altogether."))
		((Real, mass, 1, Attr::triggerPostLoad, "Of the box without its members, positive [kg]."))
		((Vector3r, stiffness, Vector3r::Zero(), Attr::triggerPostLoad, "Of the springs along the axes, not negative [N/m]. [defined below]"))
		((Vector3r, damping, Vector3r::Zero(), Attr::triggerPostLoad, "Of the dashpots along the axes, not negative [N s/m]. [defined below]"))
		((Vector3r, forceAmplitude, Vector3r::Zero(), Attr::triggerPostLoad, "Of the driving force [N]. [defined below]"))
		((Real, frequency, 0, Attr::triggerPostLoad, "Of the driving force, not negative [Hz]."))
		((Real, phase, 0, Attr::triggerPostLoad, "Of the driving force at O.time = 0 [rad]."))
		((bool, ownWeight, false, , "Whether gravity acts on mass as well, so that displacement counts from where the springs are slack."))
		((Vector3r, displacement, Vector3r::Zero(), Attr::triggerPostLoad, "Of the box, where the members are after the step [m]. [defined below]"))
		((Vector3r, velocity, Vector3r::Zero(), Attr::triggerPostLoad, "Of the box, as of YADE's bodies that of half a step earlier [m/s]. [defined "
			"below]"))
		((Vector3r, contactForce, Vector3r::Zero(), Attr::readonly, "Sum of the forces on the members at the beginning of the last step, without "
			"their weight [N]."))
		((Vector3r, contactImpulse, Vector3r::Zero(), , "Sum of contactForce times the time step so far [N s]."))
		((std::vector<int>, seenIds, , Attr::hidden, "Members that `references` belongs to."))
		((std::vector<Vector3r>, references, , Attr::hidden, "Members' positions at displacement zero [m]."))
		((Vector3r, lastWay, Vector3r::Zero(), Attr::hidden, "By which the box moved in the last step [m]."))
		((Vector3r, lastDrive, Vector3r::Zero(), Attr::hidden, "Driving force at its beginning [N]."))
		((Vector3r, lastDashpot, Vector3r::Zero(), Attr::hidden, "Dashpots' force then [N]."))
		, accepted.remember(checkedAttributes());,
		.add_property("stiffness", &VibratingBoxEngine::getVector<&VibratingBoxEngine::stiffness>, &VibratingBoxEngine::setVector<&VibratingBoxEngine::stiffness>,
			"Of the springs along the axes, not negative [N/m]. Assign all three: reading gives a copy, here and below.")
		.add_property("damping", &VibratingBoxEngine::getVector<&VibratingBoxEngine::damping>, &VibratingBoxEngine::setVector<&VibratingBoxEngine::damping>,
			"Of the dashpots along the axes, not negative [N s/m].")
		.add_property("forceAmplitude", &VibratingBoxEngine::getVector<&VibratingBoxEngine::forceAmplitude>, &VibratingBoxEngine::setVector<&VibratingBoxEngine::forceAmplitude>,
			"Of the driving force, along each axis [N]; what points along an axis that is held is ignored.")
		.add_property("displacement", &VibratingBoxEngine::getVector<&VibratingBoxEngine::displacement>, &VibratingBoxEngine::setVector<&VibratingBoxEngine::displacement>,
			"Of the box, where the members are after the step [m].")
		.add_property("velocity", &VibratingBoxEngine::getVector<&VibratingBoxEngine::velocity>, &VibratingBoxEngine::setVector<&VibratingBoxEngine::velocity>,
			"Of the box, as of YADE's bodies that of half a step earlier [m/s].")
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(VibratingBoxEngine);

} // namespace yade
