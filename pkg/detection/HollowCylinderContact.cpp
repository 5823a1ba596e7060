// The farthest point of a convex body from an axis. The distance is convex, so its maximum may have rivals (the two edges of
// a flat side along the wall): each is climbed by Newton's method on the body's surface, and what else there may be is bounded in
// the plane across the axis. There the support lines of two directions meet in a vertex, and the body's points between them lie no
// farther out than this vertex.

#include <pkg/geometry/Curvature.hpp>
#include "Processor.hpp"
#include <pkg/geometry/Tolerances.hpp>
#include "WallContact.hpp"

#include <algorithm>
#include <array>

namespace superquadric {

namespace {

	using Vector2 = Eigen::Vector2d;

	// All in the body's frame.
	class FarthestPoint {
	public:
		FarthestPoint(const Placement& body, const Vector3& fromAxis, const Vector3& axis, SolverCounters& counters)
		        : shape_(body.shape)
		        , counters_(counters)
		        , centre_(fromAxis.norm())
		{
			// On the axis the centre's direction is made of rounding and need not lie across it.
			const Vector3 outwards = fromAxis.normalized() - fromAxis.normalized().dot(axis) * axis;
			const Vector3 first = outwards.squaredNorm() > 0.5 ? outwards.normalized() : axis.unitOrthogonal();
			first_ = body.toBody(first);
			second_ = body.toBody(axis.cross(first));
		}

		// Climbs from a point on or near the surface.
		void startAt(const Vector3& x) { climb(x); }

		// Searches the directions within the window of the centre's whose cosine is given; done, too, once nothing reaches beyond `radius`.
		void search(double windowCosine, double radius)
		{
			const Sample ahead = sample(Vector2(1, 0));
			if (farthest_ < 0 || distanceOf(support_) > farthest_) climb(support_);
			addSectors(windowCosine, ahead);
			while (count_ < sectors_.size()) {
				Sector* widest = std::max_element(sectors_.begin(), sectors_.begin() + count_, [](const Sector& a, const Sector& b) { return a.bound < b.bound; });
				const double gap = std::max(tolerances::wallGap * shape_.boundingRadius(), tolerances::wallShare * (farthest_ - radius));
				if (widest->bound <= std::max(radius, farthest_ + gap)) break;
				const Sector whole = *widest;
				const Sample middle = sample(whole.split);
				if (distanceOf(support_) > farthest_) climb(support_);
				*widest = sector(whole.from, middle);
				sectors_[count_++] = sector(middle, whole.to);
			}
		}

		const Vector3& point() const { return point_; } // from the body's centre
		double farthest() const { return farthest_; }
		Vector3 direction() const
		{
			const Vector2 place = across(point_).normalized();
			return place.x() * first_ + place.y() * second_;
		}
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
			Vector2 direction;
			double reach; // the support of the body along this direction, from the axis
		};
		struct Sector {
			Sample from, to;
			double bound; // no point of the body between them lies farther out
			Vector2 split; // where to divide the sector next
		};

		// Place of a body's point in the plane across the axis, from the axis.
		Vector2 across(const Vector3& x) const { return { centre_ + x.dot(first_), x.dot(second_) }; }
		double distanceOf(const Vector3& x) const { return across(x).norm(); }

		Sample sample(const Vector2& direction)
		{
			support_ = shape_.supportPoint(direction.x() * first_ + direction.y() * second_);
			return { direction, across(support_).dot(direction) };
		}

		// Sectors of less than a half turn.
		void addSectors(double windowCosine, const Sample& ahead)
		{
			if (windowCosine > 0) {
				const double sine = std::sqrt(std::max(0.0, 1 - windowCosine * windowCosine));
				if (sine > 0) sectors_[count_++] = sector(sample(Vector2(windowCosine, -sine)), ahead);
				if (sine > 0) sectors_[count_++] = sector(ahead, sample(Vector2(windowCosine, sine)));
				return;
			}
			std::array<Sample, 4> quarters { ahead, sample(Vector2(0, 1)), sample(Vector2(-1, 0)), sample(Vector2(0, -1)) };
			for (int i = 0; i < 4; ++i)
				sectors_[count_++] = sector(quarters[i], quarters[(i + 1) % 4]);
		}

		static Sector sector(const Sample& from, const Sample& to)
		{
			const Vector2 left(-from.direction.y(), from.direction.x());
			const double cosine = from.direction.dot(to.direction), sine = left.dot(to.direction);
			Sector result { from, to, std::max(from.reach, to.reach), (from.direction + to.direction).normalized() };
			// The vertex of the two support lines counts when it lies between their directions. The sector is divided there: when the
			// body has an edge in it, that is where the edge is.
			const double x = from.reach, y = (to.reach - from.reach * cosine) / sine;
			if (y > 0 && from.reach > to.reach * cosine) {
				const double fromStart = y / std::hypot(x, y), margin = tolerances::wallMargin * sine;
				result.bound = std::hypot(x, y);
				const Vector2 vertex = (x * from.direction + y * left) / result.bound;
				const double toEnd = vertex.x() * to.direction.y() - vertex.y() * to.direction.x();
				if (fromStart < margin) result.split = ((1 - tolerances::wallMargin) * from.direction + tolerances::wallMargin * to.direction).normalized();
				else if (toEnd < margin) result.split = (tolerances::wallMargin * from.direction + (1 - tolerances::wallMargin) * to.direction).normalized();
				else result.split = vertex;
			}
			return result;
		}

		// To the local maximum: Newton where the surface is curved enough for one, else to the support point along the point's own
		// direction, which is never nearer to the axis.
		void climb(const Vector3& start)
		{
			Vector3 x = start / shape_.gauge(start);
			double distance = distanceOf(x);
			for (int i = 0; i < tolerances::wallAscents; ++i) {
				++counters_.iterations;
				Vector3 next;
				const bool settled = newton(x, next);
				if (settled || !(distanceOf(next) > distance)) {
					if (settled) break;
					const Vector2 direction = across(x).normalized();
					next = shape_.supportPoint(direction.x() * first_ + direction.y() * second_);
					if (!(distanceOf(next) > distance)) break;
				}
				x = next;
				distance = distanceOf(x);
			}
			if (!(distance > farthest_)) return;
			farthest_ = distance;
			point_ = x;
		}

		// One step for the largest distance on the surface; true when it would be too short to matter. In half sizes: the gradient of the
		// distance must be `push` times that of the gauge, the Lagrange function's Hessian across it negative.
		bool newton(const Vector3& x, Vector3& next) const
		{
			const Vector3& h = shape_.halfSizes();
			const Vector3 u = x.cwiseQuotient(h);
			const GaugeJet jet = shape_.jet(u);
			const Vector2 place = across(x), outwards = place.normalized();
			const Vector3 rise = h.cwiseProduct(outwards.x() * first_ + outwards.y() * second_);
			const Vector3 turn = h.cwiseProduct(outwards.x() * second_ - outwards.y() * first_);
			const Vector3 normal = jet.gradient.normalized(), along1 = normal.unitOrthogonal(), along2 = normal.cross(along1);
			const double push = rise.dot(jet.gradient) / jet.gradient.squaredNorm(), bend = 1 / place.norm();
			const double t1 = turn.dot(along1), t2 = turn.dot(along2), r1 = rise.dot(along1), r2 = rise.dot(along2);
			const double m11 = push * jet.form(along1) - bend * t1 * t1, m22 = push * jet.form(along2) - bend * t2 * t2;
			const double m12 = push * jet.form(along1, along2) - bend * t1 * t2, determinant = m11 * m22 - m12 * m12;
			next = x;
			if (r1 * r1 + r2 * r2 <= tolerances::wallAscent * tolerances::wallAscent * rise.squaredNorm()) return true;
			if (!(determinant > 0 && m11 + m22 > 0)) return false;
			const Vector3 step = ((r1 * m22 - r2 * m12) * along1 + (r2 * m11 - r1 * m12) * along2) / determinant;
			const Vector3 moved = u + step;
			next = h.cwiseProduct(moved / shape_.jet(moved).value);
			return false;
		}

		const Shape& shape_;
		SolverCounters& counters_;
		double centre_; // distance of the body's centre from the axis [m]
		Vector3 first_, second_; // across the axis: outwards through the centre, and along the wall
		Vector3 support_ = Vector3::Zero(); // of the last sample
		Vector3 point_ = Vector3::Zero();
		double farthest_ = -1;
		std::array<Sector, tolerances::wallSectors> sectors_;
		size_t count_ = 0;
	};

	Contact apartBySphere(const Vector3& fromAxis, const Vector3& axis, double bounding, double radius)
	{
		const double centre = fromAxis.norm();
		Contact contact;
		contact.status = Status::Apart;
		contact.normal = centre > 0 ? Vector3(fromAxis / centre) : axis.unitOrthogonal();
		contact.overlap = centre + bounding - radius;
		contact.lower = contact.upper = radius / (centre + bounding);
		return contact;
	}

} // namespace

SUPERQUADRIC_FOR_EACH_PROCESSOR Contact contactHollowCylinder(
        const Placement& body, const Vector3& origin, const Vector3& axis, double radius, WarmStart& warm, SolverCounters& counters)
{
	++counters.solves;
	const Vector3 fromAxis = body.position - origin - (body.position - origin).dot(axis) * axis;
	const double centre = fromAxis.norm(), bounding = body.shape.boundingRadius(), clear = radius - bounding;
	if (centre < clear) {
		++counters.rejectedBySphere;
		warm = WarmStart();
		return apartBySphere(fromAxis, axis, bounding, radius);
	}
	FarthestPoint search(body, fromAxis, axis, counters);
	if (warm.kind == WarmStart::Point) search.startAt(warm.value);
	else ++counters.coldStarts;
	// Only directions in which the bounding sphere reaches the wall can hold the contact.
	search.search(clear > 0 ? std::min(1.0, clear / centre) : -1.0, radius);

	Contact contact;
	contact.normal = body.toWorld(search.direction());
	contact.lower = radius / search.bound();
	contact.upper = radius / search.farthest();
	contact.overlap = search.farthest() - radius;
	contact.status = contact.overlap > 0 ? Status::Overlap : (contact.overlap <= 0 ? Status::Apart : Status::Uncertified);
	contact.surface1 = body.position + body.toWorld(search.point());
	contact.surface2 = contact.surface1 - contact.overlap * contact.normal;
	contact.point = contact.middle();
	contact.curvature1 = meanCurvature(body.shape, search.point());
	if (contact.status == Status::Uncertified) ++counters.uncertified;
	warm.kind = contact.status == Status::Uncertified ? WarmStart::None : WarmStart::Point;
	warm.value = search.point();
	return contact;
}

} // namespace superquadric
