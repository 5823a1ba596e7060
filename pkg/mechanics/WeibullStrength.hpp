// Strength of particles: Weibull's distribution with the effect of size.
#pragma once

#include <cmath>

namespace superquadric {

// P(survival) = exp(-(d/d0)^3 (s/s0)^m), Weibull, J. Appl. Mech. 18, 293 (1951): the more volume, the more flaws.
struct WeibullStrength {
	double characteristic; // s0 [Pa]
	double referenceSize; // d0 [m]
	double modulus; // m

	double survival(double size, double stress) const
	{
		const double ratio = size / referenceSize;
		return std::exp(-ratio * ratio * ratio * std::pow(stress / characteristic, modulus));
	}
	// The stress [Pa] that the part `survival` of all particles of a size [m] exceed; 0 < survival < 1.
	double quantile(double size, double survival) const
	{
		return characteristic * std::pow(size / referenceSize, -3 / modulus) * std::pow(-std::log(survival), 1 / modulus);
	}
};

} // namespace superquadric
