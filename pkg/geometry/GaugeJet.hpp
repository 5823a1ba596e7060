// The gauge with its first two derivatives, in coordinates that count each half size as 1: y = (x/a, y/b, z/c).
#pragma once

#include "Types.hpp"

namespace superquadric {

// The Hessian is kept as the few numbers it is made of, [h11 h12 0; h12 h22 0; 0 0 h33] - rank gradient gradient', because the shape function f
// couples
// x and y only and the root that makes the gauge of it adds the rest.
struct GaugeJet {
	double value;
	Vector3 gradient;
	double h11, h12, h22, h33, rank;

	Vector3 hessianTimes(const Vector3& v) const
	{
		return Vector3(h11 * v.x() + h12 * v.y(), h12 * v.x() + h22 * v.y(), h33 * v.z()) - rank * gradient.dot(v) * gradient;
	}
	// u . Hessian . v
	double form(const Vector3& u, const Vector3& v) const
	{
		return h11 * u.x() * v.x() + h12 * (u.x() * v.y() + u.y() * v.x()) + h22 * u.y() * v.y() + h33 * u.z() * v.z()
		        - rank * gradient.dot(u) * gradient.dot(v);
	}
	double form(const Vector3& u) const
	{
		const double along = gradient.dot(u);
		return h11 * u.x() * u.x() + 2 * h12 * u.x() * u.y() + h22 * u.y() * u.y() + h33 * u.z() * u.z() - rank * along * along;
	}
	Matrix3 hessian() const
	{
		Matrix3 block;
		block << h11, h12, 0, h12, h22, 0, 0, 0, h33;
		return block - rank * gradient * gradient.transpose();
	}
};

} // namespace superquadric
