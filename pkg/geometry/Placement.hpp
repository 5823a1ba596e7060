// A body in space: a shape with a position and a rotation.
#pragma once

#include "Shape.hpp"

namespace superquadric {

// What the solvers need of a body at one point of space.
struct BodyPoint {
	Vector3 local; // from the centre, in half sizes along the body's axes
	GaugeJet jet; // there, in the same coordinates
	Vector3 gradient; // of the gauge, in space [1/m]
};

struct Placement {
	Placement(const Shape& shape, const Vector3& position, const Matrix3& rotation)
	        : shape(shape)
	        , position(position)
	        , rotation(rotation)
	        , frame(rotation * shape.inverseHalfSizes().asDiagonal())
	{
	}

	const Shape& shape;
	Vector3 position; // [m]
	// Constant, because it and the frame belong together: a body that turns gets a new placement.
	const Matrix3 rotation; // body frame to world
	// The body's axes over its half sizes [1/m]: its transpose takes a world vector to the coordinates that count half sizes, itself it
	// takes a gradient in those to the world.
	const Matrix3 frame;

	Vector3 toBody(const Vector3& worldDirection) const { return rotation.transpose() * worldDirection; }
	Vector3 toWorld(const Vector3& bodyDirection) const { return rotation * bodyDirection; }
	Vector3 toHalfSizes(const Vector3& world) const { return frame.transpose() * world; }

	BodyPoint at(const Vector3& fromCentre) const
	{
		BodyPoint result;
		result.local = toHalfSizes(fromCentre);
		result.jet = shape.jet(result.local);
		result.gradient = frame * result.jet.gradient;
		return result;
	}

	// The same quantities as Shape's, for a world vector from the body's centre.
	double gauge(const Vector3& fromCentre) const { return shape.gauge(toBody(fromCentre)); }
	double support(const Vector3& direction) const { return shape.support(toBody(direction)); }
	Vector3 supportPoint(const Vector3& direction) const { return toWorld(shape.supportPoint(toBody(direction))); }
};

} // namespace superquadric
