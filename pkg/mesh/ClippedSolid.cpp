#include "ClippedSolid.hpp"

#include <algorithm>
#include <optional>

namespace superquadric {

namespace {

	// Where the edge leaves the half space; the same to the last digit for both polygons that share it, as both begin inside.
	Vector3 crossing(const Vector3& inside, double insideBy, const Vector3& outside, double outsideBy)
	{
		return inside + insideBy / (insideBy - outsideBy) * (outside - inside);
	}

} // namespace

ClippedSolid::ClippedSolid(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles, const Matrix3& rotation)
{
	corners_.reserve(3 * triangles.size());
	ends_.reserve(triangles.size());
	for (const auto& triangle : triangles) {
		for (const int corner : triangle)
			corners_.emplace_back(rotation * points[std::size_t(corner)]);
		ends_.push_back(corners_.size());
	}
}

void ClippedSolid::clip(const HalfSpace& kept)
{
	outside_.resize(corners_.size());
	std::transform(corners_.begin(), corners_.end(), outside_.begin(), [&](const Vector3& x) { return kept.outside(x); });
	if (std::all_of(outside_.begin(), outside_.end(), [](double d) { return d <= 0; })) return;
	keptCorners_.clear();
	keptEnds_.clear();
	cuts_.clear();
	for (std::size_t i = 0, begin = 0; i < ends_.size(); begin = ends_[i++])
		clipPolygon(begin, ends_[i]);
	cover();
	corners_.swap(keptCorners_);
	ends_.swap(keptEnds_);
}

// Sutherland & Hodgman (1974) for one plane. A polygon that lies in the plane to rounding may cross it more than twice.
void ClippedSolid::clipPolygon(std::size_t begin, std::size_t end)
{
	const std::size_t before = keptCorners_.size();
	std::optional<Vector3> left, firstEntry;
	for (std::size_t i = begin; i < end; ++i) {
		const std::size_t next = i + 1 < end ? i + 1 : begin;
		const bool here = outside_[i] <= 0, there = outside_[next] <= 0;
		if (here) keptCorners_.push_back(corners_[i]);
		if (here == there) continue;
		const Vector3 x = here ? crossing(corners_[i], outside_[i], corners_[next], outside_[next])
		                       : crossing(corners_[next], outside_[next], corners_[i], outside_[i]);
		keptCorners_.push_back(x);
		if (here) left = x;
		else if (left) cuts_.push_back({ *left, x });
		else firstEntry = x;
		if (there) left.reset();
	}
	if (left && firstEntry) cuts_.push_back({ *left, *firstEntry });
	if (keptCorners_.size() > before) keptEnds_.push_back(keptCorners_.size());
}

void ClippedSolid::cover()
{
	for (const auto& [left, entered] : cuts_) {
		const Vector3& apex = cuts_.front()[0];
		if (left == apex || entered == apex) continue;
		keptCorners_.insert(keptCorners_.end(), { apex, entered, left });
		keptEnds_.push_back(keptCorners_.size());
	}
}

double ClippedSolid::volume() const
{
	if (empty()) return 0;
	const Vector3 origin = corners_.front();
	double sum = 0;
	for (std::size_t i = 0, begin = 0; i < ends_.size(); begin = ends_[i++])
		for (std::size_t k = begin + 1; k + 1 < ends_[i]; ++k)
			sum += (corners_[begin] - origin).dot((corners_[k] - origin).cross(corners_[k + 1] - origin));
	return sum / 6;
}

} // namespace superquadric
