// The pairs of a settled bed, as timebed.py writes them: every particle's place at two steps in a row, and the collider's pairs.
#pragma once

#include <pkg/geometry/Placement.hpp>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace superquadric::bench {

struct BedReplay {
	Shape shape;
	std::array<std::vector<Placement>, 2> moments; // all bodies at one step, and at the next
	// Indices of bodies: those that touch, and those whose bounding spheres meet only. Pairs with the spheres apart never
	// reach the solver and are left out.
	std::vector<std::pair<int, int>> touching, apart;

	explicit BedReplay(const Shape& shape)
	        : shape(shape)
	{
	}
};

// Throws std::runtime_error naming the file if it cannot be read.
std::unique_ptr<BedReplay> readBed(const std::string& path);

} // namespace superquadric::bench
