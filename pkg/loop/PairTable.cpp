#include "PairTable.hpp"

#include <pkg/superquadric/SuperquadricGeom.hpp>

#include <algorithm>

namespace yade {

namespace {

	std::pair<Body::id_t, Body::id_t> orderOf(const PairTable::Row& row) { return std::minmax(row.id1, row.id2); }

	superquadric::WarmStart memoryOf(const Interaction& interaction)
	{
		const auto* geom = dynamic_cast<const SuperquadricGeom*>(interaction.geom.get());
		return geom ? geom->warm : superquadric::WarmStart();
	}

} // namespace

void PairTable::update(InteractionContainer& interactions, const BodyTable& bodies, bool bodiesAreNew)
{
	if (bodiesAreNew || !isUpToDate(interactions)) rebuild(interactions, bodies, bodiesAreNew);
}

void PairTable::writeMemories() const
{
	for (const Row& row : rows)
		if (row.ownsMemory)
			if (auto* geom = dynamic_cast<SuperquadricGeom*>(row.interaction->geom.get())) geom->warm = row.warm;
}

bool PairTable::isUpToDate(InteractionContainer& interactions) const
{
	return interactions.size() == known.size() && std::equal(known.begin(), known.end(), interactions.begin());
}

void PairTable::rebuild(InteractionContainer& interactions, const BodyTable& bodies, bool bodiesAreNew)
{
	std::vector<shared_ptr<Interaction>> held(interactions.begin(), interactions.begin() + interactions.size());
	std::vector<Row> fresh;
	fresh.reserve(held.size());
	for (auto& interaction : held) {
		const Body::id_t id1 = interaction->getId1(), id2 = interaction->getId2();
		const bool superquadrics = bodies.isSuperquadric(id1) && bodies.isSuperquadric(id2), spheres = bodies.isSphere(id1) && bodies.isSphere(id2);
		fresh.push_back({ id1, id2, superquadrics, spheres, interaction->isReal(), /*ownsMemory*/ false,
		        interaction->functorCache.constLaw.get(), /*apartUntil*/ -1,
		        memoryOf(*interaction), interaction.get(), &interaction, interaction->geom.get(), interaction->phys.get() });
	}
	const auto earlier = [](const Row& a, const Row& b) { return orderOf(a) < orderOf(b); };
	std::sort(fresh.begin(), fresh.end(), earlier);
	// What is remembered of a pair that does not touch is kept here only. Both lists are in order.
	auto old = rows.begin();
	for (Row& row : fresh) {
		while (old != rows.end() && earlier(*old, row))
			++old;
		if (old == rows.end() || earlier(row, *old) || old->interaction != row.interaction) continue;
		if (!bodiesAreNew) row.apartUntil = old->apartUntil;
		if (old->ownsMemory) {
			row.warm = old->warm;
			row.ownsMemory = true;
		}
	}
	rows.swap(fresh);
	known.swap(held);
}

} // namespace yade
