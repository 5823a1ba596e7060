// Entries of O.energy that a contact law adds to, from several threads.
#pragma once

#include <core/EnergyTracker.hpp>
#include <core/Scene.hpp>

#include <atomic>
#include <mutex>
#include <vector>

namespace yade {

class EnergyEntries {
public:
	// The first one is of this step only, the others are sums.
	explicit EnergyEntries(std::vector<const char*> names);

	// Finds or makes the entries once a step, all at once and before any thread adds to one: EnergyTracker moves its storage when it
	// grows, and O.energy.clear() may have emptied it.
	void find(Scene& scene);
	void add(Scene& scene, int entry, Real value) const { scene.energy->energies.add(ids[entry], value); }

private:
	std::vector<const char*> names;
	std::vector<int> ids;
	std::atomic<long> foundAt { -1 };
	std::mutex finding;
};

} // namespace yade
