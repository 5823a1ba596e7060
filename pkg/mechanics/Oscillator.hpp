// A rigid body on springs and dashpots along the axes of space, driven by a harmonic force: one step of the leap-frog, whose velocities
// belong to the middle of the steps. SI units everywhere.
#pragma once

#include <pkg/geometry/Types.hpp>

namespace superquadric::oscillator {

// A sin(2 pi f t + phase) [N].
Vector3 harmonicForce(const Vector3& amplitude, double frequency, double phase, double time);

// v(n+1/2) from v(n-1/2), of m (v(n+1/2) - v(n-1/2))/dt = F(n) - c v(n): the dashpots c feel the mean of both velocities, which makes the step of
// second order and stable for any c. `force` is all the rest.
Vector3 nextVelocity(double mass, const Vector3& damping, const Vector3& force, const Vector3& velocity, double step);

// The dashpots' force of that step [N].
Vector3 dashpotForce(const Vector3& damping, const Vector3& before, const Vector3& after);

// m v(n-1/2) v(n+1/2)/2 [J]. With this as the kinetic energy at a whole step, and the work of a force over the step counted as the
// way times the mean of the force before and after, the leap-frog conserves energy to rounding on a linear spring: the products telescope.
double kineticEnergy(double mass, const Vector3& before, const Vector3& after);

// Of springs with the stiffnesses along the axes [J].
double springEnergy(const Vector3& stiffness, const Vector3& displacement);

} // namespace superquadric::oscillator
