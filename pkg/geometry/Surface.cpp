#include "Surface.hpp"

#include "Tolerances.hpp"

namespace superquadric {

// Newton on gauge = 1. The gauge is convex along the ray: after the first step the iterates come down from outside without
// passing the root, so the search ends when a step no longer goes inwards.
double distanceToSurface(const Placement& body, const Vector3& fromCentre, const Vector3& direction)
{
	const Vector3 start = body.toBody(fromCentre), along = body.toBody(direction);
	const double rounding = tolerances::surfaceStep * body.shape.smallestHalfSize();
	double distance = 0;
	for (int i = 0; i < tolerances::surfaceIterations; ++i) {
		const GaugeValue g = body.shape.gaugeWithGradient(start + distance * along);
		const double slope = g.gradient.dot(along);
		if (!(slope > 0)) {
			// At the centre the gauge has a corner; any point outside serves as a new start.
			distance += 2 * body.shape.boundingRadius();
			continue;
		}
		const double step = (1 - g.value) / slope;
		distance += step;
		if (std::abs(step) <= rounding || (i > 0 && step > 0)) break;
	}
	return distance;
}

} // namespace superquadric
