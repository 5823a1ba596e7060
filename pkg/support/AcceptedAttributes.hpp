// "Accept the new values or put the old ones back": what a class does with its attributes when Python has set one of them.
#pragma once

#include <lib/base/Math.hpp>

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace yade {

class AcceptedAttributes {
public:
	// Attributes of one object, always in the same order; a derived class appends its own.
	using References = std::vector<std::variant<Real*, int*, std::string*, Vector3r*>>;

	// Runs `check`, which throws std::invalid_argument for what cannot be: then the attributes are put back to what was accepted last, as far as
	// anything was, and the error leaves. Else they are what is accepted now.
	template <class Check> void accept(const References& attributes, const Check& check)
	{
		try {
			check();
		} catch (const std::invalid_argument&) {
			putBack(attributes);
			throw;
		}
		remember(attributes);
	}
	// Without a check: of defaults, and of what the class has changed itself.
	void remember(const References& attributes);

private:
	void putBack(const References& attributes) const;

	std::vector<std::variant<Real, int, std::string, Vector3r>> values;
};

} // namespace yade
