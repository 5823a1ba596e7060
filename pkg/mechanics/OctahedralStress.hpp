// The stress of a particle in one number.
#pragma once

#include <pkg/geometry/Types.hpp>

#include <cmath>

namespace superquadric {

// Octahedral shear stress, sqrt((s1 - s2)^2 + (s2 - s3)^2 + (s3 - s1)^2)/3, of a stress that need not be symmetric: of its symmetric part (McDowell &
// de Bono, Geotechnique 63, 895 (2013)). It is the norm of the deviator over the square root of 3.
inline double octahedralShearStress(const Matrix3& stress)
{
	const Matrix3 symmetric = (stress + stress.transpose()) / 2;
	const Matrix3 deviator = symmetric - symmetric.trace() / 3 * Matrix3::Identity();
	return deviator.norm() / std::sqrt(3.);
}

} // namespace superquadric
