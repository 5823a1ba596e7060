#include "SuperquadricInteractionLoop.hpp"

#include <pkg/contact/CurvaturePhys.hpp>
#include <pkg/dem/Ig2_Sphere_Sphere_ScGeom.hpp>
#include <pkg/geometry/Tolerances.hpp>

#ifdef YADE_OPENMP
#include <omp.h>
#endif

namespace yade {

YADE_PLUGIN((SuperquadricInteractionLoop));

namespace {
	// Pairs between asking the memory for an interaction and using it: about as long as the memory takes.
	constexpr long fetchAhead = 16;
	// The solver's memory, at the end of the geometry, is written when the scene is saved only.
	constexpr size_t writtenPart = sizeof(SuperquadricGeom) - sizeof(superquadric::WarmStart);

	void fetchLines(const void* address, size_t bytes)
	{
		for (size_t offset = 0; offset < bytes; offset += 64)
			__builtin_prefetch(static_cast<const char*>(address) + offset);
	}
}

void SuperquadricInteractionLoop::action()
{
	prepare();
#ifdef YADE_OPENMP
	const int threads = ompThreads > 0 ? std::min(ompThreads, omp_get_max_threads()) : omp_get_max_threads();
#else
	const int threads = 1;
#endif
	const bool changed = bodies.update(*scene, threads);
	pairs.update(*scene->interactions, bodies, changed);
	// A periodic image is not where its body is: such pairs are left to YADE's dispatch.
	const bool direct = geometry && !scene->isPeriodic, directSpheres = sphereReach > 0 && !scene->isPeriodic;
	const long size = pairs.size();
	unsigned long stillApart = 0;
#ifdef YADE_OPENMP
#pragma omp parallel for schedule(guided) num_threads(threads) reduction(+ : stillApart)
#endif
	for (long i = 0; i < size; ++i) {
		if (i + fetchAhead < size) fetch(pairs[i + fetchAhead]);
		PairTable::Row& row = pairs[i];
		if (direct && isStillApart(row))
			++stillApart;
		else if (direct && row.superquadrics)
			solve(row);
		else if (!(directSpheres && spheresAreApart(row)))
			dispatch(row);
	}
	if (geometry) geometry->countStillApart(stillApart);
	eraseUnseen();
}

void SuperquadricInteractionLoop::preSave(SuperquadricInteractionLoop&) { pairs.writeMemories(); }

void SuperquadricInteractionLoop::prepare()
{
	geomDispatcher->scene = physDispatcher->scene = lawDispatcher->scene = scene;
	geomDispatcher->updateScenePtr();
	physDispatcher->updateScenePtr();
	lawDispatcher->updateScenePtr();
	geometry.reset();
	sphereReach = 0;
	for (const auto& functor : geomDispatcher->functors) {
		if (!geometry) geometry = YADE_PTR_DYN_CAST<Ig2_Superquadric_Superquadric_SuperquadricGeom>(functor);
		if (const auto* spheres = dynamic_cast<const Ig2_Sphere_Sphere_ScGeom*>(functor.get())) sphereReach = std::max(sphereReach, spheres->interactionDetectionFactor);
	}
	fastLaw = nullptr;
	pairLaw = nullptr;
	for (const auto& functor : lawDispatcher->functors)
		if (auto* law = dynamic_cast<PairLaw*>(functor.get())) {
			fastLaw = functor.get();
			pairLaw = law;
		}
	activeCallbacks.clear();
	for (const auto& callback : callbacks) {
		callback->scene = scene;
		if (const auto function = callback->stepInit()) activeCallbacks.emplace_back(callback.get(), function);
	}
}

// Two superquadrics. As long as they do not touch, their interaction is not even looked at; and as long as they have not moved by the
// width of the gap that was proved between them, nor are they themselves.
bool SuperquadricInteractionLoop::isStillApart(const PairTable::Row& row) const
{
	return row.superquadrics && !row.real && bodies.travel(row.id1) + bodies.travel(row.id2) < row.apartUntil;
}

void SuperquadricInteractionLoop::solve(PairTable::Row& row)
{
	const superquadric::Placement &body1 = *bodies[row.id1].placement, &body2 = *bodies[row.id2].placement;
	const auto contact = geometry->solveAt(body1, body2, row.warm);
	row.ownsMemory = true;
	if (!touches(contact)) {
		const Real gap = contact.status == superquadric::Status::Apart ? -contact.overlap : 0;
		row.apartUntil = apartUntil(row, gap, body1.shape.boundingRadius() + body2.shape.boundingRadius());
		if (!row.real) return;
	}
	if (pairLaw && row.law == fastLaw && row.interaction->isReal() && touches(contact))
		keepTouching(row, contact);
	else {
		beginOrEnd(row, contact);
		row.refresh();
	}
	callBack(*row.interaction);
}

// Sum of travels up to which two bodies with a `gap` between them stay apart; `size` is the sum of their radii [m].
Real SuperquadricInteractionLoop::apartUntil(const PairTable::Row& row, Real gap, Real size) const
{
	const Real least = superquadric::tolerances::gapReserve * size;
	return gap > least ? bodies.travel(row.id1) + bodies.travel(row.id2) + (1 - superquadric::tolerances::gapReserve) * gap - least : -1;
}

// Two of YADE's spheres without a contact: as long as they have not moved by the gap between them, their interaction is not looked at.
bool SuperquadricInteractionLoop::spheresAreApart(PairTable::Row& row) const
{
	if (!row.spheres || row.real) return false;
	if (bodies.travel(row.id1) + bodies.travel(row.id2) < row.apartUntil) return true;
	const BodyTable::Row &one = bodies[row.id1], &two = bodies[row.id2];
	const Real reach = sphereReach * (one.radius + two.radius);
	row.apartUntil = apartUntil(row, (two.centre - one.centre).norm() - reach, reach);
	return row.apartUntil >= 0;
}

// Two superquadrics that touched before and still do, under a law that needs no more than their motion.
void SuperquadricInteractionLoop::keepTouching(const PairTable::Row& row, const superquadric::Contact& contact)
{
	const BodyTable::Row &row1 = bodies[row.id1], &row2 = bodies[row.id2];
	auto& geom = static_cast<SuperquadricGeom&>(*row.interaction->geom);
	geom.touch(contact, sideOf(*row1.placement, contact.surface1, contact.normal, contact.curvature1),
	        sideOf(*row2.placement, contact.surface2, contact.normal, contact.curvature2), geom.normal, *row1.motion, *row2.motion, scene->dt);
	pairLaw->act(geom, *row.interaction->phys, *row1.motion, *row2.motion);
}

// A contact that begins or ends.
void SuperquadricInteractionLoop::beginOrEnd(const PairTable::Row& row, const superquadric::Contact& contact) const
{
	const shared_ptr<Interaction>& interaction = *row.handle;
	Body &body1 = *Body::byId(row.id1, scene), &body2 = *Body::byId(row.id2, scene);
	const Vector3r noShift = Vector3r::Zero();
	const ContactPair pair { *body1.state, *body2.state, noShift, /*force*/ false, interaction, scene };
	const bool wasReal = interaction->isReal();
	using Geometry = Ig2_Superquadric_Superquadric_SuperquadricGeom;
	if (!Geometry::describe(contact, *bodies[row.id1].placement, *bodies[row.id2].placement, pair, row.warm)) return;
	interaction->functorCache.geom = geometry;
	makePhysics(interaction, body1, body2);
	if (!wasReal) interaction->iterMadeReal = scene->iter;
	findLaw(*interaction);
	applyLaw(interaction);
}

// The rows themselves are in order in memory; what they point to is not. Another thread may be at work on the row that is looked at:
// whatever is read of it only tells the processor what to fetch.
void SuperquadricInteractionLoop::fetch(const PairTable::Row& row) const
{
	if (!row.superquadrics || isStillApart(row)) return;
	fetchLines(&bodies[row.id2], row.real ? sizeof(BodyTable::Row) : sizeof(superquadric::Placement));
	if (!row.real) return;
	fetchLines(&row.interaction->geom, 1);
	fetchLines(row.geomAt, writtenPart);
	fetchLines(row.physAt, sizeof(CurvaturePhys));
}

// Any other pair, as YADE's loop takes it.
void SuperquadricInteractionLoop::dispatch(PairTable::Row& row)
{
	const shared_ptr<Interaction>& interaction = *row.handle;
	row.ownsMemory = false;
	const shared_ptr<Body>&first = Body::byId(row.id1, scene), &second = Body::byId(row.id2, scene);
	if (!first || !second || isForeign(*first, *second)) return scene->interactions->requestErase(interaction);
	if (first->isClump() || second->isClump() || !first->shape || !second->shape || !findGeometry(row, *first, *second)) return;

	Body &body1 = *Body::byId(row.id1, scene), &body2 = *Body::byId(row.id2, scene); // perhaps swapped
	const Vector3r shift2 = scene->isPeriodic ? Vector3r(scene->cell->hSize * interaction->cellDist.cast<Real>()) : Vector3r(Vector3r::Zero());
	const bool wasReal = interaction->isReal();
	if (interaction->functorCache.geom->go(body1.shape, body2.shape, *body1.state, *body2.state, shift2, /*force*/ false, interaction)) {
		makePhysics(interaction, body1, body2);
		if (!wasReal) interaction->iterMadeReal = scene->iter;
		findLaw(*interaction);
		applyLaw(interaction);
		callBack(*interaction);
	} else if (wasReal)
		scene->interactions->requestErase(interaction);
	row.refresh();
}

bool SuperquadricInteractionLoop::isForeign(const Body& body1, const Body& body2) const
{
#ifdef YADE_MPI
	return body1.subdomain != scene->subdomain && body2.subdomain != scene->subdomain;
#else
	return false;
#endif
}

// A functor that knows the shapes in the other order gets the bodies in that order, now and in all later steps.
bool SuperquadricInteractionLoop::findGeometry(PairTable::Row& row, Body& body1, Body& body2) const
{
	Interaction& interaction = *row.interaction;
	auto& cache = interaction.functorCache;
	if (!cache.geomExists || cache.geom) return cache.geomExists;
	bool swap = false;
	cache.geom = geomDispatcher->getFunctor2D(body1.shape, body2.shape, swap);
	cache.geomExists = bool(cache.geom);
	if (swap) {
		interaction.swapOrder();
		std::swap(row.id1, row.id2);
	}
	return cache.geomExists;
}

void SuperquadricInteractionLoop::makePhysics(const shared_ptr<Interaction>& interaction, Body& body1, Body& body2) const
{
	auto& cache = interaction->functorCache;
	bool swap = false;
	if (!cache.phys) cache.phys = physDispatcher->getFunctor2D(body1.material, body2.material, swap);
	if (!cache.phys)
		throw std::runtime_error("SuperquadricInteractionLoop: no Ip2 functor for the materials " + body1.material->getClassName() + " and " + body2.material->getClassName());
	cache.phys->go(body1.material, body2.material, interaction);
}

void SuperquadricInteractionLoop::findLaw(Interaction& interaction) const
{
	bool swap = false;
	auto& law = interaction.functorCache.constLaw;
	if (!law) law = lawDispatcher->getFunctor2D(interaction.geom, interaction.phys, swap);
	if (!law)
		throw std::runtime_error("SuperquadricInteractionLoop: no Law2 functor for " + interaction.geom->getClassName() + " and " + interaction.phys->getClassName());
}

void SuperquadricInteractionLoop::applyLaw(const shared_ptr<Interaction>& interaction) const
{
	if (!interaction->functorCache.constLaw->go(interaction->geom, interaction->phys, interaction.get())) scene->interactions->requestErase(interaction);
}

void SuperquadricInteractionLoop::callBack(Interaction& interaction) const
{
	if (!interaction.isReal()) return;
	for (const auto& [callback, function] : activeCallbacks)
		(*function)(callback, &interaction);
}

void SuperquadricInteractionLoop::eraseUnseen()
{
	InteractionContainer& interactions = *scene->interactions;
	if (interactions.iterColliderLastRun < 0 || interactions.iterColliderLastRun != scene->iter) return;
	for (long i = 0; i < pairs.size(); ++i) {
		const Interaction& interaction = *pairs[i].interaction;
		if (!interaction.isReal() && interaction.iterLastSeen < scene->iter) interactions.erase(interaction.getId1(), interaction.getId2(), interaction.linIx);
	}
}

} // namespace yade
