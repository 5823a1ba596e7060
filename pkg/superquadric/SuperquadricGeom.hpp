// The geometry of a contact with a superquadric, and the pair's memory while it does not touch.
#pragma once

#include <pkg/support/MovingBody.hpp>
#include <pkg/dem/ScGeom.hpp>
#include <pkg/detection/Contact.hpp>

namespace boost::serialization {

template <class Archive> void serialize(Archive& archive, superquadric::WarmStart& warm, unsigned)
{
	archive& make_nvp("kind", warm.kind);
	archive& make_nvp("value", warm.value);
	archive& make_nvp("seenBy2", warm.seenBy2);
	archive& make_nvp("inBothFrames", warm.inBothFrames);
	archive& make_nvp("drift", warm.drift);
	archive& make_nvp("supports", warm.supports);
	archive& make_nvp("shapes", warm.shapes);
}

} // namespace boost::serialization

namespace yade {

// A pair has a SuperquadricGeom in one of two states:
//   touching: the interaction has geom and phys (it is real); penetrationDepth > 0;
//   parked:   it has this geom but no phys (not real: YADE's counts and loops skip it). The geom keeps only the solver's warm
//             start. It is saved with the scene, and goes with the interaction when the collider parts the bounding boxes.
// When a touching pair parts, the Ig2 functor returns true once more with touching = false and penetrationDepth < 0 (YADE
// objects to a functor that gives up a real contact). The law must then apply no force, drop Interaction::phys and return true:
// that parks the pair with its memory. Returning false is also right; YADE then erases the memory, and the next step pays a
// cold start.
class SuperquadricGeom : public ScGeom {
public:
	// One body at the contact. All zero for a wall, which is flat and has no size.
	struct Side {
		Real curvature = 0; // [1/m]
		Real sectionRadius = 0; // [m]
		Real smallestHalfSize = 0; // [m]
	};

	~SuperquadricGeom() override = default;

	// The bodies touch, as the solver says. `normalBefore` is the normal of the step before, that of now in a new contact.
	void touch(const superquadric::Contact& contact, const Side& side1, const Side& side2, const Vector3r& normalBefore, const Motion& motion1,
	        const Motion& motion2, Real dt);
	// A vector that lies in the contact plane, turned with the contact to first order, as ScGeom::rotate does it.
	Vector3r turned(const Vector3r& vector) const
	{
		const Vector3r swung = vector - vector.cross(turn);
		return swung - swung.cross(twist);
	}
	// The bodies do not touch.
	void part(const superquadric::Contact& contact);
	boost::python::tuple warmStartAsTuple() const;

private:
	Vector3r turn = Vector3r::Zero(), twist = Vector3r::Zero(); // of the last step [rad]

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(SuperquadricGeom, ScGeom,
		"Geometry of a contact that involves a :yref:`Superquadric` or a :yref:`HollowCylinder`. The normal points from body 1 to body 2; "
		"with the surface points X1 and X2, contactPoint = (X1+X2)/2 and penetrationDepth = (X1-X2).normal. refR1 and refR2 are the smallest "
		"half sizes (a wall takes the particle's). A pair that does not touch may keep such an object, without physics, as the memory of "
		"the contact solver.",
		((bool, touching, false, Attr::readonly, "Whether the bodies overlap: then penetrationDepth > 0, else it is negative without further "
			"meaning. |yupdate|"))
		((Real, curvature1, 0, Attr::readonly, "Mean curvature of body 1 at X1, positive, without bounds; 0 for a wall [1/m]. |yupdate|"))
		((Real, curvature2, 0, Attr::readonly, "Mean curvature of body 2 at X2, positive, without bounds; 0 for a wall [1/m]. |yupdate|"))
		((Real, sectionRadius1, 0, Attr::readonly, "Radius of body 1's middle section across the normal, sqrt(a b c/h) with its half thickness h = "
			"(X1-centre).normal; 0 for a wall [m]. |yupdate|"))
		((Real, sectionRadius2, 0, Attr::readonly, "Radius of body 2's middle section across the normal, sqrt(a b c/h) with its half thickness h = "
			"(centre-X2).normal; 0 for a wall [m]. |yupdate|"))
		((Real, smallestHalfSize1, 0, Attr::readonly, "Smallest half size of body 1; 0 for a wall [m]. |yupdate|"))
		((Real, smallestHalfSize2, 0, Attr::readonly, "Smallest half size of body 2; 0 for a wall [m]. |yupdate|"))
		((superquadric::WarmStart, warm, , Attr::hidden, "What the solver starts from in the next step."))
		, createIndex();,
		.add_property("warmStart", &SuperquadricGeom::warmStartAsTuple, "Where the contact solver starts in the next step: ('none', (0, 0, 0)); "
			"('point', the last contact point from the centre of body 1, or of the particle at a wall [m]); or ('direction', the last separating "
			"direction, a unit vector). Vectors are in the frame of that body.")
	);
	// clang-format on
	REGISTER_CLASS_INDEX(SuperquadricGeom, ScGeom);
};
REGISTER_SERIALIZABLE(SuperquadricGeom);

} // namespace yade
