#include "Curvature.hpp"

namespace superquadric {

double meanCurvature(const GaugeValue& gauge)
{
	const Vector3& grad = gauge.gradient;
	const Matrix3& H = gauge.hessian;
	const double square = grad.squaredNorm();
	return (square * H.trace() - grad.dot(H * grad)) / (2 * square * std::sqrt(square));
}

double meanCurvature(const Shape& shape, const Vector3& bodyPoint)
{
	// Level surfaces of the gauge are scaled copies of the body: the curvature scales with the gauge.
	const GaugeValue gauge = shape.gaugeWithHessian(bodyPoint);
	return meanCurvature(gauge) * gauge.value;
}

} // namespace superquadric
