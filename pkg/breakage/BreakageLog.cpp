// The log of BreakageEngine: what is saved of each event, and how Python gets it back.
#include "BreakageEngine.hpp"

#include <cmath>

namespace yade {

namespace fragments = superquadric::fragments;

void BreakageEngine::log(const Event& event, const fragments::Pieces& pieces, Real elasticLoss, Real spinLoss)
{
	const BreakableParticle& parent = event.parent;
	eventTimes.push_back(scene->time);
	eventSteps.push_back(int(scene->iter));
	eventParents.push_back(parent.body->getId());
	eventGenerations.push_back(parent.state->generation);
	eventSizes.push_back(parent.size);
	eventValues.push_back(event.value);
	eventStrengths.push_back(parent.state->strength);
	eventElasticLosses.push_back(elasticLoss);
	eventSpinLosses.push_back(spinLoss);
	childNumbers.push_back(int(pieces.size()));
	for (const fragments::Piece& piece : pieces)
		childSizes.push_back(parent.size * std::cbrt(piece.share));
}

boost::python::list BreakageEngine::events() const
{
	boost::python::list all;
	std::size_t child = 0;
	for (std::size_t i = 0; i < eventTimes.size(); ++i) {
		boost::python::dict event;
		event["time"] = eventTimes[i];
		event["step"] = eventSteps[i];
		event["parent"] = eventParents[i];
		event["generation"] = eventGenerations[i];
		event["size"] = eventSizes[i];
		event["value"] = eventValues[i];
		event["strength"] = eventStrengths[i];
		event["elasticLoss"] = eventElasticLosses[i];
		event["spinLoss"] = eventSpinLosses[i];
		boost::python::list ids, sizes;
		for (int left = childNumbers[i]; left > 0; --left, ++child) {
			ids.append(childIds[child]);
			sizes.append(childSizes[child]);
		}
		event["children"] = ids;
		event["childSizes"] = sizes;
		all.append(event);
	}
	return all;
}

} // namespace yade
