// An independent answer to "at which common scaling t* do two bodies touch?", the oracle of the pair tests.
//
// It shares no code and no method with pkg/geometry: it works on the dual problem, 1/t* = min { H(d) : d.r = 1 } with H = h1 + h2 the
// support functions. With d = r/|r|^2 + u e1 + v e2 this is a convex function of two unknowns. The minimum is kept within a polygon of
// the u-v plane; H and its gradient (the sum of the support points) at the polygon's centroid cut off where H is larger than the least
// value met. A cut through the centroid leaves at most 1 - 1/e of the area (Gruenbaum, Pacific J. Math. 10, 1257, 1960), so it always
// ends. The convexity of H bounds the minimum from below by the tangent plane at the polygon's corners: lower <= t* <= upper
// needs no trust in convergence.
//
// In long double the interval is some 1e-17 wide, in double 2e-14 at sixteen times the speed, enough for all verdicts but those within
// that of touching. Either is widened by what rounding may have cost, `roundingSteps` units in the last place of the number.
#pragma once

#include <tests/support/ReferenceShape.hpp>

#include <pkg/geometry/Placement.hpp>

#include <limits>
#include <vector>

namespace superquadric::testing {

struct ScalingInterval {
	Real lower, upper; // of t*
	Real middle() const { return (lower + upper) / 2; }
	Real halfWidth() const { return (upper - lower) / 2; }
};

template <class Number> class CommonScaling {
public:
	using Vector = Eigen::Matrix<Number, 3, 1>;

	// The rounding of the doubles that place the bodies, which the oracle takes as exact, is the caller's.
	CommonScaling(const Placement& body1, const Placement& body2)
	        : bodies_ { Body(body1), Body(body2) }
	        , between_((body2.position - body1.position).cast<Number>())
	{
	}

	ScalingInterval solve()
	{
		const Number distance = between_.norm();
		along_ = between_ / (distance * distance);
		first_ = along_.unitOrthogonal();
		second_ = along_.cross(first_).normalized();

		// H >= rho |d| with rho the sum of the smallest half sizes: a ball of that radius fits into each body.
		const Number rho = bodies_[0].sizes.minCoeff() + bodies_[1].sizes.minCoeff();
		Number best = valueAt(along_).height, least = 0;
		const Number side = Number(1.001L) * best / rho;
		polygon_ = { { -side, -side }, { side, -side }, { side, side }, { -side, side } };
		for (int i = 0; i < longest && best - least > narrow * best && polygon_.size() > 2; ++i) {
			const Point centre = centroid();
			const Value at = valueAt(along_ + centre.x() * first_ + centre.y() * second_);
			best = std::min(best, at.height);
			const Point slope(at.point.dot(first_), at.point.dot(second_));
			Number lowest = at.height;
			for (const Point& corner : polygon_)
				lowest = std::min(lowest, at.height + slope.dot(corner - centre));
			// The minimum lies in the polygon or is no lower than the best value met.
			least = std::max(least, std::min(lowest, best));
			if (slope.isZero(0)) break;
			clip(centre, slope, best - at.height);
		}
		const Real blur = roundingSteps * Real(std::numeric_limits<Number>::epsilon());
		return { (1 - blur) / best, (1 + blur) / least };
	}

	// H along a direction of any length.
	Number heightAlong(const Vector& direction) const { return valueAt(direction).height; }

	static constexpr int roundingSteps = 64;

private:
	using Point = Eigen::Matrix<Number, 2, 1>;
	static constexpr int longest = 400;
	static constexpr Number narrow = 32 * std::numeric_limits<Number>::epsilon();

	struct Body {
		explicit Body(const Placement& body)
		        : sizes(body.shape.halfSizes().cast<Number>())
		        , n1(body.shape.n1())
		        , n2(body.shape.n2())
		        , rotation(body.rotation.cast<Number>())
		{
		}
		Vector sizes;
		Number n1, n2;
		Eigen::Matrix<Number, 3, 3> rotation;
	};
	struct Value {
		Number height;
		Vector point;
	};
	// (p^m + q^m)^(1/m) for p, q >= 0 with m = n/(n - 1), and its derivatives.
	struct Norm {
		Number value, byP, byQ;
	};

	static Norm dualNorm(Number p, Number q, Number n)
	{
		const bool swapped = p < q;
		if (swapped) std::swap(p, q);
		if (p == 0) return { 0, 0, 0 };
		// With s = q/p the value is p (1 + s^m)^(1/m), and s^m = s s^(m - 1).
		const Number power = std::pow(q / p, 1 / (n - 1)), sum = 1 + power * q / p;
		const Number root = std::pow(sum, (n - 1) / n), large = root / sum, small = power * large;
		return { p * root, swapped ? small : large, swapped ? large : small };
	}

	static Value support(const Body& body, const Vector& direction)
	{
		const Vector own = (body.rotation.transpose() * direction).cwiseProduct(body.sizes), d = own.cwiseAbs();
		const Norm inner = dualNorm(d[0], d[1], body.n2), outer = dualNorm(inner.value, d[2], body.n1);
		const Vector ratios(std::copysign(outer.byP * inner.byP, own[0]), std::copysign(outer.byP * inner.byQ, own[1]), std::copysign(outer.byQ, own[2]));
		return { outer.value, body.rotation * ratios.cwiseProduct(body.sizes) };
	}

	Value valueAt(const Vector& direction) const
	{
		const Value one = support(bodies_[0], direction), two = support(bodies_[1], direction);
		return { one.height + two.height, one.point + two.point };
	}

	static Number cross(const Point& p, const Point& q) { return p.x() * q.y() - p.y() * q.x(); }

	// Seen from a corner, so that a tiny polygon far from the origin keeps its digits.
	Point centroid() const
	{
		Point sum = Point::Zero();
		Number area = 0;
		for (size_t i = 1; i + 1 < polygon_.size(); ++i) {
			const Point p = polygon_[i] - polygon_[0], q = polygon_[i + 1] - polygon_[0];
			sum += cross(p, q) * (p + q) / 3;
			area += cross(p, q);
		}
		if (area > 0) return polygon_[0] + sum / area;
		Point mean = Point::Zero();
		for (const Point& corner : polygon_)
			mean += corner;
		return mean / Number(polygon_.size());
	}

	// Keeps the part of the polygon where slope.(p - centre) <= rest.
	void clip(const Point& centre, const Point& slope, Number rest)
	{
		clipped_.clear();
		const auto height = [&](const Point& p) { return slope.dot(p - centre) - rest; };
		for (size_t i = 0; i < polygon_.size(); ++i) {
			const Point &from = polygon_[i], &to = polygon_[(i + 1) % polygon_.size()];
			const Number atFrom = height(from), atTo = height(to);
			if (atFrom <= 0) clipped_.push_back(from);
			if (atFrom * atTo < 0) clipped_.push_back(from + (to - from) * (atFrom / (atFrom - atTo)));
		}
		polygon_.swap(clipped_);
	}

	Body bodies_[2];
	Vector between_, along_, first_, second_; // the last three: d = along + u first + v second
	std::vector<Point> polygon_, clipped_;
};

template <class Number = Real> ScalingInterval commonScaling(const Placement& body1, const Placement& body2)
{
	return CommonScaling<Number>(body1, body2).solve();
}

} // namespace superquadric::testing
