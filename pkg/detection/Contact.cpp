#include "Contact.hpp"

#include <utility>

namespace superquadric {

Contact Contact::reversed() const
{
	Contact result = *this;
	result.normal = -normal;
	std::swap(result.surface1, result.surface2);
	std::swap(result.curvature1, result.curvature2);
	return result;
}

SolverCounters& SolverCounters::operator+=(const SolverCounters& other)
{
	solves += other.solves;
	stillApart += other.stillApart;
	rejectedBySphere += other.rejectedBySphere;
	rejectedByDirection += other.rejectedByDirection;
	rejectedByBox += other.rejectedByBox;
	coldStarts += other.coldStarts;
	iterations += other.iterations;
	fallbacks += other.fallbacks;
	uncertified += other.uncertified;
	return *this;
}

} // namespace superquadric
