// Random pairs for the oracle: shapes different on both sides, within 5 % of touching, a third aligned on purpose; or of given exponents.
// Each pair depends on the seed and its number only, so that any part of a long run can be repeated alone.
#pragma once

#include <tests/support/RandomBodies.hpp>

#include <array>

namespace superquadric::testing {

inline Matrix3 turn(double angle, const Vector3& axis) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

class RandomPair {
public:
	// The larger body is of unit order.
	RandomPair(std::uint64_t seed, std::uint64_t number)
	        : random(mixed(seed, number))
	{
		sizes1 = random.halfSizes();
		sizes2 = random.halfSizes(random.logarithmic(0.01, 1));
		const bool blocks = random.index(3) == 0;
		for (double* n : { &n11, &n12, &n21, &n22 })
			*n = blocks ? random.uniform(8, 20) : random.exponent();
		rotation1 = random.rotation();
		rotation2 = random.rotation();
		along = random.direction();
		if (random.index(3) == 0) align(random.index(4));
		if (random.index(2)) swapBodies();
		const double distance = random.index(4) ? random.uniform(0, 0.05) : random.logarithmic(1e-13, 0.05);
		scaling = random.index(2) ? 1 + distance : 1 - distance;
		place = random.uniform(0, 3) * random.direction();
	}

	// Of given exponents, aspects to 3 and size ratios to 5, at random or with faces, edges or corners on each other, half of these all but
	// exactly. Where they are is left open.
	RandomPair(std::uint64_t seed, std::uint64_t number, const std::array<double, 2>& exponents1, const std::array<double, 2>& exponents2, bool aligned)
	        : random(mixed(seed, number))
	        , n11(exponents1[0])
	        , n12(exponents1[1])
	        , n21(exponents2[0])
	        , n22(exponents2[1])
	{
		for (Vector3* sizes : { &sizes1, &sizes2 })
			for (double& size : *sizes)
				size = random.logarithmic(0.58, 1.73);
		sizes2 *= random.logarithmic(0.2, 1);
		rotation1 = random.rotation();
		rotation2 = random.rotation();
		along = random.direction();
		place = random.direction();
		if (!aligned) return;
		align(random.index(3));
		if (random.index(2)) rotation2 = turn(random.logarithmic(1e-9, 1e-2), random.direction()) * rotation2;
	}

	RandomBodies random;
	Vector3 sizes1, sizes2;
	double n11, n12, n21, n22; // n1 and n2 of body 1, then of body 2
	Matrix3 rotation1, rotation2;
	Vector3 along; // direction of the centres, not yet their distance
	double scaling = 1; // t* that the pair is to have: within 5 % of touching, every fourth one by orders of magnitude closer
	Vector3 place; // of body 1
	const char* kind = "random";

private:
	// Neighbouring seeds must not give like streams (the finaliser of splitmix64, Steele, Lea & Flood 2014).
	static std::uint64_t mixed(std::uint64_t seed, std::uint64_t number)
	{
		std::uint64_t z = seed * 0xd1342543de82ef95u + number * 0x9e3779b97f4a7c15u;
		z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
		z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
		return z ^ (z >> 31);
	}

	void swapBodies()
	{
		std::swap(sizes1, sizes2);
		std::swap(n11, n21);
		std::swap(n12, n22);
		std::swap(rotation1, rotation2);
	}

	void align(int way)
	{
		const Matrix3 frame = random.index(2) ? Matrix3(Matrix3::Identity()) : random.rotation();
		const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
		rotation1 = frame;
		along = frame.col(random.index(3));
		switch (way) {
			case 0: // a face on a face, turned in quarters, half of them aside
				kind = "face on face";
				rotation2 = frame * turn(random.index(4) * pi / 2, random.index(2) ? x : z);
				if (random.index(2)) along += 0.5 * random.direction();
				break;
			case 1: // an edge on an edge, crossed or parallel
				kind = "edge on edge";
				rotation1 = frame * turn(std::atan2(sizes1.y(), sizes1.z()), x);
				rotation2 = random.index(2) ? Matrix3(frame * turn(std::atan2(sizes2.y(), sizes2.z()), x))
				                            : Matrix3(frame * turn(-std::atan2(sizes2.x(), sizes2.z()), y));
				along = frame.col(2);
				break;
			case 2: // a corner on a face
				kind = "corner on face";
				rotation2 = frame * Eigen::Quaterniond::FromTwoVectors(sizes2, -z).toRotationMatrix();
				along = frame.col(2);
				break;
			default: // a body and its copy, along an axis or from corner to corner
				kind = "symmetric";
				sizes2 = sizes1;
				n21 = n11;
				n22 = n12;
				rotation2 = frame;
				if (random.index(2)) along = frame * sizes1.normalized();
		}
	}
};

} // namespace superquadric::testing
