// Two bodies at a contact, and how they move relative to each other: what the laws on the local curvature start from.
#pragma once

#include <pkg/support/MovingBody.hpp>

#include <pkg/dem/ScGeom.hpp>
#include <pkg/mechanics/HertzMindlin.hpp>

namespace yade {

class SuperquadricGeom;

struct ContactKinematics {
	using Side = superquadric::hertzMindlin::Side;
	struct Radii {
		Real effective; // R*, 1/R* = 1/R1 + 1/R2 [m]
		Real smaller; // of R1 and R2 [m]
	};

	const MovingBody &body1, &body2;
	Side side1, side2;
	const ScGeom& geom;
	const SuperquadricGeom* superquadricGeom; // the same geometry, if a superquadric takes part
	Real overlap; // that the law counts: the geometry's, less what is at rest (CurvaturePhys::restOverlap) [m]
	Real approach; // speed at which the overlap grows [m/s]
	Vector3r velocity, sliding; // of body 2 relative to body 1 at the contact, all of it and its tangential part [m/s]
	Vector3r spin; // the same, angular [rad/s]
	// What this process books of the contact's energy: half where another process computes the same contact, across a border of MPI's domains.
	Real share = 1;

	// With a superquadric.
	ContactKinematics(const MovingBody& one, const MovingBody& two, const SuperquadricGeom& geom);
	// Of spheres under YADE's geometry, with the sides of flatOrSphere; its contact point is the middle of the overlap already.
	ContactKinematics(const MovingBody& one, const MovingBody& two, const Side& side1, const Side& side2, const ScGeom& geom);

	// A tangential vector of the last step, turned with the contact; its length stays.
	Vector3r turned(Vector3r vector) const;
	// With the curvature of each side within its bounds (HertzMindlin.hpp).
	Radii radii(Real overlapLimit) const;
	// What the bodies together set against a push at the contact: along the normal, with lever arms, and of their masses alone. 0 where nothing
	// can move [kg].
	Real normalMass() const;
	Real mass() const;

	// One side under YADE's geometry: a sphere; anything else is flat.
	static Side flatOrSphere(const Body& body);
	// YADE's functors put the contact point of a sphere and a wall onto the wall; ours, like that of two spheres, is the middle of
	// the overlap, so that spheres and round superquadrics have the same lever arms. The size of a flat side is 0.
	static Vector3r middleOfOverlap(
	        const ScGeom& geom, const Side& side1, const Vector3r& position1, const Side& side2, const Vector3r& position2);

private:
	void findMotion();
};

} // namespace yade
