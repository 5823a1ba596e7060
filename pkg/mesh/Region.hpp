// Parts of space in which solid is measured.
#pragma once

#include "ClippedSolid.hpp"

#include <pkg/geometry/Placement.hpp>

#include <memory>

namespace superquadric {

class Region {
public:
	enum class Holds {
		nothing,
		all,
		part,
	};

	virtual ~Region() = default;

	// How much of a body lies inside; `part` also where it is not worth finding out.
	virtual Holds holds(const Placement& body) const = 0;
	// Volume of the part of a solid that lies inside [m^3]: of the tessellation of `body`, turned like it, and seen from its centre. Far from the
	// scene's origin a small solid's own shape would be lost in the last digits of its corners.
	virtual double volumeWithin(const ClippedSolid& solid, const Placement& body) const = 0;
};

// What half spaces have in common: a box, a prism, a slab.
class ConvexRegion : public Region {
public:
	explicit ConvexRegion(std::vector<HalfSpace> halfSpaces)
	        : halfSpaces_(std::move(halfSpaces))
	{
	}
	Holds holds(const Placement& body) const override;
	double volumeWithin(const ClippedSolid& solid, const Placement& body) const override { return partWithin(solid, body).volume(); }
	ClippedSolid partWithin(const ClippedSolid& solid, const Placement& body) const;

private:
	std::vector<HalfSpace> halfSpaces_;
};

// What a closed surface encloses, convex or not, whichever way it faces.
class MeshRegion : public Region {
public:
	// Throws std::invalid_argument where the surface cannot bound a region (checkMesh, with the name given).
	MeshRegion(const TriangleMesh& mesh, const std::string& name);
	~MeshRegion() override;
	Holds holds(const Placement& body) const override;
	double volumeWithin(const ClippedSolid& solid, const Placement& body) const override;

	double volume() const; // [m^3]
	bool contains(const Vector3& point) const; // its surface included

private:
	struct Search;
	std::unique_ptr<Search> search_;
};

// What a closed surface encloses, between planes: a hopper up to the level of its filling.
class CutMeshRegion : public Region {
public:
	CutMeshRegion(const MeshRegion& mesh, const ConvexRegion& planes)
	        : mesh_(mesh)
	        , planes_(planes)
	{
	}
	Holds holds(const Placement& body) const override
	{
		const Holds planes = planes_.holds(body);
		if (planes == Holds::nothing) return planes;
		const Holds mesh = mesh_.holds(body);
		return mesh == Holds::all ? planes : mesh;
	}
	double volumeWithin(const ClippedSolid& solid, const Placement& body) const override
	{
		return mesh_.volumeWithin(planes_.partWithin(solid, body), body);
	}

private:
	const MeshRegion& mesh_;
	const ConvexRegion& planes_;
};

} // namespace superquadric
