// Mean curvature of a level surface (Wang & Ji, equation (10)) with the sign that makes it +1/R on a sphere of radius R.
#pragma once

#include "Shape.hpp"

#include <algorithm>
#include <cmath>

namespace superquadric {

// Of the level surface of the gauge through the point where `jet` was taken [1/m]: half the trace of the Hessian across the
// normal over the slope.
inline double meanCurvature(const GaugeJet& jet, const Vector3& inverseHalfSizes)
{
	const Vector3 squares = inverseHalfSizes.cwiseAbs2(), dual = jet.gradient.cwiseProduct(squares);
	const double slopeSquared = jet.gradient.dot(dual);
	const double trace = Vector3(jet.h11, jet.h22, jet.h33).dot(squares) - jet.rank * slopeSquared;
	// A convex body's is not negative; where it vanishes, at the middle of a face, rounding makes it so.
	return std::max((slopeSquared * trace - jet.form(dual)) / (2 * slopeSquared * std::sqrt(slopeSquared)), 0.0);
}

// Of the body's surface on the ray from its centre through `bodyPoint` (not the centre) [1/m].
double meanCurvature(const Shape& shape, const Vector3& bodyPoint);

} // namespace superquadric
