#include "WallCentre.hpp"

#include "RayExit.hpp"
#include <pkg/geometry/Tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace superquadric {

namespace {

	constexpr double pull = tolerances::centring;

	// What follows from the gauge.
	void complete(CentredPoint& point)
	{
		point.depth = 1 - point.jet.value;
		point.objective = point.depth > 0 ? 0.5 * pull * point.u.squaredNorm() - std::log(point.depth) : std::numeric_limits<double>::infinity();
		point.slope = point.jet.gradient + pull * point.depth * point.u;
	}

	struct Step {
		Vector3 u;
		double decrement; // the squared length of the step in the norm of the Hessian
	};

	// For orthonormal directions. The systems are those of Newton's method times (1 - g)^2.
	Step stepAcross(const CentredPoint& p, const Vector3& along1, const Vector3& along2)
	{
		const double g1 = p.jet.gradient.dot(along1), g2 = p.jet.gradient.dot(along2);
		const double m11 = p.depth * p.jet.form(along1) + g1 * g1, m12 = p.depth * p.jet.form(along1, along2) + g1 * g2;
		const double m22 = p.depth * p.jet.form(along2) + g2 * g2, centring = pull * p.depth * p.depth;
		// The first term's determinant is not negative; rounding may make it so where its curvatures differ much.
		const double determinant = std::max(m11 * m22 - m12 * m12, 0.0) + centring * (m11 + m22 + centring);
		const double s1 = p.slope.dot(along1), s2 = p.slope.dot(along2);
		const double y1 = (m12 * s2 - (m22 + centring) * s1) / determinant, y2 = (m12 * s1 - (m11 + centring) * s2) / determinant;
		return { p.depth * (y1 * along1 + y2 * along2), -(y1 * s1 + y2 * s2) };
	}

	Step stepAlong(const CentredPoint& p, const Vector3& along)
	{
		const double g = p.jet.gradient.dot(along), s = p.slope.dot(along);
		const double m = p.depth * p.jet.form(along) + g * g + pull * p.depth * p.depth;
		return { -p.depth * s / m * along, s * s / m };
	}

	// Halves the step until it leads inside and down; what rounding of the depth hides does not count.
	bool descend(const Shape& shape, CentredPoint& point, const Step& step)
	{
		const double blur = tolerances::gaugeRounding / point.depth;
		for (double part = 1; part > tolerances::shortestWallStep; part /= 2) { // NOLINT(clang-analyzer-security.FloatLoopCounter): halving is exact
			const CentredPoint next = centreAt(shape, point.u + part * step.u);
			if (!(next.objective <= point.objective - tolerances::wallDescent * part * step.decrement + blur)) continue;
			point = next;
			return true;
		}
		return false;
	}

	// The last step, so short that the gauge's parabola tells what is at its end.
	void follow(CentredPoint& point, const Vector3& step)
	{
		const Vector3 bend = point.jet.hessianTimes(step);
		point.jet.value += step.dot(point.jet.gradient + 0.5 * bend);
		point.jet.gradient += bend;
		point.u += step;
		complete(point);
	}

	template <class NewtonStep> CentredPoint minimise(const Shape& shape, const Vector3& start, const NewtonStep& newtonStep, SolverCounters& counters)
	{
		CentredPoint point = centreAt(shape, start);
		if (!point.within()) return point;
		for (int i = 0; i < tolerances::newtonIterations; ++i) {
			const Step step = newtonStep(point);
			if (step.decrement <= tolerances::lastWallDecrement) {
				follow(point, step.u);
				return point;
			}
			++counters.iterations;
			if (!descend(shape, point, step)) break;
		}
		++counters.fallbacks;
		return point;
	}

} // namespace

bool CentredPoint::within() const { return depth > tolerances::touching; }

CentredPoint centreAt(const Shape& shape, const Vector3& u)
{
	CentredPoint point;
	point.u = u;
	point.jet = shape.jet(u);
	complete(point);
	return point;
}

CentredPoint centreOnPlane(const Shape& shape, const Vector3& start, const Vector3& normal, SolverCounters& counters)
{
	const Vector3 across = normal.normalized(), along1 = across.unitOrthogonal(), along2 = across.cross(along1);
	return minimise(shape, start, [&](const CentredPoint& p) { return stepAcross(p, along1, along2); }, counters);
}

CentredPoint centreOnLine(const Shape& shape, const Vector3& start, const Vector3& direction, SolverCounters& counters)
{
	const Vector3 along = direction.normalized();
	return minimise(shape, start, [&](const CentredPoint& p) { return stepAlong(p, along); }, counters);
}

Contact contactAtCentre(const Placement& body, const CentredPoint& centre, const Vector3& outwards)
{
	const BodyPoint from { centre.u, centre.jet, body.frame * centre.jet.gradient };
	const SurfacePoint surface = surfaceAlong(body, from, outwards, firstGuess(body, from, outwards));
	Contact contact;
	contact.status = Status::Overlap;
	contact.upper = centre.jet.value;
	contact.normal = outwards;
	contact.overlap = surface.distance;
	contact.surface2 = contact.point = body.position + body.toWorld(centre.u.cwiseProduct(body.shape.halfSizes()));
	contact.surface1 = contact.surface2 + surface.distance * outwards;
	contact.curvature1 = surface.curvature;
	return contact;
}

} // namespace superquadric
