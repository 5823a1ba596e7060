// The scene's interactions in the order of their bodies' ids, with the solver's memory of each pair, side by side in memory.
#pragma once

#include "BodyTable.hpp"

#include <core/Dispatching.hpp>
#include <core/InteractionContainer.hpp>
#include <pkg/detection/Contact.hpp>

#include <vector>

namespace yade {

class PairTable {
public:
	struct Row {
		Body::id_t id1, id2; // as the interaction names them
		bool superquadrics; // both: the row is solved from here, any other by YADE's dispatch
		bool spheres; // both: dispatched only where they may touch
		bool real; // the interaction has geom and phys
		bool ownsMemory; // `warm` is newer than what the interaction's geometry remembers
		const LawFunctor* law; // the interaction's, once it is real
		Real apartUntil; // the sum of both bodies' travels up to which they are proved apart [m]
		superquadric::WarmStart warm;
		Interaction* interaction;
		const shared_ptr<Interaction>* handle; // the same, in `known`
		// Where the parts of the interaction were at the last step, for the processor to fetch ahead; never looked into.
		const void *geomAt, *physAt;

		// After a contact has begun or ended.
		void refresh()
		{
			const Interaction& now = *interaction;
			real = now.isReal();
			law = now.functorCache.constLaw.get();
			geomAt = now.geom.get();
			physAt = now.phys.get();
		}
	};

	// Follows the container: anything may have added or erased interactions since the last step. The order does not depend on their
	// history, and so neither do the sums of forces.
	void update(InteractionContainer& interactions, const BodyTable& bodies, bool bodiesAreNew);

	// The geometries of contacts get what the solver remembers of them, for saving.
	void writeMemories() const;

	long size() const { return long(rows.size()); }
	Row& operator[](long i) { return rows[i]; }

private:
	bool isUpToDate(InteractionContainer& interactions) const;
	void rebuild(InteractionContainer& interactions, const BodyTable& bodies, bool bodiesAreNew);

	std::vector<Row> rows;
	// Held, so that no new interaction can take the address of an old one unnoticed.
	std::vector<shared_ptr<Interaction>> known;
};

} // namespace yade
