// The elastoplastic normal contact of Li, Gao, Zhang & Liu, J. Northeastern Univ. Nat. Sci. 39, 1211 (2018), eqs. (1)-(11): four
// paths, elastic (1), plastic loading (2), unloading and reloading (3), further plastic loading (4).
// The equations are rebuilt from its text and Johnson, Contact Mechanics (docs/notation.md). What was chosen
// thereby is stated at the function. SI units everywhere.
#pragma once

#include <pkg/geometry/Types.hpp>

#include <limits>

namespace superquadric::elastoplastic {

// The fit to finite elements (their equations (1) and (2)): fp/fy = G(R/R0) ((a - ay)/ay)^H with G(r) = m0 + m1 r + m2 r^2. Outside the radii
// that were fitted a parabola means nothing; there G keeps its value at the nearer end. (Without a length in the material G cannot
// depend on R at all: fy goes as R^2 and ay as R.)
struct Hardening {
	double referenceRadius = 2.5e-3; // R0 [m]
	double m0 = 0, m1 = 0, m2 = 0; // [-]
	double exponent = 0; // H [-]
	double smallestRatio = 1, largestRatio = 4; // R/R0 of the fit; the paper's five cases

	double factor(double radius) const; // G at the effective radius R [m]
};

struct Material {
	double yieldStress = std::numeric_limits<double>::infinity(); // [Pa]; infinite for a material that never yields
	Hardening hardening {}; // not looked at where nothing yields

	bool yields() const { return yieldStress < std::numeric_limits<double>::infinity(); }
};

// Throws std::invalid_argument with name and value of what is wrong. G must be positive at all radii of the fit, so that the
// force grows, and 0 < H < 3: from 3 on the plastic contact would end up stiffer than Hertz's.
void check(const Material& material);

// Which of two materials makes the contact yield: the one with the smaller yield stress, as both feel the same pressure. All of the
// plastic deformation is taken to be its own. The order of the two does not matter.
const Material& softer(const Material& one, const Material& other);

// p_y over sigma_y: by Mises and for Poisson's ratio 0.3, Johnson, Contact Mechanics, section 6.1.
constexpr double pressureAtYield = 1.6;

// Onset of yield (their equations (5)-(7)), with the mean modulus E* and the effective radius R of the contact.
struct YieldPoint {
	double pressure; // p_y [Pa]
	double force, overlap, contactRadius; // fy [N], dy [m], ay [m]
};

YieldPoint yieldPoint(double yieldStress, double modulus, double radius);

// What the law needs to know of a pair.
struct Pair {
	Material material; // checked; the softer one's
	double modulus; // E* [Pa]
	double radius; // R [m]
};

// Paths 1, 2 and 4: the force while the overlap is larger than ever before. Below dy it is Hertz's; beyond, the plastic one (their equation (10)):
//     fN = fy + fy G ((a - ay)/ay)^H,   a = sqrt(R d).
// Unloading (path 3) is Hertz's with the disc of contact that loading has left behind: a^2 = R dmax = R' (dmax - dR), where
// R' >= R is the radius of the flattened contact. It meets the plastic curve at dmax, hence
//     dmax - dR = 3 f/(4 E* a).
// With the original R in the place of R' the disc would shrink suddenly on unloading, and the restitution would go as v^(-1/6) in the
// plastic limit instead of Johnson's v^(-1/4).
//
// Where the plastic curve is so steep that dR would shrink, below zero even where it lies above Hertz, loading would set energy free. No contact
// can; there dR stays as it is (zero: Hertz) until that curve has fallen back far enough. It happens on one stretch of overlaps at most.
class LoadingCurve {
public:
	explicit LoadingCurve(const Pair& pair);

	// All at an overlap d >= 0.
	double force(double overlap) const; // [N]
	double slope(double overlap) const; // of the force [N/m]
	double energy(double overlap) const; // work from 0 to d, in closed form [J]
	double residual(double overlap) const; // dR after unloading from d; it grows with d [m]

private:
	// Numbers from here on are in units of dy and fy.
	struct Pause { // the stretch where dR stays, in terms of w = sqrt(d/dy) - 1
		double begin = std::numeric_limits<double>::infinity();
		double end = std::numeric_limits<double>::infinity();
		double residual = 0;
	};

	double excess(double overlap) const; // w
	bool pauses(double w) const;
	double fittedForce(double w) const;
	double fittedEnergy(double w) const;
	double fittedResidual(double w) const;
	double pauseEnergy(double w) const;
	Pause findPause() const;

	double hertz_; // 4/3 E* sqrt(R) [N/m^1.5]
	YieldPoint yield_;
	double factor_, exponent_; // G and H
	Pause pause_;
};

// What a contact remembers, from its first touch until the bodies part; a new collision starts with History{}. E* and R are those of the
// first touch: if the hardened contact followed a changing R, it would give energy whenever R grows (history kept as overlaps) or
// shrinks (kept as forces). As long as it has not yielded (dR = 0), History{} may be put in its place to follow the curvature
// as Hertz's law does elsewhere.
struct History {
	double modulus = 0, radius = 0; // E* [Pa] and R [m] at the first touch, 0 before
	double largest = 0; // dmax [m]
	double residual = 0; // dR [m]
	double dissipated = 0; // plastic work so far (their equation (11)) [J]
};

struct State {
	double force = 0; // [N], never attractive; zero at overlaps up to dR
	double stiffness = 0; // tangent [N/m]; while the contact flows that of the loading curve, which is zero at dy for H > 1
	double unloadingStiffness = 0; // tangent of path 3 [N/m], never smaller: the one that bounds the time step
	double elastic = 0; // what unloading gives back [J]
	bool flows = false; // the contact has just yielded further: paths 2 and 4
	History history;

	double work() const { return elastic + history.dissipated; } // done on the contact [J]
};

// The contact at an overlap [m], coming from `history` by any path that is not deeper than the deeper of both ends. E* and R
// of `pair` count at the first touch only. An overlap that is not positive leaves the history as it is.
State normalForce(const Pair& pair, const History& history, double overlap);

// The viscous part [N], of the form in HertzMindlin.hpp, Cn sqrt(4 m* k) v with the stiffness k of the unloading branch and the speed of
// approach v: on paths 1 and 3 only, and never attractive together with the force. With k = 2 E* sqrt(R d) of path 1 it is that one.
double viscousForce(const State& state, double damping, double mass, double approachSpeed);

} // namespace superquadric::elastoplastic
