// An independent description of an overlapping pair, in long double: contact centre, normal, surface points, overlap and
// curvatures.
//
// The centre X0 minimises F = -ln(1 - t) + c q with t = max(g1, g2) and q = (e1^2 + e2^2)/2, e_i the distance from centre i in half sizes.
// The search knows nothing of where it ends: an interior-point method (log barriers of tau > g1, g2 on x and tau together) for bodies
// scaled by T, T falling to 1, then Newton on the conditions for equal gauges. How far off it may be does not rest on the search:
// at a point of equal gauges F touches the smooth function G = -ln(1 - w) + c q of the weighted gauge w = l g1 + (1 - l) g2 <= t from
// above, and q makes G strongly convex, so that the distance from the minimiser is at most 2 |grad G| / c (`error`, in half sizes).
#pragma once

#include <tests/support/ReferenceShape.hpp>

#include <pkg/geometry/Placement.hpp>

#include <algorithm>

namespace superquadric::testing {

// Gauge with its derivatives, differentiated by hand from eq. (1); units of the body's place.
struct ReferenceGauge {
	Real value;
	RealVector gradient;
	RealMatrix hessian;
};

class ReferenceBody {
public:
	ReferenceBody(const Placement& body, const Vector3& origin, Real unit)
	        : sizes_(body.shape.halfSizes().cast<Real>() / unit)
	        , n1_(body.shape.n1())
	        , n2_(body.shape.n2())
	        , rotation_(body.rotation.cast<Real>())
	        , centre_((body.position - origin).cast<Real>() / unit)
	        , stretch_(rotation_ * sizes_.cwiseAbs2().cwiseInverse().asDiagonal() * rotation_.transpose())
	{
	}

	const RealVector& centre() const { return centre_; }

	ReferenceGauge gauge(const RealVector& x) const
	{
		const RealVector own = rotation_.transpose() * (x - centre_);
		// Off the planes of symmetry by less than any rounding, where the negative powers below are finite.
		const RealVector u = own.cwiseQuotient(sizes_).cwiseAbs().cwiseMax(Real(1e-40L));
		const Real section = std::pow(u[0], n2_) + std::pow(u[1], n2_), k = n1_ / n2_;
		const Real f = std::pow(section, k) + std::pow(u[2], n1_);

		RealVector scale;
		for (int axis = 0; axis < 3; ++axis)
			scale[axis] = std::copysign(1 / sizes_[axis], own[axis]);
		const Real outer = n1_ * std::pow(section, k - 1), bent = n1_ * (n1_ - n2_) * std::pow(section, k - 2);
		const Real p = std::pow(u[0], n2_ - 1), q = std::pow(u[1], n2_ - 1);
		const RealVector slope(outer * p, outer * q, n1_ * std::pow(u[2], n1_ - 1));
		RealMatrix second = RealMatrix::Zero();
		second(0, 0) = bent * p * p + outer * (n2_ - 1) * p / u[0];
		second(1, 1) = bent * q * q + outer * (n2_ - 1) * q / u[1];
		second(0, 1) = second(1, 0) = bent * p * q;
		second(2, 2) = slope[2] * (n1_ - 1) / u[2];

		// g = f^(1/n1).
		const Real g = std::pow(f, 1 / n1_), factor = g / (n1_ * f);
		const RealMatrix hessian = factor * (second - (1 - 1 / n1_) / f * slope * slope.transpose());
		const RealMatrix turned = rotation_ * scale.asDiagonal();
		return { g, turned * (factor * slope), turned * hessian * turned.transpose() };
	}

	// Of e^2/2.
	const RealMatrix& distanceHessian() const { return stretch_; }
	RealVector distanceGradient(const RealVector& x) const { return stretch_ * (x - centre_); }

	// Distance along a direction to where the body is left, by bisection.
	Real distanceToSurface(const RealVector& from, const RealVector& direction) const
	{
		Real inside = 0, outside = 4 * sizes_.sum();
		for (int i = 0; i < 90; ++i) {
			const Real middle = (inside + outside) / 2;
			(gauge(from + middle * direction).value < 1 ? inside : outside) = middle;
		}
		return (inside + outside) / 2;
	}

	// Of the level surface through a point, eq. (10).
	Real meanCurvature(const RealVector& x) const
	{
		const ReferenceGauge g = gauge(x);
		const Real steepness = g.gradient.norm();
		return (g.hessian.trace() - g.gradient.dot(g.hessian * g.gradient) / (steepness * steepness)) / (2 * steepness);
	}

private:
	RealVector sizes_;
	Real n1_, n2_;
	RealMatrix rotation_;
	RealVector centre_;
	RealMatrix stretch_;
};

struct ReferenceContact {
	RealVector point, normal, surface1, surface2; // points from the centre of body 1 [m]
	Real overlap; // [m]
	Real curvature1, curvature2; // mean, at the surface points [1/m]
	Real error; // bound of the point's distance from the true one, in the half sizes of both bodies
};

// Of a pair that overlaps, not by so much that the smaller body's middle is in it: there F has its minimum where g1 and g2 differ.
class ContactCentre {
public:
	static constexpr Real centring = 2;

	ContactCentre(const Placement& body1, const Placement& body2)
	        : unit_(std::min(body1.shape.smallestHalfSize(), body2.shape.smallestHalfSize()))
	        , one_(body1, body1.position, unit_)
	        , two_(body2, body1.position, unit_)
	        , stretch_(one_.distanceHessian() + two_.distanceHessian())
	{
	}

	ReferenceContact solve()
	{
		followThePath();
		const Real residual = polish();
		const RealVector normal = (at_[0].gradient - at_[1].gradient).normalized();
		const Real out1 = one_.distanceToSurface(x_, normal), out2 = two_.distanceToSurface(x_, -normal);
		const RealVector surface1 = x_ + out1 * normal, surface2 = x_ - out2 * normal;
		return { unit_ * x_, normal, unit_ * surface1, unit_ * surface2, unit_ * (out1 + out2),
			one_.meanCurvature(surface1) / unit_, two_.meanCurvature(surface2) / unit_, 2 * residual / centring };
	}

	// F, infinite where the point is not within both bodies; x from the centre of body 1 [m].
	Real objective(const RealVector& x) const
	{
		const Real t = std::max(one_.gauge(x / unit_).value, two_.gauge(x / unit_).value);
		return t < 1 ? -std::log(1 - t) + centring * distances(x / unit_) : std::numeric_limits<Real>::infinity();
	}

private:
	using Vector4 = Eigen::Matrix<Real, 4, 1>;
	using Matrix4 = Eigen::Matrix<Real, 4, 4>;

	Real distances(const RealVector& x) const
	{
		const RealVector d1 = x - one_.centre(), d2 = x - two_.centre();
		return (d1.dot(one_.distanceHessian() * d1) + d2.dot(two_.distanceHessian() * d2)) / 2;
	}
	RealVector pull(const RealVector& x) const { return one_.distanceGradient(x) + two_.distanceGradient(x); }

	void evaluate()
	{
		at_[0] = one_.gauge(x_);
		at_[1] = two_.gauge(x_);
	}

	Real barrier(const RealVector& x, Real tau, Real largest, Real weight) const
	{
		const Real room1 = tau - one_.gauge(x).value, room2 = tau - two_.gauge(x).value;
		if (!(room1 > 0 && room2 > 0 && largest > tau)) return std::numeric_limits<Real>::infinity();
		return -std::log(largest - tau) + centring * distances(x) - weight * (std::log(room1) + std::log(room2));
	}

	// First the scale of the bodies falls to 1, then the barrier's weight to nothing; each minimum is the start for the next.
	void followThePath()
	{
		const Real g1 = one_.gauge(two_.centre()).value, g2 = two_.gauge(one_.centre()).value;
		x_ = two_.centre() * (g2 / (g1 + g2)); // of equal gauges
		tau_ = 1.05L * g1 * g2 / (g1 + g2);
		Real weight = 0.03L;
		for (Real largest = std::max(Real(1), 1.05L * tau_); largest > 1; largest = std::max(Real(1), tau_ + 0.1L * (largest - tau_)))
			descend(largest, weight);
		for (; weight > 1e-9L; weight /= 10)
			descend(1, weight);
	}

	void descend(Real largest, Real weight)
	{
		for (int i = 0; i < 100 && barrierStep(largest, weight) > 0.01L; ++i) { }
	}

	// One damped Newton step; returns how much it promised.
	Real barrierStep(Real largest, Real weight)
	{
		evaluate();
		Vector4 slope = Vector4::Zero();
		Matrix4 bend = Matrix4::Zero();
		slope.head<3>() = centring * pull(x_);
		bend.topLeftCorner<3, 3>() = centring * stretch_;
		slope[3] = 1 / (largest - tau_);
		bend(3, 3) = slope[3] * slope[3];
		for (const ReferenceGauge& g : at_) {
			Vector4 room; // gradient of tau - g
			room << -g.gradient, 1;
			const Real push = weight / (tau_ - g.value);
			slope -= push * room;
			bend += push / (tau_ - g.value) * room * room.transpose();
			bend.topLeftCorner<3, 3>() += push * g.hessian;
		}
		const Vector4 step = -bend.ldlt().solve(slope);
		const Real promise = -slope.dot(step), before = barrier(x_, tau_, largest, weight);
		for (Real part = 1; part > 1e-9L; part /= 2) {
			const RealVector x = x_ + part * step.head<3>();
			const Real tau = tau_ + part * step[3];
			if (!(barrier(x, tau, largest, weight) <= before - 0.1L * part * promise)) continue;
			x_ = x;
			tau_ = tau;
			return promise;
		}
		return 0;
	}

	// Newton on (1 - w) grad G = 0 and g1 = g2; keeps the best point and returns |grad G| there, measured in half sizes.
	Real polish()
	{
		evaluate();
		const Real push1 = 1 / (tau_ - at_[0].value), push2 = 1 / (tau_ - at_[1].value);
		Real share = push1 / (push1 + push2), least = std::numeric_limits<Real>::infinity();
		RealVector best = x_;
		for (int i = 0, idle = 0; i < 30 && idle < 4; ++i, idle += std::isfinite(least)) {
			evaluate();
			const RealVector across = at_[0].gradient - at_[1].gradient, along = share * at_[0].gradient + (1 - share) * at_[1].gradient;
			const Real room = 1 - share * at_[0].value - (1 - share) * at_[1].value, balance = at_[0].value - at_[1].value;
			const RealVector rest = along + centring * room * pull(x_);
			const Real residual = std::sqrt(rest.dot(stretch_.ldlt().solve(rest))) / room;
			if (share > 0 && share < 1 && std::abs(balance) < 1e-17L && residual < least) {
				least = residual;
				best = x_;
				idle = 0;
			}
			Matrix4 system = Matrix4::Zero();
			system.topLeftCorner<3, 3>() = share * at_[0].hessian + (1 - share) * at_[1].hessian + centring * (room * stretch_ - pull(x_) * along.transpose());
			system.topRightCorner<3, 1>() = across - centring * balance * pull(x_);
			system.bottomLeftCorner<1, 3>() = across.transpose();
			Vector4 right;
			right << -rest, -balance;
			const Vector4 step = system.fullPivLu().solve(right);
			x_ += step.head<3>();
			share += step[3];
		}
		x_ = best;
		evaluate();
		return least;
	}

	Real unit_; // [m]: the smallest half size
	ReferenceBody one_, two_;
	RealMatrix stretch_; // Hessian of q
	RealVector x_;
	Real tau_ = 0;
	ReferenceGauge at_[2];
};

inline ReferenceContact referenceContact(const Placement& body1, const Placement& body2) { return ContactCentre(body1, body2).solve(); }

} // namespace superquadric::testing
