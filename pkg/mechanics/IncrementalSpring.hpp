// A spring of changing stiffness that slips at a changing limit, for what a contact does beside its normal force: the tangential force, and
// the couple against rolling and twisting. What is remembered is the force, not the displacement. Units: N, N/m and m, or N m, N m/rad and rad.
#pragma once

#include <pkg/geometry/Types.hpp>

namespace superquadric {

struct Spring {
	Vector3 force = Vector3::Zero(); // on body 2
	double stiffness = 0; // zero only together with the force

	Vector3 stretch() const; // of body 2 relative to body 1, against the force
	double energy() const; // F^2/(2k) [J]
};

struct SpringStep {
	Spring spring; // after the step
	bool slips = false;
	double slipWork = 0; // dissipated by slip [J], never negative
	double softening = 0; // dissipated because the stiffness changed [J], never negative
};

// One step: the stiffness becomes `stiffness`, body 2 moves by `displacement`, and what then exceeds `limit` slips.
//   Stiffness that grows leaves the force as it is (Mindlin & Deresiewicz 1953: what comes into contact later carries no shear yet);
//   stiffness that falls takes the force with it, F k/k_old (Thornton, Cummins & Cleary, Powder Technol. 233, 30 (2013)): a force that
//   stayed would be worth more energy than was put in.
// So either way energy F^2/(2k) is lost, never won: micro-slip at the rim of the disc of contact. Where stiffness or limit end, so does
// the force.
//
// The work of the mean force before and after, which is what the leap-frog integrator does, is the growth of the energy plus both
// losses but for (k_old - k)/4 times the square of the growth of the stretch where the stiffness falls (third order in the step: the loss is
// taken at the mean of the squares, so that it cannot be negative), and for a force that slip reverses within one step.
SpringStep follow(const Spring& before, double stiffness, double limit, const Vector3& displacement);

// What a dashpot sets against a velocity: -2 ratio sqrt(m k) v, with ratio = 1 critical for a mass m on a spring k.
Vector3 dashpot(double ratio, double mass, double stiffness, const Vector3& velocity);

// k_r [N m/rad] of type C in Ai, Chen, Rotter & Ooi, Powder Technol. 206, 269 (2011), in three dimensions: 2.25 kn (mu_r R_r)^2, with
// 1/R_r = 1/R1 + 1/R2.
double rollingStiffness(double normalStiffness, double coefficient, double radius);

// The inverse of a body's moment of inertia [1/(kg m^2)] about a contact at `distance` [m] from its centre, I + m r^2; of both bodies they
// add up. Zero for a body that cannot be moved or turned (its inverses are zero).
double inverseRollingInertia(double inverseMass, double inverseInertia, double distance);

} // namespace superquadric
