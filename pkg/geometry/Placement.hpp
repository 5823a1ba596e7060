// A body in space: a shape with a position and a rotation.
#pragma once

#include "Shape.hpp"

namespace superquadric {

struct Placement {
	const Shape& shape;
	Vector3 position; // [m]
	Matrix3 rotation; // body frame to world

	Vector3 toBody(const Vector3& worldDirection) const { return rotation.transpose() * worldDirection; }
	Vector3 toWorld(const Vector3& bodyDirection) const { return rotation * bodyDirection; }

	// The same quantities as Shape's, for a world vector from the body's centre.
	double gauge(const Vector3& fromCentre) const { return shape.gauge(toBody(fromCentre)); }
	GaugeValue gaugeWithHessian(const Vector3& fromCentre) const;
	GaugeValue gaugeWithGradient(const Vector3& fromCentre) const;
	double support(const Vector3& direction) const { return shape.support(toBody(direction)); }
	Vector3 supportPoint(const Vector3& direction) const { return toWorld(shape.supportPoint(toBody(direction))); }
};

} // namespace superquadric
