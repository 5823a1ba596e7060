#include "SuperquadricGeomFunctor.hpp"

namespace yade {

YADE_PLUGIN((SuperquadricGeomFunctor));

superquadric::WarmStart ContactPair::warmStart() const
{
	return interaction->geom ? YADE_CAST<SuperquadricGeom*>(interaction->geom.get())->warm : superquadric::WarmStart();
}

SuperquadricGeom& ContactPair::geom() const
{
	if (!interaction->geom) interaction->geom = shared_ptr<SuperquadricGeom>(new SuperquadricGeom);
	return *YADE_CAST<SuperquadricGeom*>(interaction->geom.get());
}

bool ContactPair::touch(const superquadric::Contact& contact, const SuperquadricGeom::Side& side1, const SuperquadricGeom::Side& side2,
        const superquadric::WarmStart& warm) const
{
	// A parked geom has no history of shear: without phys the contact is new.
	const bool isNew = !interaction->isReal();
	// A wall has no radius of its own; YADE's functors give it the particle's.
	const Real radius1 = side1.smallestHalfSize > 0 ? side1.smallestHalfSize : side2.smallestHalfSize;
	const Real radius2 = side2.smallestHalfSize > 0 ? side2.smallestHalfSize : side1.smallestHalfSize;
	SuperquadricGeom& g = geom();
	const Vector3r normalBefore = isNew ? contact.normal : g.normal;
	const Vector3r shiftVelocity = scene->isPeriodic ? scene->cell->intrShiftVel(interaction->cellDist) : Vector3r(Vector3r::Zero());
	// For YADE's own laws, what only ScGeom::rotate reads; without YADE's correction against ratcheting, which holds for spheres only.
	g.doIg2Work(contact.middle(), contact.overlap, radius1, radius2, state1, state2, scene, interaction, contact.normal, shift2, isNew, false);
	g.warm = warm;
	g.touch(contact, side1, side2, normalBefore, Motion(state1), Motion(state2, shift2, shiftVelocity), scene->dt);
	return true;
}

bool ContactPair::part(const superquadric::Contact& contact, const superquadric::WarmStart& warm) const
{
	const bool keep = mustBeKept();
	if (!keep && !interaction->geom && warm.kind == superquadric::WarmStart::None) return false; // nothing to remember
	SuperquadricGeom& g = geom();
	g.warm = warm;
	g.part(contact);
	return keep;
}

SuperquadricGeom::Side sideOf(const superquadric::Placement& body, const Vector3r& surface, const Vector3r& normal, Real curvature)
{
	const Real halfThickness = std::abs((surface - body.position).dot(normal));
	return { curvature, std::sqrt(body.shape.halfSizes().prod() / halfThickness), body.shape.smallestHalfSize() };
}

bool SuperquadricGeomFunctor::solve(const Shape&, const Shape&, const ContactPair&)
{
	throw std::logic_error(getClassName() + " does not say how its two shapes touch");
}

} // namespace yade
