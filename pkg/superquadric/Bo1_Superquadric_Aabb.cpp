#include "Bo1_Superquadric_Aabb.hpp"

namespace yade {

YADE_PLUGIN((Bo1_Superquadric_Aabb));

namespace {

	// Half extents of the box of a sphere in the collider's coordinates, those of the unsheared cell: the map of space to
	// them is linear, and takes the sphere to an ellipsoid that reaches as far along an axis as that row of the map is long.
	Vector3r unshearedHalfExtents(const Cell& cell, Real radius)
	{
		Matrix3r map;
		for (int axis = 0; axis < 3; ++axis)
			map.col(axis) = cell.unshearPt(Vector3r::Unit(axis));
		return radius * map.rowwise().norm();
	}

} // namespace

void Bo1_Superquadric_Aabb::go(const shared_ptr<Shape>& shape, shared_ptr<Bound>& bound, const Se3r& se3, const Body*)
{
	if (!bound) bound = shared_ptr<Bound>(new Aabb);
	const Real radius = (aabbEnlargeFactor > 0 ? aabbEnlargeFactor : 1.) * static_cast<Superquadric*>(shape.get())->boundingRadius();
	const Vector3r half = scene->isPeriodic ? unshearedHalfExtents(*scene->cell, radius) : Vector3r::Constant(radius);
	const Vector3r centre = scene->isPeriodic ? scene->cell->unshearPt(se3.position) : se3.position;
	bound->min = centre - half;
	bound->max = centre + half;
}

} // namespace yade
