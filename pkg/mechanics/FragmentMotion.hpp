// Where the fragments of a particle are put and how they move, so that mass, centre of mass, momentum and angular momentum stay and no energy is
// created.
#pragma once

#include "Fragments.hpp"
#include <pkg/geometry/Shape.hpp>

namespace superquadric::fragments {

// The particle that breaks.
struct Parent {
	Shape shape;
	double mass; // [kg]
	Vector3 inertia; // along its axes [kg m^2]
	Matrix3 rotation; // from its axes to those of space
	Vector3 spin; // [rad/s]
	double deepest; // overlap of its contacts, the largest [m]
	double storedEnergy; // of its contacts, which ends with them [J]
	bool turnable; // round: its axes may be any

	double spinEnergy() const; // [J]
	Vector3 spinMomentum() const; // about its centre [kg m^2/s]
};

// The fragments, as one rigid assembly at its first moment.
struct Layout {
	Matrix3 rotation; // from the axes of the pieces to those of space
	std::vector<Vector3> offsets; // from the parent's centre, along the axes of space [m]
	Vector3 spin; // of all of them, and of the whole about the centre [rad/s]
	double spinEnergy; // [J]
	bool gains; // the energy of rotation grew by more than the contacts had stored: no arrangement was found without
};

// Moments of inertia about its centre of a shape with mass 1 [m^2]; of a sphere 2/5 r^2 without rounding.
Vector3 inertiaOfUnitMass(const Shape& shape);

// The assembly turns with the spin that its inertia and the parent's angular momentum give, which for that momentum is the motion of least energy.
// Its inertia may be too small, as balls have less of it than the blocks that they stand for: where rotation would need more energy than the parent's
// rotation and its contacts had, the axes of a round parent are drawn anew and the fragments spread outwards, and so on.
//
// A centre stays inside the parent by half the fragment's smallest half size and the overlap of the deepest contact: a fragment that is born nearer
// to a wall, or beyond, could be pressed through it. Only where rotation leaves no choice this margin is given up; the parent's surface is the limit
// then.
Layout arrange(const Pieces& pieces, const Parent& parent, CounterRandom& random);

} // namespace superquadric::fragments
