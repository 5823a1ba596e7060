// The contact force of Wang & Ji, Acta Phys. Sin. 67, 094501 (2018), eqs. (6)-(9) and (11)-(14): Hertz's normal force with
// a viscous part, Mindlin's tangential force with slip, a rolling couple, and the critical time step.
// Where the paper is silent the choice is stated at the function. SI units everywhere.
#pragma once

#include <pkg/geometry/Types.hpp>

namespace superquadric::hertzMindlin {

// Largest overlap that the law is meant for by default, as a part of the smallest half size [-]; see boundedCurvature.
constexpr double defaultOverlapLimit = 0.1;

// Effective modulus E* [Pa], 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, which is the paper's E/(2(1 - nu^2)) for equal materials.
double effectiveModulus(double young1, double poisson1, double young2, double poisson2);

// Ratio of Hertz's normal to Mindlin's tangential stiffness, E*/(4G*) with 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2 [-]. For equal
// materials it is the factor (2 - nu)/(2(1 - nu)) of the paper's largest tangential displacement dtmax.
double stiffnessRatio(double young1, double poisson1, double young2, double poisson2);

// One side of a contact as far as its local radius is concerned. A wall has zeros.
struct Side {
	double curvature; // mean curvature at the contact [1/m]
	double sectionRadius; // radius of the body's section across the normal [m]
	double smallestHalfSize; // [m]
};

// The paper sets no bounds to R = 1/curvature, which grows without limit on a face and vanishes at an edge. With the
// largest overlap that the model is meant for, dmax = overlapLimit * smallestHalfSize:
//   R >= dmax: Hertz's theory needs an overlap below the radius;
//   R <= sectionRadius^2/dmax: at that overlap the disc of contact, of radius sqrt(R dmax), must not be wider than the
//   section that carries it.
// A wall stays as it is. [1/m]
double boundedCurvature(const Side& side, double overlapLimit);

// What the normal force (equations (6)-(8)) depends on.
struct Pair {
	double modulus; // E* [Pa]
	double radius; // R* [m]
	double mass; // effective mass m* along the normal [kg]

	double hertz() const; // Hertz's stiffness Kn [N/m^1.5]
};

struct NormalForce {
	double elastic = 0, viscous = 0; // both positive when they push the bodies apart [N]
	double stiffness = 0; // tangent of the elastic part [N/m]

	double total() const { return elastic + viscous; }
};

// The normal force (equations (6)-(8)) at an overlap > 0 and a speed of approach (positive when the overlap grows) [m/s]. The viscous part never
// makes
// the whole attractive: it is cut where the sum is zero. The paper does not say so, but only with this cut is the
// restitution what it prints (0.85 for damping 0.05; 0.820 for 0.06 and 0.725 for 0.1).
NormalForce normalForce(const Pair& pair, double damping, double overlap, double approachSpeed);

// 2/5 Kn d^(5/2) [J].
double normalEnergy(double hertz, double overlap);

// What the tangential force (equations (11), (12)) depends on.
struct Friction {
	double coefficient; // mu
	double stiffnessRatio; // see above
	double damping; // Ct
	double mass; // m* [kg]
};

struct TangentialForce {
	Vector3 displacement = Vector3::Zero(); // the history that remains, no longer than dtmax [m]
	Vector3 elastic = Vector3::Zero(), viscous = Vector3::Zero(); // on body 2 [N]
	double slip = 0; // by how much the history was shortened [m]
	double energy = 0; // stored: the integral of the elastic tangential force over the displacement [J]

	Vector3 total() const { return elastic + viscous; }
};

// The tangential force (equations (11), (12)). `displacement` is the tangential displacement of body 2 relative to body 1 at the contact since
// it began,
// `velocity` its rate; `normalForce` is Kn d^(3/2) > 0, `overlap` > 0. What exceeds dtmax slips and is forgotten, also when
// dtmax shrinks with the overlap. In equation (12) the misprinted bracket is read as sqrt(1 - dt/dtmax). Mohr-Coulomb's limit
// mu Kn d^(3/2) holds for the sum: the viscous part is scaled down to it.
TangentialForce tangentialForce(
        const Friction& friction, double normalForce, double overlap, const Vector3& displacement, const Vector3& velocity);

// Rolling friction (equation (13)): the couple on body 2 against its spin relative to body 1, of magnitude coefficient * radius * |normalForce|
// [N m]. It
// is never larger than what stops the relative spin within one step, `effectiveInertia` * |spin| / `step`, so that
// it cannot reverse the rotation.
Vector3 rollingCouple(double coefficient, double radius, double normalForce, const Vector3& spin, double effectiveInertia, double step);

// Critical (Rayleigh) time step tmax (equation (14)) [s] for the smallest half size [m]; steps of at most 0.1 tmax are advised.
double criticalTimeStep(double smallestHalfSize, double young, double poisson, double density);

} // namespace superquadric::hertzMindlin
