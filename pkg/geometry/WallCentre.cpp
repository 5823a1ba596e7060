#include "WallCentre.hpp"

#include "Curvature.hpp"
#include "Tolerances.hpp"

#include <cmath>
#include <limits>

namespace superquadric {

bool CentredPoint::within() const { return depth > tolerances::touching; }

namespace {

	void complete(const Shape& shape, CentredPoint& point)
	{
		point.depth = 1 - point.gauge.value;
		const Vector3 u = point.x.cwiseQuotient(shape.halfSizes());
		point.objective = point.depth > 0 ? -std::log(point.depth) + 0.5 * tolerances::centring * u.squaredNorm() : std::numeric_limits<double>::infinity();
		point.slope = point.gauge.gradient + tolerances::centring * point.depth * u.cwiseQuotient(shape.halfSizes());
	}

} // namespace

CentredPoint centreAt(const Shape& shape, const Vector3& x)
{
	CentredPoint point;
	point.x = x;
	point.gauge = shape.gaugeWithHessian(x);
	complete(shape, point);
	return point;
}

namespace {

	struct Step {
		Vector3 x;
		double decrement; // the squared length of the step in the norm of the Hessian
	};

	// Both directions are orthonormal when measured in half sizes, where the second term's Hessian is c times the identity.
	// The systems are those of Newton's method times (1 - g)^2.
	Step stepAcross(const CentredPoint& p, const Vector3& along1, const Vector3& along2)
	{
		const Vector3 H1 = p.gauge.hessian * along1, H2 = p.gauge.hessian * along2;
		const double g1 = p.gauge.gradient.dot(along1), g2 = p.gauge.gradient.dot(along2);
		const double m11 = p.depth * along1.dot(H1) + g1 * g1, m12 = p.depth * along1.dot(H2) + g1 * g2, m22 = p.depth * along2.dot(H2) + g2 * g2;
		const double centring = tolerances::centring * p.depth * p.depth;
		// The first term's determinant is not negative; rounding may make it so where its curvatures differ much.
		const double determinant = std::max(m11 * m22 - m12 * m12, 0.0) + centring * (m11 + m22 + centring);
		const double s1 = p.slope.dot(along1), s2 = p.slope.dot(along2);
		const double y1 = (m12 * s2 - (m22 + centring) * s1) / determinant, y2 = (m12 * s1 - (m11 + centring) * s2) / determinant;
		return { p.depth * (y1 * along1 + y2 * along2), -(y1 * s1 + y2 * s2) };
	}

	Step stepAlong(const CentredPoint& p, const Vector3& along)
	{
		const double g = p.gauge.gradient.dot(along), s = p.slope.dot(along);
		const double m = p.depth * along.dot(p.gauge.hessian * along) + g * g + tolerances::centring * p.depth * p.depth;
		return { -p.depth * s / m * along, s * s / m };
	}

	// Halves the step until it leads inside and down; what rounding of the depth hides does not count.
	bool descend(const Shape& shape, CentredPoint& point, const Step& step)
	{
		const double blur = tolerances::gaugeRounding / point.depth;
		for (double part = 1; part > tolerances::shortestWallStep; part /= 2) {
			const CentredPoint next = centreAt(shape, point.x + part * step.x);
			if (!(next.objective <= point.objective - tolerances::wallDescent * part * step.decrement + blur)) continue;
			point = next;
			return true;
		}
		return false;
	}

	// The last step, so short that the gauge's parabola tells what is at its end.
	void follow(const Shape& shape, CentredPoint& point, const Vector3& step)
	{
		const Vector3 bend = point.gauge.hessian * step;
		point.gauge.value += step.dot(point.gauge.gradient + 0.5 * bend);
		point.gauge.gradient += bend;
		point.x += step;
		complete(shape, point);
	}

	template <class NewtonStep> CentredPoint minimise(const Shape& shape, const Vector3& start, const NewtonStep& newtonStep, SolverCounters& counters)
	{
		CentredPoint point = centreAt(shape, start);
		if (!point.within()) return point;
		for (int i = 0; i < tolerances::newtonIterations; ++i) {
			const Step step = newtonStep(point);
			if (step.decrement <= tolerances::lastWallDecrement) {
				follow(shape, point, step.x);
				return point;
			}
			++counters.iterations;
			if (!descend(shape, point, step)) break;
		}
		++counters.fallbacks;
		return point;
	}

} // namespace

CentredPoint centreOnPlane(const Shape& shape, const Vector3& start, const Vector3& normal, SolverCounters& counters)
{
	const Vector3& halfSizes = shape.halfSizes();
	const Vector3 across = normal.cwiseProduct(halfSizes).normalized(), unit1 = across.unitOrthogonal(), unit2 = across.cross(unit1);
	const Vector3 along1 = unit1.cwiseProduct(halfSizes), along2 = unit2.cwiseProduct(halfSizes);
	return minimise(shape, start, [&](const CentredPoint& p) { return stepAcross(p, along1, along2); }, counters);
}

CentredPoint centreOnLine(const Shape& shape, const Vector3& start, const Vector3& direction, SolverCounters& counters)
{
	const Vector3 along = direction / direction.cwiseQuotient(shape.halfSizes()).norm();
	return minimise(shape, start, [&](const CentredPoint& p) { return stepAlong(p, along); }, counters);
}

namespace {

	struct SurfacePoint {
		Vector3 x;
		double distance; // along the ray [m]
		GaugeValue gauge;
	};

	// Where the ray leaves the body: the start is the root of the gauge's parabola, then Newton. The gauge is convex along the ray, so that
	// its iterates come down from outside.
	SurfacePoint surfaceAlong(const Shape& shape, const CentredPoint& from, const Vector3& direction)
	{
		const double last = tolerances::surfaceStep * shape.smallestHalfSize();
		const double slope = from.gauge.gradient.dot(direction), bend = direction.dot(from.gauge.hessian * direction);
		SurfacePoint surface;
		// At the centre the gauge has a corner and no slope; any point outside serves as the start.
		surface.distance = slope > 0 ? 2 * from.depth / (slope + std::sqrt(slope * slope + 2 * bend * from.depth)) : 2 * shape.boundingRadius();
		for (int i = 0; i < tolerances::surfaceIterations; ++i) {
			surface.x = from.x + surface.distance * direction;
			surface.gauge = shape.gaugeWithHessian(surface.x);
			const double step = (1 - surface.gauge.value) / surface.gauge.gradient.dot(direction);
			surface.distance += step;
			if (std::abs(step) <= last) break;
		}
		return surface;
	}

} // namespace

Contact contactAtCentre(const Placement& body, const CentredPoint& centre, const Vector3& outwards)
{
	const SurfacePoint surface = surfaceAlong(body.shape, centre, body.toBody(outwards));
	Contact contact;
	contact.status = Status::Overlap;
	contact.upper = centre.gauge.value;
	contact.normal = outwards;
	contact.overlap = surface.distance;
	contact.surface2 = contact.point = body.position + body.toWorld(centre.x);
	contact.surface1 = contact.surface2 + surface.distance * outwards;
	contact.curvature1 = meanCurvature(surface.gauge) * surface.gauge.value;
	return contact;
}

} // namespace superquadric
