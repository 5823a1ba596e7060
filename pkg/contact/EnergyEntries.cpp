#include "EnergyEntries.hpp"

namespace yade {

EnergyEntries::EnergyEntries(std::vector<const char*> names)
        : names(std::move(names))
        , ids(this->names.size(), -1)
{
}

void EnergyEntries::find(Scene& scene)
{
	if (foundAt.load(std::memory_order_acquire) == scene.iter) return;
	const std::lock_guard<std::mutex> lock(finding);
	if (foundAt.load(std::memory_order_relaxed) == scene.iter) return;
	for (size_t entry = 0; entry < names.size(); ++entry) {
		ids[entry] = -1;
		scene.energy->findId(names[entry], ids[entry], /*reset each step*/ entry == 0);
	}
	foundAt.store(scene.iter, std::memory_order_release);
}

} // namespace yade
