// The point where a ray leaves a body.
#pragma once

#include <pkg/geometry/Curvature.hpp>
#include <pkg/geometry/Placement.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <cmath>

namespace superquadric {

struct SurfacePoint {
	double distance; // along the ray [m]
	double curvature; // mean curvature of the surface there [1/m]
};

// Distance along the unit vector `direction` from a point in or near the body to the surface [m]; negative when the point lies
// outside. The gauge must grow along the direction.
SurfacePoint surfaceAlong(const Placement& body, const BodyPoint& from, const Vector3& direction, double start);
// Where to start.
double firstGuess(const Placement& body, const BodyPoint& from, const Vector3& direction);

// Newton on gauge = 1. The gauge is convex along the ray: after the first step the iterates
// come down from outside without passing the root. They converge quadratically, so a step below the square root of
// rounding is the last that matters.
inline SurfacePoint surfaceAlong(const Placement& body, const BodyPoint& from, const Vector3& direction, double start)
{
	const double last = tolerances::surfaceStep * body.shape.smallestHalfSize();
	const Vector3 along = body.toHalfSizes(direction);
	SurfacePoint result;
	result.distance = start;
	GaugeJet jet = from.jet;
	for (int i = 0; i < tolerances::surfaceIterations; ++i) {
		jet = body.shape.jet(from.local + result.distance * along);
		const double step = (1 - jet.value) / jet.gradient.dot(along);
		result.distance += step;
		if (!(std::abs(step) > last)) break;
	}
	result.curvature = meanCurvature(jet, body.shape.inverseHalfSizes());
	return result;
}

// The root of the gauge's second-order model along a direction.
inline double firstGuess(const Placement& body, const BodyPoint& from, const Vector3& direction)
{
	const Vector3 along = body.toHalfSizes(direction);
	const double slope = from.jet.gradient.dot(along), missing = 1 - from.jet.value;
	const double root = slope * slope + 2 * missing * from.jet.form(along);
	// At the centre the gauge has a corner and no slope; any point outside serves as the start.
	return slope > 0 && root > 0 ? 2 * missing / (slope + std::sqrt(root)) : 2 * body.shape.boundingRadius();
}

} // namespace superquadric
