#include "ContactKinematics.hpp"

#include <pkg/common/Sphere.hpp>
#include <pkg/superquadric/SuperquadricGeom.hpp>

namespace yade {

namespace {
	Real inverseOrZero(Real value) { return value > 0 ? 1 / value : 0; }
}

ContactKinematics::ContactKinematics(const MovingBody& one, const MovingBody& two, const SuperquadricGeom& geom)
        : body1(one)
        , body2(two)
        , side1 { geom.curvature1, geom.sectionRadius1, geom.smallestHalfSize1 }
        , side2 { geom.curvature2, geom.sectionRadius2, geom.smallestHalfSize2 }
        , geom(geom)
        , superquadricGeom(&geom)
        , overlap(geom.penetrationDepth)
        , spin(two.spin - one.spin)
{
	findMotion();
}

ContactKinematics::ContactKinematics(const MovingBody& one, const MovingBody& two, const Side& side1, const Side& side2, const ScGeom& geom)
        : body1(one)
        , body2(two)
        , side1(side1)
        , side2(side2)
        , geom(geom)
        , superquadricGeom(nullptr)
        , overlap(geom.penetrationDepth)
        , spin(two.spin - one.spin)
{
	findMotion();
}

void ContactKinematics::findMotion()
{
	velocity = body2.velocityAt(geom.contactPoint) - body1.velocityAt(geom.contactPoint);
	approach = -velocity.dot(geom.normal);
	sliding = velocity + approach * geom.normal;
}

Vector3r ContactKinematics::turned(Vector3r vector) const
{
	const Real length = vector.norm();
	if (superquadricGeom)
		vector = superquadricGeom->turned(vector);
	else
		geom.rotate(vector);
	vector -= geom.normal.dot(vector) * geom.normal;
	const Real projected = vector.norm();
	return projected > 0 ? Vector3r(vector * (length / projected)) : Vector3r(Vector3r::Zero());
}

ContactKinematics::Radii ContactKinematics::radii(Real overlapLimit) const
{
	const Real curvature1 = superquadric::hertzMindlin::boundedCurvature(side1, overlapLimit);
	const Real curvature2 = superquadric::hertzMindlin::boundedCurvature(side2, overlapLimit);
	// YADE's grids and cylinders, without a sphere: only the radii that their functors give.
	if (curvature1 + curvature2 == 0) return { geom.radius1 * geom.radius2 / (geom.radius1 + geom.radius2), std::min(geom.radius1, geom.radius2) };
	return { 1 / (curvature1 + curvature2), 1 / std::max(curvature1, curvature2) };
}

Real ContactKinematics::normalMass() const
{
	const Vector3r &point = geom.contactPoint, &push = geom.normal;
	return inverseOrZero(body1.inverseMassAgainst(point, push) + body2.inverseMassAgainst(point, push));
}

Real ContactKinematics::mass() const { return inverseOrZero(body1.inverseMass + body2.inverseMass); }

ContactKinematics::Side ContactKinematics::flatOrSphere(const Body& body)
{
	const auto* sphere = dynamic_cast<const Sphere*>(body.shape.get());
	if (!sphere) return { 0, 0, 0 };
	return { 1 / sphere->radius, sphere->radius, sphere->radius };
}

Vector3r ContactKinematics::middleOfOverlap(
        const ScGeom& geom, const Side& side1, const Vector3r& position1, const Side& side2, const Vector3r& position2)
{
	if (side1.smallestHalfSize > 0) return position1 + (side1.smallestHalfSize - geom.penetrationDepth / 2) * geom.normal;
	if (side2.smallestHalfSize > 0) return position2 - (side2.smallestHalfSize - geom.penetrationDepth / 2) * geom.normal;
	return geom.contactPoint;
}

} // namespace yade
