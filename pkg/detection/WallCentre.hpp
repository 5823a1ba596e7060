// The contact centre on a flat wall: the point of the wall where
//   -ln(1 - g) + c e^2/2,   e^2 = sum over k of (x_k / halfSize_k)^2,   c = tolerances::centring,
// is smallest, that is the point deepest in the body (g is its gauge), drawn towards the body's middle as far as the depth
// allows. It moves continuously with the body, also where a flat face lies on the wall and every point is equally deep.
// Points and directions here count half sizes along the body's axes, from its centre: u = x / halfSizes.
#pragma once

#include "Contact.hpp"
#include <pkg/geometry/Placement.hpp>

namespace superquadric {

// The objective and its derivatives at one point.
struct CentredPoint {
	Vector3 u;
	GaugeJet jet;
	double depth; // 1 - g; the point lies in the body where it is positive
	double objective; // infinite outside the body
	Vector3 slope; // (1 - g) times the objective's gradient

	// Whether it lies so deep in the body that the depth can be told from rounding.
	bool within() const;
};

CentredPoint centreAt(const Shape& shape, const Vector3& u);

// The minimiser on the plane through `start` across `normal`; on the line through `start` along `direction`. A start that is not
// within the body is given back as it is. Damped Newton; on reaching the limit of iterations the best point is kept and counted as
// a fallback.
CentredPoint centreOnPlane(const Shape& shape, const Vector3& start, const Vector3& normal, SolverCounters& counters);
CentredPoint centreOnLine(const Shape& shape, const Vector3& start, const Vector3& direction, SolverCounters& counters);

// The contact, its verdict overlap, at a wall's point in the body, whose wall stands against the unit vector `outwards` (world frame): the
// overlap is the distance from there to the body's surface along it.
Contact contactAtCentre(const Placement& body, const CentredPoint& centre, const Vector3& outwards);

} // namespace superquadric
