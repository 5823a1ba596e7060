// Random shapes and places for the tests; the same seed gives the same bodies with any standard library.
#pragma once

#include <pkg/geometry/Placement.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace superquadric::testing {

class RandomBodies {
public:
	explicit RandomBodies(std::uint64_t seed)
	        : engine_(seed)
	{
	}

	double uniform(double low = 0, double high = 1) { return low + (high - low) * std::ldexp(double(engine_() >> 11), -53); }
	double logarithmic(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
	int index(int count) { return int(uniform(0, count)); }

	// In [2, 20]; every fourth one of the whole numbers, which the code treats apart, and often an end of the range.
	double exponent()
	{
		switch (index(8)) {
			case 0: return 2 + index(19);
			case 1: return index(2) ? 2 : 20;
			default: return logarithmic(2, 20);
		}
	}

	// Half sizes with ratios up to 10, the middle one of order `size`.
	Vector3 halfSizes(double size = 1) { return size * Vector3(logarithmic(0.316, 3.16), logarithmic(0.316, 3.16), logarithmic(0.316, 3.16)); }

	Shape shape(double size = 1)
	{
		const Vector3 sizes = halfSizes(size);
		const double n1 = exponent(), n2 = exponent();
		return Shape(sizes, n1, n2);
	}

	// Uniform on the unit sphere (Archimedes: the height is uniform).
	Vector3 direction()
	{
		const double height = uniform(-1, 1), angle = uniform(0, 2 * pi), radius = std::sqrt(1 - height * height);
		return { radius * std::cos(angle), radius * std::sin(angle), height };
	}

	// Uniform (Shoemake 1992).
	Matrix3 rotation()
	{
		const double u = uniform(), p = uniform(0, 2 * pi), q = uniform(0, 2 * pi);
		const Eigen::Quaterniond turn(
		        std::sqrt(u) * std::cos(q), std::sqrt(1 - u) * std::sin(p), std::sqrt(1 - u) * std::cos(p), std::sqrt(u) * std::sin(q));
		return turn.normalized().toRotationMatrix();
	}

private:
	std::mt19937_64 engine_;
};

} // namespace superquadric::testing
