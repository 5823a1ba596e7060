#include "Bounds.hpp"

#include "Tolerances.hpp"

namespace superquadric {

Vector3 boxHalfExtents(const Shape& shape, const Matrix3& rotation)
{
	Vector3 result;
	for (int axis = 0; axis < 3; ++axis)
		result[axis] = shape.support(rotation.row(axis));
	return result;
}

bool boundingSpheresApart(const Shape& shape1, const Shape& shape2, const Vector3& between)
{
	const double radii = shape1.boundingRadius() + shape2.boundingRadius();
	return between.squaredNorm() > radii * radii;
}

namespace {

	// Half width of the body's oriented box along a direction given in the body's frame.
	double boxWidth(const Shape& shape, const Vector3& bodyDirection) { return bodyDirection.cwiseAbs().dot(shape.halfSizes()); }

} // namespace

bool orientedBoxesApart(const Placement& body1, const Placement& body2, const Vector3& between, Vector3& direction)
{
	const auto separates = [&](const Vector3& axis) {
		const double distance = between.dot(axis);
		// Said so that NaN separates nothing.
		if (!(std::abs(distance) > boxWidth(body1.shape, body1.toBody(axis)) + boxWidth(body2.shape, body2.toBody(axis)))) return false;
		direction = distance > 0 ? axis : Vector3(-axis);
		return true;
	};
	for (int i = 0; i < 3; ++i)
		if (separates(body1.rotation.col(i)) || separates(body2.rotation.col(i))) return true;
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j) {
			const Vector3 axis = body1.rotation.col(i).cross(body2.rotation.col(j));
			const double length = axis.norm();
			if (length > tolerances::parallelEdges && separates(axis / length)) return true;
		}
	return false;
}

} // namespace superquadric
