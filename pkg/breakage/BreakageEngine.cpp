#include "BreakageEngine.hpp"

#include "FragmentBody.hpp"
#include "ParticleContacts.hpp"

#include <core/EnergyTracker.hpp>
#include <core/InteractionLoop.hpp>
#include <lib/high-precision/Constants.hpp>
#include <lib/pyutil/gil.hpp>
#include <pkg/common/Collider.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/contact/CurvatureLaw.hpp>
#include <pkg/geometry/Tolerances.hpp>
#include <pkg/support/Checks.hpp>
#include <pkg/superquadric/Superquadric.hpp>

#include <algorithm>

namespace yade {

YADE_PLUGIN((BreakageEngine));

namespace fragments = superquadric::fragments;

namespace {
	// What the random numbers of a particle are for; each has numbers of its own.
	enum Purpose {
		Strength,
		Cut,
		Turn,
	};

	bool isOneOf(const std::string& value, std::initializer_list<const char*> choices)
	{
		return std::any_of(choices.begin(), choices.end(), [&](const char* choice) { return value == choice; });
	}
}

AcceptedAttributes::References BreakageEngine::checkedAttributes()
{
	return { &criterion, &mode, &cutExponent, &smallestFragment, &inertialSize, &maxEvents, &seed };
}

void BreakageEngine::check() const
{
	if (!isOneOf(criterion, { "octahedral", "force" })) refuse("criterion", "'octahedral' or 'force'", criterion);
	if (!isOneOf(mode, { "cube", "balls4", "balls18" })) refuse("mode", "'cube', 'balls4' or 'balls18'", mode);
	requirePositive("cutExponent", cutExponent);
	requireNotNegative("smallestFragment", smallestFragment);
	requireNotNegative("inertialSize", inertialSize);
	if (inertialSize > superquadric::tolerances::largestHalfSize) refuse("inertialSize", "no larger than a particle may be", inertialSize);
	if (maxEvents < 1) refuse("maxEvents", "at least 1", maxEvents);
	if (seed < 0) refuse("seed", "not negative", seed);
}

void BreakageEngine::postLoad(BreakageEngine&)
{
	accepted.accept(checkedAttributes(), [this] { check(); });
}

void BreakageEngine::action()
{
	checkOrder();
	releaseErased();
	std::vector<Event> events = collect();
	const auto firstToWait = std::partition_point(events.begin(), events.end(), [](const Event& event) { return event.forced; });
	const auto byExcess = [](const Event& a, const Event& b) { return a.value / a.parent.state->strength > b.value / b.parent.state->strength; };
	std::stable_sort(firstToWait, events.end(), byExcess);
	const std::ptrdiff_t asked = events.end() - firstToWait, left = std::max<std::ptrdiff_t>(0, asked - maxEvents);
	events.erase(events.end() - left, events.end());
	if (!events.empty()) checkLaws();
	const std::vector<fragments::Pieces> pieces = cutAll(events);
	waiting = int(left);
	forced.clear();
	for (std::size_t i = 0; i < events.size(); ++i)
		breakUp(events[i], pieces[i]);
}

void BreakageEngine::releaseErased()
{
	if (gone.empty()) return;
	const gilLock lock;
	gone.clear();
}

void BreakageEngine::checkOrder() const
{
	bool met = false;
	for (const auto& engine : scene->engines) {
		met |= engine.get() == this;
		if (!met && (dynamic_cast<Collider*>(engine.get()) || dynamic_cast<InteractionLoop*>(engine.get())))
			throw std::invalid_argument("BreakageEngine must stand before the collider and the contact loop in O.engines");
	}
}

// Forced ones first, then those at their strength, both by id.
std::vector<BreakageEngine::Event> BreakageEngine::collect()
{
	std::vector<int> ids = forced;
	std::sort(ids.begin(), ids.end());
	ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
	std::vector<Event> events;
	for (const Body::id_t id : ids) {
		if (!scene->bodies->exists(id)) refuse("forced", "ids of bodies in the scene", id);
		const auto particle = candidate(*(*scene->bodies)[id]);
		if (!particle) refuse("forced", "ids of particles that can break", id);
		events.push_back({ *particle, particle->stress(criterion, *scene), /*forced*/ true });
	}
	for (const auto& body : *scene->bodies) {
		const auto particle = candidate(*body);
		if (!particle || std::binary_search(ids.begin(), ids.end(), body->getId())) continue;
		const Real value = particle->stress(criterion, *scene);
		if (value >= particle->state->strength) events.push_back({ *particle, value, /*forced*/ false });
	}
	return events;
}

std::optional<BreakableParticle> BreakageEngine::candidate(Body& body)
{
	const auto* material = dynamic_cast<const BreakableMat*>(body.material.get());
	if (!material || !body.isStandalone() || body.state->blockedDOFs == State::DOF_ALL) return std::nullopt;
	const Real volume = volumeOf(body), size = std::cbrt(6 * volume / Mathr::PI);
	if (!(volume > 0) || size < material->smallestSize || !canBeCut(body, size)) return std::nullopt;
	auto* state = dynamic_cast<BreakableState*>(body.state.get());
	if (!state) refuse("state", "a BreakableState, as material.newAssocState() makes it, of a body of BreakableMat", body.getId());
	if (std::isnan(state->strength)) state->strength = material->law().quantile(size, superquadric::CounterRandom(seed, body.getId(), Strength).uniform());
	if (!(state->strength > 0)) refuse("strength", "positive", state->strength);
	return BreakableParticle { &body, material, state, size, volume };
}

// Of a superquadric it takes logarithms of gamma functions: remembered as long as the shape stays.
Real BreakageEngine::volumeOf(const Body& body)
{
	if (const auto* sphere = dynamic_cast<const Sphere*>(body.shape.get())) return 4. / 3 * Mathr::PI * std::pow(sphere->radius, 3);
	const auto* block = dynamic_cast<const Superquadric*>(body.shape.get());
	if (!block) return 0;
	if (mode != "cube") refuse("mode", "'cube' where superquadrics can break", mode);
	if (volumes.size() < scene->bodies->size()) volumes.resize(scene->bodies->size(), { 0, 0 });
	auto& [fingerprint, volume] = volumes[body.getId()];
	if (volume == 0 || fingerprint != block->solid().fingerprint()) {
		fingerprint = block->solid().fingerprint();
		volume = block->volume();
	}
	return volume;
}

fragments::Least BreakageEngine::least(const Body& body, Real size) const
{
	const auto* block = dynamic_cast<const Superquadric*>(body.shape.get());
	if (block) return { 0, smallestFragment / 2 * block->solid().inverseHalfSizes() }; // wider than that it is larger, too
	return { std::pow(smallestFragment / size, 3), Vector3r::Zero() };
}

bool BreakageEngine::canBeCut(const Body& body, Real size) const
{
	if (mode == "cube") return least(body, size).possible();
	return least(body, size).share <= (mode == "balls4" ? 1. / 4 : 1. / 18);
}

// Before any of them breaks: fragments that cannot be are refused, and nothing has changed then.
std::vector<fragments::Pieces> BreakageEngine::cutAll(const std::vector<Event>& events)
{
	std::vector<fragments::Pieces> all;
	int even = 0;
	for (const Event& event : events) {
		all.push_back(cut(event.parent, even));
		checkFragments(*event.parent.material, event.parent.solid(), all.back());
	}
	evenCuts += even;
	return all;
}

fragments::Pieces BreakageEngine::cut(const BreakableParticle& parent, int& even) const
{
	if (mode == "balls4") return fragments::fourBalls();
	if (mode == "balls18") return fragments::eighteenBalls();
	superquadric::CounterRandom random(seed, parent.body->getId(), Cut);
	auto point = fragments::drawCut(random, cutExponent, least(*parent.body, parent.size));
	if (!point) {
		++even;
		point = Vector3r::Constant(0.5);
	}
	return parent.isBall() ? fragments::ballsOfBlocks(*point) : fragments::blocks(*point);
}

void BreakageEngine::breakUp(const Event& event, const fragments::Pieces& pieces)
{
	const BreakableParticle& parent = event.parent;
	const BreakableState& state = *parent.state;
	const Real factor = state.inertiaFactor;
	const Body::id_t id = parent.body->getId();
	const ParticleContacts contacts(*parent.body, *scene);
	const Real stored = contacts.storedEnergy();
	const superquadric::Shape shape = parent.solid();
	const fragments::Parent before { shape, state.mass / factor, state.inertia / factor, state.ori.toRotationMatrix(), state.angVel, contacts.deepest(), stored, parent.isBall() };
	superquadric::CounterRandom turns(seed, id, Turn);
	const fragments::Layout layout = fragments::arrange(pieces, before, turns);
	if (layout.gains) ++spinGains;

	std::vector<shared_ptr<Body>> born;
	for (std::size_t i = 0; i < pieces.size(); ++i) {
		born.push_back(fragmentOf(*parent.body, shape, pieces[i], layout.offsets[i], layout.spin, scene->iter));
		addInertia(*born.back(), factor);
	}
	const Real spinLoss = before.spinEnergy() - layout.spinEnergy;
	log(event, pieces, stored, spinLoss);
	gone.push_back((*scene->bodies)[id]);
	scene->bodies->erase(id, /*eraseClumpMembers*/ false); // and its interactions
	for (const auto& body : born)
		childIds.push_back(scene->bodies->insert(body));
	if (!scene->trackEnergy) return;
	int entry = -1; // looked up every time: O.energy.clear() may have emptied the list
	scene->energy->add(stored + spinLoss, "breakage", entry, /*reset*/ false);
}

// A law that knows nothing of births would let fragments fly apart: there must be none of them.
void BreakageEngine::checkLaws() const
{
	for (const auto& engine : scene->engines) {
		const auto* loop = dynamic_cast<const InteractionLoop*>(engine.get());
		if (!loop) continue;
		for (const auto& law : loop->lawDispatcher->functors)
			if (!dynamic_cast<const CurvatureLaw*>(law.get()))
				throw std::invalid_argument("BreakageEngine: " + law->getClassName() + " cannot hold fragments that overlap at birth; use a law on the local curvature");
	}
}

// A fragment has been made with its share of its parent's mass.
void BreakageEngine::addInertia(Body& fragment, Real parentFactor) const
{
	auto& state = static_cast<BreakableState&>(*fragment.state);
	const auto* ball = dynamic_cast<const Sphere*>(fragment.shape.get());
	const Real width = 2 * (ball ? ball->radius : static_cast<const Superquadric&>(*fragment.shape).solid().smallestHalfSize());
	state.inertiaFactor = std::pow(std::max(1., inertialSize / width), 2);
	const Real change = state.inertiaFactor / parentFactor;
	state.mass *= change;
	state.inertia *= change;
	state.angMom *= change;
}

// A fragment that the time step is too long for would be thrown out of the scene, and then its neighbours.
void BreakageEngine::checkFragments(const BreakableMat& material, const superquadric::Shape& shape, const fragments::Pieces& pieces) const
{
	Real smallest = shape.smallestHalfSize();
	for (const fragments::Piece& piece : pieces)
		smallest = std::min(smallest, shape.halfSizes().cwiseProduct(piece.scale).minCoeff());
	std::ostringstream demand;
	if (!(smallest >= superquadric::tolerances::smallestHalfSize)) {
		demand << "larger: there would be a fragment with the half size " << smallest << " m, of at least " << superquadric::tolerances::smallestHalfSize
		       << " m (mode = '" << mode << "', cutExponent = " << cutExponent << ")";
		refuse("smallestFragment", demand.str().c_str(), smallestFragment);
	}
	smallest = std::max(smallest, inertialSize / 2);
	const Real critical = material.criticalTimeStep(smallest);
	if (scene->dt <= critical || scene->timeStepperActive()) return;
	demand << "at most the critical time step " << critical << " s of a fragment with the half size " << smallest
	       << " m (set smallestFragment or inertialSize, or a shorter step)";
	refuse("O.dt", demand.str().c_str(), scene->dt);
}

} // namespace yade
