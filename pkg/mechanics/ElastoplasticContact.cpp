#include "ElastoplasticContact.hpp"

#include <pkg/geometry/Tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace superquadric::elastoplastic {

namespace {

	[[noreturn]] void refuse(const char* name, const char* condition, double value)
	{
		std::ostringstream message;
		message << name << " must be " << condition << ", got " << value;
		throw std::invalid_argument(message.str());
	}

	void checkPositive(const char* name, double value)
	{
		if (!(std::isfinite(value) && value > 0)) refuse(name, "finite and positive", value);
	}

	void checkFinite(const char* name, double value)
	{
		if (!std::isfinite(value)) refuse(name, "finite", value);
	}

	double parabola(const Hardening& hardening, double ratio) { return hardening.m0 + ratio * (hardening.m1 + ratio * hardening.m2); }

	double smallestFactor(const Hardening& hardening)
	{
		const double low = hardening.smallestRatio, high = hardening.largestRatio;
		const double ends = std::min(parabola(hardening, low), parabola(hardening, high));
		if (!(hardening.m2 > 0)) return ends;
		const double vertex = std::min(std::max(-hardening.m1 / (2 * hardening.m2), low), high);
		return std::min(ends, parabola(hardening, vertex));
	}

	void checkHardening(const Hardening& hardening)
	{
		checkPositive("referenceRadius", hardening.referenceRadius);
		checkFinite("m0", hardening.m0);
		checkFinite("m1", hardening.m1);
		checkFinite("m2", hardening.m2);
		if (!(hardening.exponent > 0 && hardening.exponent < 3)) refuse("exponent", "between 0 and 3", hardening.exponent);
		checkPositive("smallestRatio", hardening.smallestRatio);
		checkFinite("largestRatio", hardening.largestRatio);
		if (hardening.largestRatio < hardening.smallestRatio) refuse("largestRatio", "at least smallestRatio", hardening.largestRatio);
		const double factor = smallestFactor(hardening);
		if (!(factor > 0)) refuse("m0 + m1 r + m2 r^2", "positive for r from smallestRatio to largestRatio", factor);
	}

	// Where `later` becomes true between `low`, where it is false, and `high`, where it is true.
	template <class Predicate>
	double turningPoint(double low, double high, const Predicate& later)
	{
		for (int i = 0; i < 200; ++i) {
			const double middle = low + (high - low) / 2;
			if (middle == low || middle == high) break;
			(later(middle) ? high : low) = middle;
		}
		return high;
	}

	// The w > 0 where, at given H > 1, the residual overlap grows least for its share of Hertz's rate, whatever G: the single
	// positive root (Descartes) of the derivative of ln([(H - 1) w^H + H w^(H-1)]/[2(1 + w)^3 + 1]), times its denominators.
	double steepestPlace(double exponent)
	{
		const double H = exponent, c = H - 1;
		const auto beyond = [&](double w) { return 3 * c * H + w * (6 * H * (c - 1) + w * (6 * (c * c - c - 1) + w * 2 * c * (H - 3))) < 0; };
		double high = 1;
		while (!beyond(high) && high < tolerances::farBeyondYield)
			high *= 2;
		return turningPoint(0, high, beyond);
	}

	// Path 3.
	struct Branch {
		explicit Branch(const History& history)
		        : residual(history.residual)
		        , hertz(4. / 3 * history.modulus * std::sqrt(history.radius * (history.largest / (history.largest - history.residual))))
		{
		}

		double length(double overlap) const { return std::max(0., overlap - residual); }
		double force(double overlap) const { return hertz * length(overlap) * std::sqrt(length(overlap)); }
		double slope(double overlap) const { return 3. / 2 * hertz * std::sqrt(length(overlap)); }
		double energy(double overlap) const { return 2. / 5 * force(overlap) * length(overlap); }

		double residual; // dR [m]
		double hertz; // 4/3 E* sqrt(R') [N/m^1.5]
	};
}

double Hardening::factor(double radius) const
{
	return parabola(*this, std::min(std::max(radius / referenceRadius, smallestRatio), largestRatio));
}

void check(const Material& material)
{
	if (!(material.yieldStress > 0)) refuse("yieldStress", "positive", material.yieldStress);
	if (material.yields()) checkHardening(material.hardening);
}

const Material& softer(const Material& one, const Material& other)
{
	// The rest of the key only makes the choice independent of the order where yield stresses are equal.
	const auto key = [](const Material& m) {
		const Hardening& h = m.hardening;
		return std::make_tuple(m.yieldStress, h.m0, h.m1, h.m2, h.exponent, h.referenceRadius, h.smallestRatio, h.largestRatio);
	};
	return key(other) < key(one) ? other : one;
}

YieldPoint yieldPoint(double yieldStress, double modulus, double radius)
{
	YieldPoint point;
	point.pressure = pressureAtYield * yieldStress;
	const double slope = pi * point.pressure / (2 * modulus); // ay/R
	point.overlap = slope * slope * radius;
	point.contactRadius = slope * radius;
	point.force = 4. / 3 * modulus * radius * radius * slope * slope * slope;
	return point;
}

LoadingCurve::LoadingCurve(const Pair& pair)
        : hertz_(4. / 3 * pair.modulus * std::sqrt(pair.radius))
        , yield_(yieldPoint(pair.material.yieldStress, pair.modulus, pair.radius))
        , factor_(pair.material.hardening.factor(pair.radius))
        , exponent_(pair.material.hardening.exponent)
{
	if (pair.material.yields()) pause_ = findPause();
}

double LoadingCurve::excess(double overlap) const
{
	// Without the cancellation of sqrt(d/dy) - 1.
	return (overlap - yield_.overlap) / (yield_.overlap * (1 + std::sqrt(overlap / yield_.overlap)));
}

bool LoadingCurve::pauses(double w) const { return w > pause_.begin && w < pause_.end; }

double LoadingCurve::fittedForce(double w) const { return 1 + factor_ * std::pow(w, exponent_); }

double LoadingCurve::fittedEnergy(double w) const
{
	const double H = exponent_;
	return 2. / 5 + w * (2 + w) + 2 * factor_ * std::pow(w, H + 1) * (1 / (H + 1) + w / (H + 2)); // dd = 2 (1 + w) dw
}

double LoadingCurve::fittedResidual(double w) const
{
	// u^2 - f/u with u = 1 + w, without the cancellation near yield.
	return (w * (3 + w * (3 + w)) - factor_ * std::pow(w, exponent_)) / (1 + w);
}

// Integral of u (u^2 - dR), the force where dR stays.
double LoadingCurve::pauseEnergy(double w) const
{
	const double u = 1 + w;
	return u * u * u * (2. / 5 * u * u - 2. / 3 * pause_.residual);
}

LoadingCurve::Pause LoadingCurve::findPause() const
{
	const double H = exponent_;
	// The derivative of fittedResidual, times (1 + w)^2, is negative. For H > 1 that is so around steepestPlace if anywhere,
	// else from w = 0 on.
	const auto tooSteep = [&](double w) {
		return factor_ * ((H - 1) * std::pow(w, H) + H * std::pow(w, H - 1)) > 2 * (1 + w) * (1 + w) * (1 + w) + 1;
	};
	Pause pause;
	const double steepest = H > 1 ? steepestPlace(H) : 0;
	if (!tooSteep(steepest)) return pause;
	pause.begin = H > 1 ? turningPoint(0, steepest, tooSteep) : 0;
	pause.residual = fittedResidual(pause.begin);

	const auto over = [&](double w) { return fittedResidual(w) > pause.residual; };
	double high = std::max(1., 2 * steepest);
	while (!over(high)) {
		if (high > tolerances::farBeyondYield) return pause;
		high *= 2;
	}
	pause.end = turningPoint(steepest, high, over);
	return pause;
}

double LoadingCurve::force(double overlap) const
{
	if (overlap <= yield_.overlap) return hertz_ * overlap * std::sqrt(overlap);
	const double w = excess(overlap), u = 1 + w;
	return yield_.force * (pauses(w) ? u * (u * u - pause_.residual) : fittedForce(w));
}

double LoadingCurve::slope(double overlap) const
{
	if (overlap <= yield_.overlap) return 3. / 2 * hertz_ * std::sqrt(overlap);
	const double w = excess(overlap), u = 1 + w;
	const double byW = pauses(w) ? 3 * u * u - pause_.residual : factor_ * exponent_ * std::pow(w, exponent_ - 1);
	return yield_.force / yield_.overlap * byW / (2 * u);
}

double LoadingCurve::energy(double overlap) const
{
	if (overlap <= yield_.overlap) return 2. / 5 * hertz_ * overlap * overlap * std::sqrt(overlap);
	const double unit = yield_.force * yield_.overlap, w = excess(overlap);
	if (w <= pause_.begin) return unit * fittedEnergy(w);
	const double paused = fittedEnergy(pause_.begin) + pauseEnergy(std::min(w, pause_.end)) - pauseEnergy(pause_.begin);
	return unit * (w < pause_.end ? paused : paused + (fittedEnergy(w) - fittedEnergy(pause_.end)));
}

double LoadingCurve::residual(double overlap) const
{
	if (overlap <= yield_.overlap) return 0;
	const double w = excess(overlap);
	return yield_.overlap * (pauses(w) ? pause_.residual : fittedResidual(w));
}

State normalForce(const Pair& pair, const History& history, double overlap)
{
	State state;
	state.history = history;
	if (history.largest == 0) {
		if (!(overlap > 0)) return state;
		state.history.modulus = pair.modulus;
		state.history.radius = pair.radius;
	}
	History& now = state.history;
	const bool loading = overlap > history.largest;
	if (loading) now.largest = overlap;
	const bool yields = loading && overlap > yieldPoint(pair.material.yieldStress, now.modulus, now.radius).overlap;
	if (yields) {
		const LoadingCurve curve({ pair.material, now.modulus, now.radius });
		now.residual = std::max(history.residual, curve.residual(overlap)); // max: against rounding
		state.stiffness = curve.slope(overlap);
		const double work = curve.energy(overlap) - Branch(now).energy(overlap);
		if (now.residual > 0) now.dissipated = std::max(history.dissipated, work); // max: against rounding
	}
	const Branch branch(now);
	state.force = branch.force(overlap);
	state.unloadingStiffness = branch.slope(overlap);
	if (!yields) state.stiffness = state.unloadingStiffness;
	state.elastic = branch.energy(overlap);
	state.flows = now.residual > history.residual;
	return state;
}

double viscousForce(const State& state, double damping, double mass, double approachSpeed)
{
	if (state.flows) return 0;
	return std::max(damping * std::sqrt(4 * mass * state.unloadingStiffness) * approachSpeed, -state.force);
}

} // namespace superquadric::elastoplastic
