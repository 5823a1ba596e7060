// The farthest point of a convex body from an axis. The distance is convex, so its maximum may have rivals (the two edges of
// a flat side along the wall): it is bracketed over the angle about the axis. In the plane across the axis the support lines of
// two directions meet in a vertex, and the body's points between them lie no farther out than this vertex.

#include "Curvature.hpp"
#include "Tolerances.hpp"
#include "WallContact.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace superquadric {

namespace {

	constexpr double pi = 3.14159265358979323846;

	class FarthestPoint {
	public:
		FarthestPoint(const Placement& body, const Vector3& origin, const Vector3& axis)
		        : body_(body)
		        , axis_(axis)
		{
			centre_ = across(body.position - origin);
			const double distance = centre_.norm();
			first_ = distance > 0 ? Vector3(centre_ / distance) : axis.unitOrthogonal();
			second_ = axis.cross(first_);
		}

		// Searches the directions within `window` of the centre's [rad].
		void search(double window)
		{
			std::vector<Sector> open;
			constexpr int parts = 4;
			for (int i = 0; i < parts; ++i)
				open.push_back(sector(sample(window * (2.0 * i / parts - 1)), sample(window * (2.0 * (i + 1) / parts - 1))));
			const double gap = tolerances::wallGap * body_.shape.boundingRadius();
			for (int i = 0; i < tolerances::wallBisections && !open.empty(); ++i) {
				const auto widest = std::max_element(open.begin(), open.end(), [](const Sector& a, const Sector& b) { return a.bound < b.bound; });
				if (widest->bound <= farthest_ + gap) break;
				const Sector split = *widest;
				const Sample middle = sample(0.5 * (split.from.angle + split.to.angle));
				*widest = sector(split.from, middle);
				open.push_back(sector(middle, split.to));
			}
			bound_ = farthest_;
			for (const Sector& s : open)
				bound_ = std::max(bound_, s.bound);
			ascend();
		}

		const Vector3& point() const { return point_; } // from the body's centre
		Vector3 direction() const { return across(centre_ + point_).normalized(); }
		double farthest() const { return farthest_; }
		double bound() const { return std::max(bound_, farthest_); }

	private:
		struct Sample {
			double angle, reach; // reach: the support of the body along this direction, from the axis
		};
		struct Sector {
			Sample from, to;
			double bound;
		};

		Vector3 across(const Vector3& v) const { return v - v.dot(axis_) * axis_; }
		Vector3 directionAt(double angle) const { return std::cos(angle) * first_ + std::sin(angle) * second_; }

		Sample sample(double angle)
		{
			const Vector3 direction = directionAt(angle), deepest = body_.supportPoint(direction);
			note(deepest);
			return { angle, (centre_ + deepest).dot(direction) };
		}

		bool note(const Vector3& point)
		{
			const double distance = across(centre_ + point).norm();
			if (!(distance > farthest_)) return false;
			farthest_ = distance;
			point_ = point;
			return true;
		}

		static Sector sector(const Sample& from, const Sample& to)
		{
			const double angle = to.angle - from.angle, cosine = std::cos(angle), sine = std::sin(angle);
			double bound = std::max(from.reach, to.reach);
			// The vertex of the two support lines counts when it lies between their directions.
			if (to.reach > from.reach * cosine && from.reach > to.reach * cosine)
				bound = std::sqrt(from.reach * from.reach + to.reach * to.reach - 2 * from.reach * to.reach * cosine) / sine;
			return { from, to, bound };
		}

		// The support point along a point's own direction is never nearer to the axis: repeated, this climbs to the maximum.
		void ascend()
		{
			for (int i = 0; i < tolerances::wallAscents; ++i)
				if (!note(body_.supportPoint(direction()))) return;
		}

		const Placement& body_;
		Vector3 axis_, centre_, first_, second_;
		Vector3 point_ = Vector3::Zero();
		double farthest_ = -1, bound_ = 0;
	};

} // namespace

Contact contactHollowCylinder(const Placement& body, const Vector3& origin, const Vector3& axis, double radius)
{
	const Vector3 fromAxis = body.position - origin - (body.position - origin).dot(axis) * axis;
	const double centre = fromAxis.norm(), bounding = body.shape.boundingRadius(), clear = radius - bounding;
	Contact contact;
	if (centre < clear) {
		contact.status = Status::Apart;
		contact.normal = centre > 0 ? Vector3(fromAxis / centre) : axis.unitOrthogonal();
		contact.overlap = centre + bounding - radius;
		contact.lower = contact.upper = radius / (centre + bounding);
		return contact;
	}
	FarthestPoint search(body, origin, axis);
	// Only directions in which the bounding sphere reaches the wall can hold the contact.
	search.search(clear > 0 ? std::acos(std::min(1.0, clear / centre)) : pi);
	contact.normal = search.direction();
	contact.lower = radius / search.bound();
	contact.upper = radius / search.farthest();
	contact.overlap = search.farthest() - radius;
	contact.status = contact.overlap > 0 ? Status::Overlap : Status::Apart;
	contact.surface1 = body.position + search.point();
	contact.surface2 = contact.surface1 - contact.overlap * contact.normal;
	contact.point = contact.middle();
	contact.curvature1 = meanCurvature(body.shape, body.toBody(search.point()));
	return contact;
}

} // namespace superquadric
