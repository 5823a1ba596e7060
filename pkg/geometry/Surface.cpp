#include "Surface.hpp"

#include "Tolerances.hpp"

namespace superquadric {

// Newton on gauge = 1. The gauge is convex along the ray: after the first step the iterates come down from outside without
// passing the root. They converge quadratically, so a step below the square root of rounding is the last that matters.
double distanceToSurface(const Placement& body, const Vector3& fromCentre, const Vector3& direction, const GaugeValue& gauge)
{
	const double last = tolerances::surfaceStep * body.shape.smallestHalfSize();
	const double slope = gauge.gradient.dot(direction);
	// At the centre the gauge has a corner and no slope; any point outside serves as the start.
	double distance = slope > 0 ? (1 - gauge.value) / slope : 2 * body.shape.boundingRadius();
	if (slope > 0 && std::abs(distance) <= last) return distance;

	const Vector3 start = body.toBody(fromCentre), along = body.toBody(direction);
	for (int i = 0; i < tolerances::surfaceIterations; ++i) {
		const GaugeValue g = body.shape.gaugeWithGradient(start + distance * along);
		const double step = (1 - g.value) / g.gradient.dot(along);
		distance += step;
		if (!(step < -last)) break;
	}
	return distance;
}

double distanceToSurface(const Placement& body, const Vector3& fromCentre, const Vector3& direction)
{
	return distanceToSurface(body, fromCentre, direction, body.gaugeWithGradient(fromCentre));
}

} // namespace superquadric
