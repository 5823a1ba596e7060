// Vector types of the mathematics, the same memory layout as YADE's Vector3r and Matrix3r.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace superquadric {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

constexpr double pi = 3.14159265358979323846;

} // namespace superquadric
