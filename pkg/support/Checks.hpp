// Checks of what comes from Python. Boost.Python turns std::invalid_argument into ValueError.
#pragma once

#include <lib/base/Math.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>

namespace yade {

template <class Value> [[noreturn]] void refuse(const char* name, const char* demand, const Value& value)
{
	std::ostringstream message;
	message << name << " must be " << demand << ", got " << value;
	throw std::invalid_argument(message.str());
}

// A text from Python may have been bytes, which Python could not read in a message: what is not ASCII is written out.
[[noreturn]] inline void refuse(const char* name, const char* demand, const std::string& value)
{
	std::ostringstream message;
	message << name << " must be " << demand << ", got " << std::hex << std::setfill('0');
	for (const unsigned char letter : value)
		if (letter < 0x80) message << letter;
		else message << "\\x" << std::setw(2) << int(letter);
	throw std::invalid_argument(message.str());
}

inline void requirePositive(const char* name, Real value)
{
	if (!(std::isfinite(value) && value > 0)) refuse(name, "finite and positive", value);
}

inline void requireNotNegative(const char* name, Real value)
{
	if (!(std::isfinite(value) && value >= 0)) refuse(name, "finite and not negative", value);
}

inline void requireFinite(const char* name, const Vector3r& value)
{
	if (!value.allFinite()) refuse(name, "finite", value.transpose());
}

inline void requireNonZero(const char* name, const Vector3r& value)
{
	requireFinite(name, value);
	if (value.isZero(0)) refuse(name, "different from zero", value.transpose());
}

} // namespace yade
