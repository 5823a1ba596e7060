#include "Region.hpp"

namespace superquadric {

namespace {

	// How far the body reaches out of the half space at most and at least [m].
	struct Reach {
		double most, least;
	};

	Reach reachOutside(const Placement& body, const HalfSpace& halfSpace)
	{
		const double centre = halfSpace.outside(body.position), radius = body.shape.boundingRadius();
		if (std::abs(centre) > radius) return { centre + radius, centre - radius };
		const double half = body.support(halfSpace.normal);
		return { centre + half, centre - half };
	}

} // namespace

Region::Holds ConvexRegion::holds(const Placement& body) const
{
	Holds result = Holds::all;
	for (const HalfSpace& halfSpace : halfSpaces_) {
		const Reach reach = reachOutside(body, halfSpace);
		if (reach.least >= 0) return Holds::nothing;
		if (reach.most > 0) result = Holds::part;
	}
	return result;
}

ClippedSolid ConvexRegion::partWithin(const ClippedSolid& solid, const Placement& body) const
{
	ClippedSolid part = solid;
	for (const HalfSpace& halfSpace : halfSpaces_)
		if (reachOutside(body, halfSpace).most > 0) part.clip(halfSpace.seenFrom(body.position));
	return part;
}

} // namespace superquadric
