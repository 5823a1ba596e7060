// The scene's interactions in the order of their bodies' ids, with the solver's memory of each pair, side by side in memory.
#pragma once

#include "BodyTable.hpp"

#include <core/InteractionContainer.hpp>
#include <pkg/geometry/Contact.hpp>

#include <vector>

namespace yade {

class PairTable {
public:
	struct Row {
		Body::id_t id1, id2; // as the interaction names them
		bool superquadrics; // both: the row is solved from here, any other by YADE's dispatch
		bool real; // the interaction has geom and phys
		superquadric::WarmStart warm;
		shared_ptr<Interaction>* interaction; // in `known`
		// Where the interaction and its parts were at the last step, for the processor to fetch ahead; never looked into.
		const void *interactionAt, *geomAt, *physAt;

		// After the step's work.
		void note()
		{
			real = (*interaction)->isReal();
			geomAt = (*interaction)->geom.get();
			physAt = (*interaction)->phys.get();
		}
	};

	// Follows the container: anything may have added or erased interactions since the last step. The order does not depend on their
	// history, and so neither do the sums of forces.
	void update(InteractionContainer& interactions, const BodyTable& bodies, bool force);

	long size() const { return long(rows.size()); }
	Row& operator[](long i) { return rows[i]; }

private:
	bool isUpToDate(InteractionContainer& interactions) const;
	void rebuild(InteractionContainer& interactions, const BodyTable& bodies);

	std::vector<Row> rows;
	// Held, so that no new interaction can take the address of an old one unnoticed.
	std::vector<shared_ptr<Interaction>> known;
};

} // namespace yade
