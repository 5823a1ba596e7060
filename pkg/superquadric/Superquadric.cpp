#include "Superquadric.hpp"

#include <pkg/support/Buffers.hpp>
#include <pkg/support/Checks.hpp>

#include <pkg/geometry/Bounds.hpp>
#include <pkg/geometry/Curvature.hpp>
#include <pkg/geometry/MassProperties.hpp>
#include <pkg/geometry/Tessellation.hpp>

namespace yade {

YADE_PLUGIN((Superquadric));

void Superquadric::postLoad(Superquadric&)
{
	accepted.accept({ &extents, &n1, &n2 }, [this] { valid = superquadric::Shape(extents, n1, n2); });
}

void Superquadric::setExtents(const Vector3r& value)
{
	extents = value;
	callPostLoad();
}

Real Superquadric::volume() const { return superquadric::volume(valid); }

Vector3r Superquadric::inertia(Real density) const
{
	requirePositive("density", density);
	return density * superquadric::inertiaOfUnitDensity(valid);
}

Real Superquadric::function(const Vector3r& point) const
{
	requireFinite("point", point);
	return valid.function(point);
}

Real Superquadric::gauge(const Vector3r& point) const
{
	requireFinite("point", point);
	return valid.gauge(point);
}

Real Superquadric::support(const Vector3r& direction) const
{
	requireFinite("direction", direction);
	return valid.support(direction);
}

Vector3r Superquadric::supportPoint(const Vector3r& direction) const
{
	requireNonZero("direction", direction);
	return valid.supportPoint(direction);
}

Real Superquadric::meanCurvature(const Vector3r& point) const
{
	requireNonZero("point", point);
	return superquadric::meanCurvature(valid, point);
}

Vector3r Superquadric::boxHalfExtents(const Quaternionr& orientation) const
{
	requirePositive("the norm of orientation", orientation.norm());
	return superquadric::boxHalfExtents(valid, orientation.normalized().toRotationMatrix());
}

boost::python::tuple Superquadric::tessellation(Real error) const
{
	const superquadric::Tessellation mesh = superquadric::tessellate(valid, error);
	return boost::python::make_tuple(bytesOf(mesh.points), bytesOf(mesh.normals), bytesOf(mesh.triangles), mesh.error);
}

} // namespace yade
