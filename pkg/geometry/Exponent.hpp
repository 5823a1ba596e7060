// Powers |x|^n for a fixed exponent: whole ones take multiplications, anything else std::pow.
#pragma once

#include "Tolerances.hpp"

#include <array>
#include <cmath>

namespace superquadric {

class Exponent {
public:
	explicit Exponent(double n)
	        : n_(n)
	        , whole_(n == std::floor(n) && n >= 0 ? int(n) : -1)
	{
		double coefficient = 1;
		for (size_t k = 0; k < binomial_.size(); ++k) {
			binomial_[k] = coefficient;
			coefficient *= n > 0 ? (1 / n - k) / (k + 1) : 0;
		}
	}

	double value() const { return n_; }

	// x^n, x^(n-2) and x^(1/n) for x >= 0; n >= 2 for the last two.
	double power(double x) const { return whole_ >= 0 ? multiplied(x, whole_) : real(x, n_); }
	double powerLessTwo(double x) const
	{
		// The paper's particles, without a loop.
		switch (whole_) {
			case 2: return 1;
			case 4: return x * x;
			case 8: return (x * x) * (x * x) * (x * x);
			default: return whole_ >= 2 ? multiplied(x, whole_ - 2) : real(x, n_ - 2);
		}
	}
	double root(double x) const
	{
		return std::abs(x - 1) < tolerances::nearOne ? rootNearOne(x - 1) : rootAnywhere(x);
	}

	// (p^n + q^n)^(1/n) for p, q >= 0, without overflow or loss to underflow.
	double norm(double p, double q) const
	{
		const double large = p > q ? p : q, small = p > q ? q : p;
		return large == 0 ? 0 : large * root(1 + power(small / large));
	}

private:
	// Near a surface the sums whose roots are taken are nearly 1: there the binomial series, in an order that leaves few operations
	// waiting for one another (Estrin). Its ninth power is below rounding.
	double rootNearOne(double e) const
	{
		const auto& b = binomial_;
		const double e2 = e * e, e4 = e2 * e2;
		return (b[0] + b[1] * e) + (b[2] + b[3] * e) * e2 + ((b[4] + b[5] * e) + (b[6] + b[7] * e) * e2 + b[8] * e4) * e4;
	}
	double rootAnywhere(double x) const
	{
		switch (whole_) {
			case 2: return std::sqrt(x);
			case 4: return std::sqrt(std::sqrt(x));
			case 8: return std::sqrt(std::sqrt(std::sqrt(x)));
			default: return std::pow(x, 1 / n_);
		}
	}
	// Ratios to the largest coordinate are often 1.
	static double real(double x, double n) { return x == 1 ? 1 : std::pow(x, n); }
	static double multiplied(double x, int n)
	{
		double result = 1;
		for (; n; n >>= 1, x *= x)
			if (n & 1) result *= x;
		return result;
	}

	double n_;
	int whole_; // the exponent when it is a whole number, else -1
	std::array<double, 9> binomial_; // coefficients of (1 + e)^(1/n)
};

} // namespace superquadric
