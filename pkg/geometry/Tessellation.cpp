#include "Tessellation.hpp"

#include "Tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace superquadric {

namespace {

	constexpr double quarterTurn = pi / 2;

	// A quarter of the superellipse |u/p|^n + |v/q|^n = 1, cut into chords whose errors are alike. A short chord of length ds over which the
	// normal turns by dt has the error ds dt / 8: so each is given the same share of the integral of sqrt(ds dt).
	class QuarterCurve {
	public:
		QuarterCurve(double p, double q, double n)
		        : shape_(Vector3(p, p, q), n, 2)
		        , sums_(pieces + 1, 0)
		{
			Vector3 last = point(0), lastNormal = Vector3::UnitX();
			for (int i = 1; i <= pieces; ++i) {
				const Vector3 next = point(i), normal = shape_.gaugeWithGradient(next).gradient.normalized();
				const double turn = std::atan2(lastNormal.cross(normal).norm(), lastNormal.dot(normal));
				sums_[i] = sums_[i - 1] + std::sqrt(turn * (next - last).norm());
				last = next;
				lastNormal = normal;
			}
		}

		// How many chords have errors of about this much or less [m].
		double chords(double error) const { return std::max(1.0, std::ceil(sums_.back() / std::sqrt(8 * error))); }

		// The ends (u/p, v/q) of so many chords, from (1, 0) to (0, 1).
		std::vector<std::array<double, 2>> ends(int count) const
		{
			std::vector<std::array<double, 2>> result { { 1, 0 } };
			for (int i = 1; i < count; ++i) {
				const double share = sums_.back() * i / count;
				const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, share);
				const double part = (share - above[-1]) / (*above - above[-1]);
				const Vector3 end = point(double(above - sums_.begin()) - 1 + part).cwiseProduct(shape_.inverseHalfSizes());
				result.push_back({ end.x(), end.z() });
			}
			result.push_back({ 0, 1 });
			return result;
		}

	private:
		static constexpr int pieces = tolerances::arcPieces;

		// On the ray whose angle is so many pieces of the quarter, in half sizes.
		Vector3 point(double place) const
		{
			const double angle = quarterTurn * place / pieces;
			const Vector3 along = Vector3(std::cos(angle), 0, std::sin(angle)).cwiseProduct(shape_.halfSizes());
			return along / shape_.gauge(along);
		}

		Shape shape_; // its section by y = 0 is the curve
		std::vector<double> sums_; // of sqrt(ds dt) from the start
	};

	// A flat face of the tessellation: its outward normal, and how far the body rises over it [m].
	struct Face {
		Vector3 normal;
		double excess;

		Face mirrored(int axis) const
		{
			Face result = *this;
			result.normal[axis] = -normal[axis];
			return result;
		}
	};

	// One octant of the grid; the others are its mirror images. Rings are counted from the pole to the equator, columns from the x to the y axis.
	class OctantGrid {
	public:
		OctantGrid(const Shape& shape, const QuarterCurve& profile, int rings, const QuarterCurve& section, int columns)
		        : shape_(shape)
		        , profile_(profile.ends(rings))
		        , section_(section.ends(columns))
		{
			std::reverse(profile_.begin(), profile_.end());
		}

		int rings() const { return int(profile_.size()) - 1; }
		int columns() const { return int(section_.size()) - 1; }

		Vector3 point(int ring, int column) const
		{
			const auto [s, z] = profile_[ring];
			const auto [x, y] = section_[column];
			return shape_.halfSizes().cwiseProduct(Vector3(s * x, s * y, z));
		}

		// The distance between the shape's surface and the tessellation is at most this. A point x of the body outside the tessellation has its
		// nearest point there on a face, and then lies over it by the face's excess at most; or on the edge of two faces, and then its direction from
		// there is within half their angle of one of the normals, so that x is no farther away than excess / cos(half the angle). It cannot be a
		// corner: x would have to rise over the surface's own tangent plane there, as no face around it is turned from it by a right angle (in each
		// octant all normals' components have one sign). The other way round, a point of a face reaches the surface along the face's normal within
		// the excess.
		double distance() const
		{
			double result = 0;
			const auto include = [&](const Face& one, const Face& other) {
				result = std::max(result, std::max(one.excess, other.excess) * 2 / (one.normal + other.normal).norm());
			};
			std::vector<Face> above, ring(columns());
			for (int k = 0; k < rings(); ++k) {
				for (int j = 0; j < columns(); ++j)
					ring[j] = face(k, j);
				include(ring.front(), ring.front().mirrored(1));
				include(ring.back(), ring.back().mirrored(0));
				for (int j = 1; j < columns(); ++j)
					include(ring[j - 1], ring[j]);
				for (std::size_t j = 0; j < above.size(); ++j)
					include(above[j], ring[j]);
				above = ring;
			}
			for (const Face& equatorial : above)
				include(equatorial, equatorial.mirrored(2));
			return result + tolerances::supportRounding * shape_.boundingRadius();
		}

	private:
		Face face(int ring, int column) const
		{
			const Vector3 upper = point(ring, column), lower = point(ring + 1, column + 1);
			const Vector3 normal = (point(ring, column + 1) - point(ring + 1, column)).cross(upper - lower).normalized();
			return { normal, std::max(0.0, shape_.support(normal) - normal.dot(lower)) };
		}

		const Shape& shape_;
		std::vector<std::array<double, 2>> profile_, section_; // (s, z) and (C, S)
	};

	double pointNumber(double rings, double columns) { return 2 + (2 * rings - 1) * 4 * columns; }

	// Grids of a shape by how far one of their two families of chords strays from its curve. The profile is that of the widest meridian.
	class GridFamily {
	public:
		explicit GridFamily(const Shape& shape)
		        : shape_(shape)
		        , section_(shape.halfSizes().x(), shape.halfSizes().y(), shape.n2())
		        , profile_(widest(shape), shape.halfSizes().z(), shape.n1())
		{
		}

		double points(double chordError) const { return pointNumber(profile_.chords(chordError), section_.chords(chordError)); }
		OctantGrid grid(double chordError) const
		{
			return { shape_, profile_, int(profile_.chords(chordError)), section_, int(section_.chords(chordError)) };
		}

	private:
		// The farthest that the section reaches from the z axis: as far as any low and round body with that section.
		static double widest(const Shape& shape)
		{
			const Vector3& h = shape.halfSizes();
			return Shape(Vector3(h.x(), h.y(), h.head<2>().minCoeff()), 2, shape.n2()).boundingRadius();
		}

		const Shape& shape_;
		QuarterCurve section_, profile_;
	};

	void requireEnoughPoints(double points, double error)
	{
		if (points <= tolerances::tessellationPoints) return;
		std::ostringstream message;
		message << "error must be larger: " << error << " m takes " << points << " points, of which " << tolerances::tessellationPoints << " are allowed";
		throw std::invalid_argument(message.str());
	}

	// The coarsest grid that is fine enough: the two families of chords share the error, so the search starts at half of it. The distance falls with
	// the chords' errors almost in proportion.
	OctantGrid coarsestGrid(const GridFamily& family, double error)
	{
		double fine = error / 2, coarse = error / 2;
		while (requireEnoughPoints(family.points(fine), error), family.grid(fine).distance() > error)
			coarse = fine, fine /= 1.5;
		while (fine == coarse && family.points(coarse) > pointNumber(1, 1)) {
			coarse *= 1.5;
			if (family.grid(coarse).distance() <= error) fine = coarse;
		}
		while (coarse > tolerances::tessellationSharpness * fine) {
			const double middle = std::sqrt(fine * coarse);
			(family.grid(middle).distance() <= error ? fine : coarse) = middle;
		}
		return family.grid(fine);
	}

	// The rings below the equator and the columns beyond the first quarter, in the octant.
	int folded(int index, int count) { return index <= count ? index : 2 * count - index; }

	void addPoint(Tessellation& result, const Shape& shape, const OctantGrid& grid, int ring, int column)
	{
		const int columns = grid.columns(), inHalf = column % (2 * columns);
		const Vector3 side(column > columns && column < 3 * columns ? -1 : 1, column > 2 * columns ? -1 : 1, ring > grid.rings() ? -1 : 1);
		const Vector3 inOctant = grid.point(folded(ring, grid.rings()), folded(inHalf, columns));
		result.points.emplace_back(side.cwiseProduct(inOctant));
		result.normals.emplace_back(side.cwiseProduct(shape.gaugeWithGradient(inOctant).gradient.normalized()));
	}

	// The north pole, the rings from north to south, the south pole.
	void addPoints(Tessellation& result, const Shape& shape, const OctantGrid& grid)
	{
		addPoint(result, shape, grid, 0, 0);
		for (int ring = 1; ring < 2 * grid.rings(); ++ring)
			for (int column = 0; column < 4 * grid.columns(); ++column)
				addPoint(result, shape, grid, ring, column);
		addPoint(result, shape, grid, 2 * grid.rings(), 0);
	}

	void addTriangles(Tessellation& result, int rings, int columns)
	{
		const int south = int(result.points.size()) - 1;
		const auto index = [&](int ring, int column) { return ring == 0 ? 0 : (ring == rings ? south : 1 + (ring - 1) * columns + column % columns); };
		for (int ring = 0; ring < rings; ++ring)
			for (int column = 0; column < columns; ++column) {
				const int upper = index(ring, column), upperNext = index(ring, column + 1);
				const int lower = index(ring + 1, column), lowerNext = index(ring + 1, column + 1);
				if (ring + 1 < rings) result.triangles.push_back({ upper, lower, lowerNext });
				if (ring > 0) result.triangles.push_back({ upper, lowerNext, upperNext });
			}
	}

} // namespace

Tessellation tessellate(const Shape& shape, double error)
{
	if (!(std::isfinite(error) && error > 0)) {
		std::ostringstream message;
		message << "error must be finite and positive, got " << error;
		throw std::invalid_argument(message.str());
	}
	const OctantGrid grid = coarsestGrid(GridFamily(shape), error);
	Tessellation result;
	result.error = grid.distance();
	addPoints(result, shape, grid);
	addTriangles(result, 2 * grid.rings(), 4 * grid.columns());
	return result;
}

} // namespace superquadric
