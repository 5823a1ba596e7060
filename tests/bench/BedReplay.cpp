#include "BedReplay.hpp"

#include <pkg/geometry/Bounds.hpp>
#include <pkg/detection/PairContact.hpp>

#include <fstream>
#include <stdexcept>

namespace superquadric::bench {

namespace {

	Placement readPlace(std::istream& in, const Shape& shape)
	{
		Vector3 position;
		double w, x, y, z;
		in >> position[0] >> position[1] >> position[2] >> w >> x >> y >> z;
		return { shape, position, Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix() };
	}

	// The pair is touching only when it touches at both moments.
	void sortIn(BedReplay& bed, std::pair<int, int> pair)
	{
		const auto& bodies = bed.moments[0];
		if (boundingSpheresApart(bed.shape, bed.shape, bodies[pair.second].position - bodies[pair.first].position)) return;
		bool touching = true;
		for (const auto& moment : bed.moments) {
			WarmStart warm;
			SolverCounters counters;
			touching = touching && contactPair(moment[pair.first], moment[pair.second], warm, counters).overlapping();
		}
		(touching ? bed.touching : bed.apart).push_back(pair);
	}

} // namespace

std::unique_ptr<BedReplay> readBed(const std::string& path)
{
	std::ifstream in(path);
	Vector3 halfSizes;
	double n1, n2;
	int bodies, pairs;
	if (!(in >> halfSizes[0] >> halfSizes[1] >> halfSizes[2] >> n1 >> n2 >> bodies >> pairs)) throw std::runtime_error(path + ": not a file of pairs");
	auto bed = std::make_unique<BedReplay>(Shape(halfSizes, n1, n2));
	for (int i = 0; i < bodies; ++i)
		for (auto& moment : bed->moments)
			moment.push_back(readPlace(in, bed->shape));
	for (int i = 0; i < pairs; ++i) {
		std::pair<int, int> pair;
		in >> pair.first >> pair.second;
		if (!in || pair.first < 0 || pair.first >= bodies || pair.second < 0 || pair.second >= bodies) throw std::runtime_error(path + ": ends early");
		sortIn(*bed, pair);
	}
	return bed;
}

} // namespace superquadric::bench
