// Powers |x|^n for a fixed exponent: small integers take multiplications, anything else std::pow.
#pragma once

#include <cmath>

namespace superquadric {

class Exponent {
public:
	explicit Exponent(double n) : n_(n), whole_(n == std::floor(n) ? int(n) : 0) { }

	double value() const { return n_; }

	// x^n, x^(n-2) and x^(1/n) for x >= 0; n >= 2.
	double power(double x) const { return whole_ ? multiplied(x, whole_) : std::pow(x, n_); }
	double powerLessTwo(double x) const { return whole_ ? multiplied(x, whole_ - 2) : std::pow(x, n_ - 2); }
	double root(double x) const
	{
		switch (whole_) {
			case 2: return std::sqrt(x);
			case 4: return std::sqrt(std::sqrt(x));
			case 8: return std::sqrt(std::sqrt(std::sqrt(x)));
			default: return std::pow(x, 1 / n_);
		}
	}

	// (p^n + q^n)^(1/n) for p, q >= 0, without overflow or loss to underflow.
	double norm(double p, double q) const
	{
		const double large = p > q ? p : q, small = p > q ? q : p;
		return large == 0 ? 0 : large * root(1 + power(small / large));
	}

private:
	static double multiplied(double x, int n)
	{
		double result = 1;
		for (; n; n >>= 1, x *= x)
			if (n & 1) result *= x;
		return result;
	}

	double n_;
	int whole_; // the exponent when it is an integer, else 0
};

} // namespace superquadric
