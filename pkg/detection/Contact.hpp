// What every contact solver returns, and the contract of its signs:
//   the normal is a unit vector from body 1 to body 2; overlap = (surface1 - surface2).normal, positive when the bodies
//   penetrate. Moved along the normal by less than the overlap, body 2 still overlaps body 1; moved by the overlap, the two are
// parted at X0, and elsewhere but for a rest that vanishes in proportion to the overlap where surfaces curve. Between flat faces at a tilt the deeper
// edge may
//   stay behind by a part of the overlap (docs/accuracy.md has the figures).
// With r from centre 1 to centre 2, t* = min over x of max(g1, g2) is the common scaling at which the bodies touch: they
// overlap when t* < 1. Every verdict is proved:
//   Overlap:  `point` lies inside both bodies (its larger gauge is `upper` < 1);
//   Apart:    the plane across `normal` separates them (`lower` > 1, a bound of t* from the support functions);
//   Touching: lower <= 1 <= upper and both within the touching tolerance.
#pragma once

#include <pkg/geometry/Types.hpp>

namespace superquadric {

enum class Status {
	Apart,
	Touching,
	Overlap,
	Uncertified,
};

struct Contact {
	Status status = Status::Uncertified;
	Vector3 point = Vector3::Zero(); // X0: equally deep in both bodies; world frame [m]
	Vector3 normal = Vector3::Zero(); // unit, body 1 to body 2; the separating direction when Apart
	double overlap = 0; // [m]; of two superquadrics that are Apart, minus a proven width of the gap along the normal
	Vector3 surface1 = Vector3::Zero(), surface2 = Vector3::Zero(); // X_i and X_j [m]
	double curvature1 = 0, curvature2 = 0; // mean curvature at the surface points, 0 for a wall [1/m]
	double lower = 0, upper = 0; // bounds of t*; lower stays 0 where an overlap needs none, upper is the scaling at X0

	Vector3 middle() const { return 0.5 * (surface1 + surface2); }
	bool overlapping() const { return status == Status::Overlap; }
	// The same contact with the bodies named the other way round.
	Contact reversed() const;
};

// What a solver remembers of a pair from one step to the next.
struct WarmStart {
	enum Kind {
		None = 0,
		Point = 1,
		Direction = 2,
	};
	int kind = None;
	// The last point X0 from centre 1 [m], or the last separating direction [-]; in the frame of body 1, so that it moves with it.
	Vector3 value = Vector3::Zero();
	// The same in the frame of body 2, if known; a point from its centre.
	Vector3 seenBy2 = Vector3::Zero();
	bool inBothFrames = false;
	// Of a point: how far it had moved beyond what the bodies carried it, in the frame of body 1 [m]; it goes on like that for a while.
	Vector3 drift = Vector3::Zero();
	// Of a direction known in both frames, the sum of the supports that proved it [m], and the fingerprint of the shapes whose they are: a
	// body that has grown since is not held to it. While body 2 turns a little, its support grows by no more than its bounding
	// radius times the change of the direction.
	double supports = 0;
	long shapes = 0;
};

// Counts of a solver, for trust: nothing is resolved in silence.
struct SolverCounters {
	unsigned long solves = 0; // pairs looked at
	unsigned long stillApart = 0; // pairs not looked at, because a proven gap had not been used up yet; not among the solves
	unsigned long rejectedBySphere = 0, rejectedByDirection = 0, rejectedByBox = 0; // settled without iterating
	unsigned long coldStarts = 0; // Newton runs without a remembered point
	unsigned long iterations = 0; // of Newton, in all
	unsigned long fallbacks = 0; // Newton gave up, the ellipsoid method finished
	unsigned long uncertified = 0; // must stay 0

	SolverCounters& operator+=(const SolverCounters& other);
};

} // namespace superquadric
