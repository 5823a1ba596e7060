// What the tests of the elastoplastic normal law share: pairs from soft to steep, and an independent integral.
#pragma once

#include <pkg/mechanics/ElastoplasticContact.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace superquadric::elastoplastic {

using superquadric::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double modulus = 39e9, radius = 2.5e-3, mass = 1e-3; // of two aluminium spheres, about

inline Pair pairOf(double yieldStress, double factor, double exponent)
{
	Hardening hardening;
	hardening.m0 = factor;
	hardening.exponent = exponent;
	return { { yieldStress, hardening }, modulus, radius };
}

inline const Pair aluminium = pairOf(100e6, 2.6, 1.8);
inline const Pair elastic { {}, modulus, radius };

// From well below Hertz to above it at yield (H < 1; H = 1 with G > 3) and beyond (large G).
inline const std::array<Pair, 9> pairs { aluminium, pairOf(1e6, 0.1, 0.6), pairOf(300e6, 5, 0.6), pairOf(100e6, 2, 1), pairOf(100e6, 12, 1),
	pairOf(50e6, 5, 2), pairOf(50e6, 30, 2), pairOf(50e6, 0.5, 2.9), pairOf(200e6, 8, 2.5) };

inline YieldPoint yieldOf(const Pair& pair) { return yieldPoint(pair.material.yieldStress, pair.modulus, pair.radius); }

inline double hertzForce(const Pair& pair, double overlap) { return 4. / 3 * pair.modulus * std::sqrt(pair.radius * overlap) * overlap; }

template <class Function>
double gauss5(const Function& f, double from, double to)
{
	constexpr std::array<double, 3> x { 0, 0.5384693101056831, 0.9061798459386640 };
	constexpr std::array<double, 3> weight { 0.5688888888888889, 0.4786286704993665, 0.2369268850561891 };
	const double middle = (from + to) / 2, half = (to - from) / 2;
	double sum = weight[0] * f(middle);
	for (int i : { 1, 2 })
		sum += weight[i] * (f(middle - half * x[i]) + f(middle + half * x[i]));
	return half * sum;
}

// Halves the interval, around kinks again and again, until both halves agree with the whole to `error`.
template <class Function>
double halved(const Function& f, double from, double to, double error, int depth)
{
	const double middle = (from + to) / 2, whole = gauss5(f, from, to);
	const double halves = gauss5(f, from, middle) + gauss5(f, middle, to);
	if (std::abs(halves - whole) <= error || depth == 0) return halves;
	return halved(f, from, middle, error, depth - 1) + halved(f, middle, to, error, depth - 1);
}

// In parts to begin with, so that no kink is overlooked.
template <class Function>
double integral(const Function& f, double from, double to, double error, int parts)
{
	double sum = 0;
	for (int i = 0; i < parts; ++i)
		sum += halved(f, from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts, error / parts, 40);
	return sum;
}

inline State followed(const Pair& pair, const std::vector<double>& overlaps)
{
	State state;
	for (double overlap : overlaps)
		state = normalForce(pair, state.history, overlap);
	return state;
}

} // namespace superquadric::elastoplastic
