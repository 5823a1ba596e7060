#include "Curvature.hpp"

namespace superquadric {

double meanCurvature(const Shape& shape, const Vector3& bodyPoint)
{
	// Level surfaces of the gauge are scaled copies of the body: the curvature scales with the gauge.
	const GaugeJet jet = shape.jet(bodyPoint.cwiseProduct(shape.inverseHalfSizes()));
	return meanCurvature(jet, shape.inverseHalfSizes()) * jet.value;
}

} // namespace superquadric
