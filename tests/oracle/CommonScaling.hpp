// An independent answer to "at which common scaling t* do two bodies touch?", the oracle of the pair tests.
//
// It shares no code and no method with pkg/geometry: it works on the dual problem, 1/t* = min { H(d) : d.r = 1 } with H = h1 + h2 the
// support functions, in long double. With d = r/|r|^2 + u e1 + v e2 this is a convex function of two unknowns. The minimum is kept
// within a polygon of the u-v plane; H and its gradient (the sum of the support points) at the polygon's centroid cut off the half where
// H is larger. A cut through the centroid leaves at most 1 - 1/e of the area (Gruenbaum, Pacific J. Math. 10, 1257, 1960), so it always
// ends. The convexity of H bounds the minimum from below by the tangent plane at the polygon's corners: lower <= t* <= upper
// needs no trust in convergence.
#pragma once

#include <tests/unit/ReferenceShape.hpp>

#include <pkg/geometry/Placement.hpp>

#include <vector>

namespace superquadric::testing {

struct ScalingInterval {
	Real lower, upper; // of t*
	Real middle() const { return (lower + upper) / 2; }
	Real halfWidth() const { return (upper - lower) / 2; }
};

class CommonScaling {
public:
	// The rounding of the doubles that place the bodies, which the oracle takes as exact, is the caller's.
	CommonScaling(const Placement& body1, const Placement& body2) : bodies_ { turned(body1), turned(body2) }, between_((body2.position - body1.position).cast<Real>()) { }

	ScalingInterval solve()
	{
		const Real distance = between_.norm();
		const RealVector along = between_ / (distance * distance);
		const RealVector first = along.unitOrthogonal(), second = along.cross(first).normalized();

		// H >= rho |d| with rho the sum of the smallest half sizes: a ball of that radius fits into each body.
		const Real rho = bodies_[0].shape.sizes.minCoeff() + bodies_[1].shape.sizes.minCoeff();
		Real best = valueAt(along).height, least = 0;
		const Real side = 1.001L * best / rho;
		Polygon polygon { { -side, -side }, { side, -side }, { side, side }, { -side, side } };
		for (int i = 0; i < 400 && best - least > 1e-15L * best && polygon.size() > 2; ++i) {
			const Point centre = centroid(polygon);
			const Value at = valueAt(along + centre.x() * first + centre.y() * second);
			best = std::min(best, at.height);
			const Point slope(at.point.dot(first), at.point.dot(second));
			Real lowest = at.height;
			for (const Point& corner : polygon)
				lowest = std::min(lowest, at.height + slope.dot(corner - centre));
			// The minimum lies in the polygon or is no lower than the best value met.
			least = std::max(least, std::min(lowest, best));
			if (slope.isZero(0)) break;
			polygon = clipped(polygon, centre, slope);
		}
		return { 1 / best, 1 / least };
	}

	// H along a direction of any length.
	Real heightAlong(const RealVector& direction) const { return valueAt(direction).height; }

private:
	using Point = Eigen::Matrix<Real, 2, 1>;
	using Polygon = std::vector<Point>;

	struct Body {
		ReferenceShape shape;
		RealMatrix rotation;
	};
	struct Value {
		Real height;
		RealVector point;
	};

	static Body turned(const Placement& body) { return { ReferenceShape(body.shape), body.rotation.cast<Real>() }; }

	// The support function with its gradient, the dual norm |(|(a dx, b dy)|_m2, c dz)|_m1 with m = n/(n - 1).
	static Value support(const Body& body, const RealVector& direction)
	{
		const ReferenceShape& s = body.shape;
		const RealVector d = (body.rotation.transpose() * direction).cwiseProduct(s.sizes);
		const Real m1 = s.n1 / (s.n1 - 1), m2 = s.n2 / (s.n2 - 1);
		const Real x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
		const Real inner = std::pow(std::pow(x, m2) + std::pow(y, m2), 1 / m2);
		const Real height = std::pow(std::pow(inner, m1) + std::pow(z, m1), 1 / m1);
		const Real side = inner > 0 ? std::pow(inner / height, m1 - 1) : 0;
		const Real xPart = inner > 0 ? side * std::pow(x / inner, m2 - 1) : 0, yPart = inner > 0 ? side * std::pow(y / inner, m2 - 1) : 0;
		const RealVector ratios(std::copysign(xPart, d[0]), std::copysign(yPart, d[1]), std::copysign(std::pow(z / height, m1 - 1), d[2]));
		return { height, body.rotation * ratios.cwiseProduct(s.sizes) };
	}

	Value valueAt(const RealVector& direction) const
	{
		const Value one = support(bodies_[0], direction), two = support(bodies_[1], direction);
		return { one.height + two.height, one.point + two.point };
	}

	static Real cross(const Point& p, const Point& q) { return p.x() * q.y() - p.y() * q.x(); }

	// Seen from a corner, so that a tiny polygon far from the origin keeps its digits.
	static Point centroid(const Polygon& polygon)
	{
		Point sum = Point::Zero();
		Real area = 0;
		for (size_t i = 1; i + 1 < polygon.size(); ++i) {
			const Point p = polygon[i] - polygon[0], q = polygon[i + 1] - polygon[0];
			sum += cross(p, q) * (p + q) / 3;
			area += cross(p, q);
		}
		if (area > 0) return polygon[0] + sum / area;
		Point mean = Point::Zero();
		for (const Point& corner : polygon)
			mean += corner;
		return mean / Real(polygon.size());
	}

	// The part of the polygon where slope.(p - centre) <= 0.
	static Polygon clipped(const Polygon& polygon, const Point& centre, const Point& slope)
	{
		Polygon result;
		for (size_t i = 0; i < polygon.size(); ++i) {
			const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
			const Real atFrom = slope.dot(from - centre), atTo = slope.dot(to - centre);
			if (atFrom <= 0) result.push_back(from);
			if (atFrom * atTo < 0) result.push_back(from + (to - from) * (atFrom / (atFrom - atTo)));
		}
		return result;
	}

	Body bodies_[2];
	RealVector between_;
};

inline ScalingInterval commonScaling(const Placement& body1, const Placement& body2) { return CommonScaling(body1, body2).solve(); }

} // namespace superquadric::testing
