#include "SolidVolume.hpp"

#include <pkg/geometry/MassProperties.hpp>
#include <pkg/geometry/Tessellation.hpp>

#include <algorithm>
#include <unordered_map>

namespace superquadric {

namespace {

	// Beds have many bodies of few shapes.
	class Tessellations {
	public:
		explicit Tessellations(double accuracy)
		        : accuracy_(accuracy)
		{
		}
		const Tessellation& of(const Shape& shape)
		{
			auto& alike = found_[shape.fingerprint()];
			for (const auto& [known, tessellation] : alike)
				if (known == shape) return tessellation;
			alike.emplace_back(shape, tessellate(shape, accuracy_ * shape.smallestHalfSize()));
			return alike.back().second;
		}

	private:
		double accuracy_;
		std::unordered_map<long, std::vector<std::pair<Shape, Tessellation>>> found_;
	};

	SolidVolume partOf(const Placement& body, const Region& region, double whole, const Tessellation& tessellation)
	{
		const ClippedSolid solid(tessellation.points, tessellation.triangles, body.rotation);
		const double tessellated = std::min(solid.volume(), whole), within = std::clamp(region.volumeWithin(solid, body), 0.0, tessellated);
		const double most = std::max(within, std::min(within + whole - tessellated, whole));
		return { within, std::clamp(within * (whole / tessellated), within, most), most };
	}

} // namespace

std::vector<SolidVolume> volumesWithin(const std::vector<Placement>& bodies, const Region& region, double accuracy)
{
	Tessellations tessellations(accuracy);
	std::vector<SolidVolume> result;
	result.reserve(bodies.size());
	for (const Placement& body : bodies) {
		const double whole = volume(body.shape);
		switch (region.holds(body)) {
			case Region::Holds::nothing: result.push_back({ 0, 0, 0 }); break;
			case Region::Holds::all: result.push_back({ whole, whole, whole }); break;
			case Region::Holds::part: result.push_back(partOf(body, region, whole, tessellations.of(body.shape))); break;
		}
	}
	return result;
}

} // namespace superquadric
