#include "VibratingBoxEngine.hpp"

#include <core/EnergyTracker.hpp>
#include <pkg/dem/NewtonIntegrator.hpp>
#include <pkg/mechanics/Oscillator.hpp>
#include <pkg/support/Checks.hpp>

#include <algorithm>

namespace yade {

YADE_PLUGIN((VibratingBoxEngine));

namespace oscillator = superquadric::oscillator;

namespace {
	void requireNotNegative(const char* name, const Vector3r& value)
	{
		if (!value.allFinite() || value.minCoeff() < 0) refuse(name, "finite and not negative", value.transpose());
	}

	int axisOf(char letter) { return letter - 'x'; }
}

AcceptedAttributes::References VibratingBoxEngine::checkedAttributes()
{
	return { &freeAxes, &mass, &frequency, &phase, &stiffness, &damping, &forceAmplitude, &displacement, &velocity };
}

void VibratingBoxEngine::check() const
{
	for (const char letter : freeAxes)
		if (axisOf(letter) < 0 || axisOf(letter) > 2 || std::count(freeAxes.begin(), freeAxes.end(), letter) > 1)
			refuse("freeAxes", "some of x, y, z, each once at most", freeAxes);
	requirePositive("mass", mass);
	requireNotNegative("stiffness", stiffness);
	requireNotNegative("damping", damping);
	requireFinite("forceAmplitude", forceAmplitude);
	if (!(std::isfinite(frequency) && frequency >= 0)) refuse("frequency", "finite and not negative", frequency);
	if (!std::isfinite(phase)) refuse("phase", "finite", phase);
	requireFinite("displacement", displacement);
	requireFinite("velocity", velocity);
}

void VibratingBoxEngine::postLoad(VibratingBoxEngine&)
{
	accepted.accept(checkedAttributes(), [this] { check(); });
}

void VibratingBoxEngine::action()
{
	findReferences();
	const Load now = load();
	const Vector3r before = freePart(velocity);
	const Vector3r force = now.contacts + now.weight + now.drive - stiffness.cwiseProduct(displacement);
	const Vector3r next = freePart(oscillator::nextVelocity(now.mass, damping, force, before, scene->dt));
	requireFiniteStep(now, next);
	velocity = next;
	const Vector3r dashpot = oscillator::dashpotForce(damping, before, velocity);
	if (scene->trackEnergy) book(now, dashpot, before);
	moveMembers();

	contactForce = now.contacts;
	contactImpulse += scene->dt * now.contacts;
	lastWay = scene->dt * velocity;
	lastDrive = now.drive;
	lastDashpot = dashpot;
	displacement += lastWay;
	accepted.remember(checkedAttributes()); // what a later refusal goes back to
}

// A box that has been thrown out of all numbers, by springs too stiff for the time step or by particles that are there already, would take everything
// along and could not be set right any more.
void VibratingBoxEngine::requireFiniteStep(const Load& now, const Vector3r& next) const
{
	const Vector3r impulse = scene->dt * now.contacts, way = scene->dt * next;
	const bool membersStay = std::all_of(references.begin(), references.end(), [&](const Vector3r& x) { return (x + displacement + way).allFinite(); });
	if (membersStay && (contactImpulse + impulse).allFinite() && next.allFinite() && (displacement + way).allFinite()) return;
	std::ostringstream message;
	message << "VibratingBoxEngine: the box would get the velocity " << next.transpose() << " m/s at displacement " << displacement.transpose()
	        << " m, from forces on its members of " << now.contacts.transpose() << " N and a drive of " << now.drive.transpose() << " N; is O.dt = "
	        << scene->dt << " s too long?";
	throw std::invalid_argument(message.str());
}

// A member may be moved by its velocity alone, and forces on clumps and their members are not yet summed up here.
State& VibratingBoxEngine::member(Body::id_t id) const
{
	if (!scene->bodies->exists(id)) refuse("ids", "of bodies in the scene", id);
	const Body& body = *(*scene->bodies)[id];
	if (body.isClump() || body.isClumpMember()) refuse("ids", "of bodies that belong to no clump", id);
	if (body.state->blockedDOFs != State::DOF_ALL) refuse("ids", "of bodies with all degrees of freedom blocked", id);
	return *body.state;
}

void VibratingBoxEngine::findReferences()
{
	if (seenIds == ids) return;
	std::vector<Vector3r> found;
	found.reserve(ids.size());
	for (const Body::id_t id : ids)
		found.emplace_back(member(id).pos - displacement);
	references = found;
	seenIds = ids;
}

VibratingBoxEngine::Load VibratingBoxEngine::load() const
{
	scene->forces.sync();
	Load sum { Vector3r::Zero(), Vector3r::Zero(), freePart(oscillator::harmonicForce(forceAmplitude, frequency, phase, scene->time)), mass };
	for (const Body::id_t id : ids) {
		sum.mass += member(id).mass;
		sum.contacts += scene->forces.getForce(id);
	}
	sum.weight = (ownWeight ? sum.mass : sum.mass - mass) * gravity();
	return sum;
}

// Of the integrator that moves the members, which must come after this engine.
Vector3r VibratingBoxEngine::gravity() const
{
	bool later = false;
	for (const auto& engine : scene->engines) {
		if (engine.get() == this) later = true;
		const auto* newton = dynamic_cast<const NewtonIntegrator*>(engine.get());
		if (newton && later) return newton->gravity;
	}
	throw std::invalid_argument("VibratingBoxEngine: there is no NewtonIntegrator after it in O.engines");
}

Vector3r VibratingBoxEngine::freePart(const Vector3r& vector) const
{
	Vector3r part = Vector3r::Zero();
	for (const char letter : freeAxes)
		part[axisOf(letter)] = vector[axisOf(letter)];
	return part;
}

// Each sum gets the work over the last step, by the mean of the force before and after, as the contact laws count it.
void VibratingBoxEngine::book(const Load& now, const Vector3r& dashpot, const Vector3r& before) const
{
	const auto add = [&](const char* name, Real value, bool isState) {
		int id = -1; // looked up every time: O.energy.clear() may have emptied the list
		scene->energy->add(value, name, id, isState);
	};
	add("boxKinetic", oscillator::kineticEnergy(mass, before, velocity), true);
	add("boxSpring", oscillator::springEnergy(stiffness, displacement), true);
	add("boxDashpot", -lastWay.dot(lastDashpot + dashpot) / 2, false);
	add("boxDrive", -lastWay.dot(lastDrive + now.drive) / 2, false);
	if (ownWeight) add("gravWork", -mass * lastWay.dot(gravity()), false);
}

// NewtonIntegrator adds a way to the members' positions at every step, and the roundings of these sums would part members from the
// box: so they are put where the box is. Damping by YADE would be booked for bodies that move, though blocked ones do not feel it.
void VibratingBoxEngine::moveMembers() const
{
	for (std::size_t i = 0; i < ids.size(); ++i) {
		State& state = member(ids[i]);
		state.pos = references[i] + displacement;
		state.vel = velocity;
		state.isDamped = false;
	}
}

} // namespace yade
