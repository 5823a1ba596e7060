// Random numbers that depend on what they are for alone: a seed, who asks, and the purpose. Nothing has to be remembered between two particles, and
// the numbers are the same on all platforms: no distribution of the standard library, whose algorithms are not laid down.
#pragma once

#include <pkg/geometry/Types.hpp>

#include <cmath>
#include <cstdint>

namespace superquadric {

// SplitMix64 (Steele, Lea & Flood, OOPSLA 2014), started at a mixture of the three.
class CounterRandom {
public:
	CounterRandom(std::uint64_t seed, std::uint64_t serial, std::uint64_t purpose)
	        : state_(mixed(mixed(mixed(seed + increment) + serial + increment) + purpose + increment))
	{
	}

	// Uniform on (0, 1): neither end is ever reached.
	double uniform() { return std::ldexp(double(next() >> 12) + 0.5, -52); }

	// Uniform over all rotations: a unit quaternion from two points of the unit disc (Marsaglia, Ann. Math. Stat. 43, 645 (1972)), which takes
	// square roots only.
	Matrix3 rotation()
	{
		const Eigen::Vector2d p = inDisc(), q = inDisc();
		const double stretch = std::sqrt((1 - p.squaredNorm()) / q.squaredNorm());
		return Eigen::Quaterniond(p.x(), p.y(), q.x() * stretch, q.y() * stretch).normalized().toRotationMatrix();
	}

private:
	static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15; // 2^64 over the golden ratio

	static std::uint64_t mixed(std::uint64_t z)
	{
		z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
		z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
		return z ^ (z >> 31);
	}
	std::uint64_t next() { return mixed(state_ += increment); }
	Eigen::Vector2d inDisc()
	{
		Eigen::Vector2d point;
		do {
			point.x() = 2 * uniform() - 1;
			point.y() = 2 * uniform() - 1;
		} while (!(point.squaredNorm() < 1)); // never the centre: no uniform number is 1/2
		return point;
	}

	std::uint64_t state_;
};

} // namespace superquadric
