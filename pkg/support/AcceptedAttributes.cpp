#include "AcceptedAttributes.hpp"

namespace yade {

void AcceptedAttributes::remember(const References& attributes)
{
	values.clear();
	for (const auto& attribute : attributes)
		std::visit([this](const auto* value) { values.emplace_back(*value); }, attribute);
}

void AcceptedAttributes::putBack(const References& attributes) const
{
	for (std::size_t i = 0; i < values.size(); ++i)
		std::visit([&](auto* value) { *value = std::get<std::decay_t<decltype(*value)>>(values[i]); }, attributes[i]);
}

} // namespace yade
