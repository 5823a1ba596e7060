// The farthest point of a convex body from an axis. The distance is convex, so its maximum may have rivals (the two edges of
// a flat side along the wall): it is bracketed over the angle about the axis. In the plane across the axis the support lines of
// two directions meet in a vertex, and the body's points between them lie no farther out than this vertex.

#include "Curvature.hpp"
#include "Tolerances.hpp"
#include "WallContact.hpp"

#include <algorithm>
#include <array>

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
			// On the axis the centre's direction is made of rounding and need not lie across it.
			const Vector3 outwards = across(centre_.normalized());
			first_ = outwards.squaredNorm() > 0.5 ? outwards.normalized() : axis.unitOrthogonal();
			second_ = axis.cross(first_);
		}

		// Searches the directions within `window` of the centre's [rad]; done, too, once nothing reaches beyond `enough`.
		void search(double window, double enough)
		{
			note(body_.supportPoint(first_));
			ascend();
			for (int i = 0; i < firstSectors; ++i)
				add(sample(window * (2.0 * i / firstSectors - 1)), sample(window * (2.0 * (i + 1) / firstSectors - 1)));
			const double gap = tolerances::wallGap * body_.shape.boundingRadius();
			while (count_ < sectors_.size()) {
				Sector* widest = std::max_element(sectors_.begin(), sectors_.begin() + count_, [](const Sector& a, const Sector& b) { return a.bound < b.bound; });
				if (widest->bound <= std::max(enough, farthest_ + gap)) break;
				const Sector whole = *widest;
				const Sample middle = sample(whole.split);
				*widest = sector(whole.from, middle);
				add(middle, whole.to);
			}
			ascend();
		}

		const Vector3& point() const { return point_; } // from the body's centre
		Vector3 direction() const { return across(centre_ + point_).normalized(); }
		double farthest() const { return farthest_; }
		// No point in the searched directions lies farther out.
		double bound() const
		{
			double result = farthest_;
			for (size_t i = 0; i < count_; ++i)
				result = std::max(result, sectors_[i].bound);
			return result;
		}

	private:
		struct Sample {
			double angle, reach; // reach: the support of the body along this direction, from the axis
		};
		struct Sector {
			Sample from, to;
			double bound; // no point of the body between them lies farther out
			double split; // where to divide the sector next
		};
		static constexpr int firstSectors = 4;

		void add(const Sample& from, const Sample& to) { sectors_[count_++] = sector(from, to); }

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
			Sector result { from, to, std::max(from.reach, to.reach), 0.5 * (from.angle + to.angle) };
			// The vertex of the two support lines counts when it lies between their directions. The sector is divided there: when the
			// body has an edge in it, that is where the edge is.
			const double x = from.reach, y = (to.reach - from.reach * cosine) / sine;
			if (y > 0 && from.reach > to.reach * cosine) {
				result.bound = std::hypot(x, y);
				const double margin = tolerances::wallMargin * angle;
				result.split = from.angle + std::clamp(std::atan2(y, x), margin, angle - margin);
			}
			return result;
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
		double farthest_ = -1;
		std::array<Sector, tolerances::wallSectors> sectors_;
		size_t count_ = 0;
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
	search.search(clear > 0 ? std::acos(std::min(1.0, clear / centre)) : pi, radius);
	contact.normal = search.direction();
	contact.lower = radius / search.bound();
	contact.upper = radius / search.farthest();
	contact.overlap = search.farthest() - radius;
	contact.status = contact.overlap > 0 ? Status::Overlap : contact.overlap <= 0 ? Status::Apart : Status::Uncertified;
	contact.surface1 = body.position + search.point();
	contact.surface2 = contact.surface1 - contact.overlap * contact.normal;
	contact.point = contact.middle();
	contact.curvature1 = meanCurvature(body.shape, body.toBody(search.point()));
	return contact;
}

} // namespace superquadric
