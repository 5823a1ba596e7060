#include "Placement.hpp"

namespace superquadric {

GaugeValue Placement::gaugeWithHessian(const Vector3& fromCentre) const
{
	GaugeValue result = shape.gaugeWithHessian(toBody(fromCentre));
	result.gradient = toWorld(result.gradient);
	result.hessian = rotation * result.hessian * rotation.transpose();
	return result;
}

GaugeValue Placement::gaugeWithGradient(const Vector3& fromCentre) const
{
	GaugeValue result = shape.gaugeWithGradient(toBody(fromCentre));
	result.gradient = toWorld(result.gradient);
	return result;
}

} // namespace superquadric
