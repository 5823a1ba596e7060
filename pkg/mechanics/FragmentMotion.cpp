#include "FragmentMotion.hpp"

#include <pkg/geometry/MassProperties.hpp>
#include <pkg/geometry/Tolerances.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace superquadric::fragments {

namespace {

	// Mean squares of the coordinates in a body, over the squares of its half sizes.
	Vector3 secondMoments(double n1, double n2)
	{
		if (n1 == 2 && n2 == 2) return Vector3::Constant(1. / 5);
		const Shape unit(Vector3::Ones(), n1, n2);
		const Vector3 inertia = inertiaOfUnitDensity(unit) / volume(unit);
		return Vector3::Constant(inertia.sum() / 2) - inertia;
	}

	Matrix3 inertiaFrom(const Matrix3& moments) { return moments.trace() * Matrix3::Identity() - moments; }

	// Places in half sizes of the parent, with the centre of mass at the origin.
	class Assembly {
	public:
		Assembly(const Pieces& pieces, const Parent& parent)
		        : pieces_(pieces)
		        , parent_(parent)
		        , unit_(Vector3::Ones(), parent.shape.n1(), parent.shape.n2())
		        , moments_(secondMoments(parent.shape.n1(), parent.shape.n2()))
		        , places_(pieces.size())
		{
		}

		// The pieces' own places, `spread` times as far out, but inside the parent. Moving in those that are not shifts the centre of mass, and
		// moving that back may bring others out, by less each time; what is left at the end is taken by moving all inwards alike.
		void place(double spread, double reach, double margin)
		{
			for (std::size_t i = 0; i < places_.size(); ++i)
				places_[i] = spread * pieces_[i].place;
			centre();
			for (int round = 0; round < tolerances::placingRounds && excess(reach, margin) > 1; ++round) {
				for (std::size_t i = 0; i < places_.size(); ++i)
					places_[i] /= std::max(1., excess(i, reach, margin));
				centre();
			}
			const double shrink = std::max(1., excess(reach, margin));
			for (Vector3& place : places_)
				place /= shrink;
		}

		// Per unit mass, along the axes of the pieces [m^2].
		Matrix3 inertia() const
		{
			const Vector3& sizes = parent_.shape.halfSizes();
			Matrix3 sum = Matrix3::Zero();
			for (std::size_t i = 0; i < places_.size(); ++i) {
				const Vector3 place = sizes.cwiseProduct(places_[i]), own = sizes.cwiseProduct(pieces_[i].scale).cwiseAbs2();
				sum += pieces_[i].share * (Matrix3(own.cwiseProduct(moments_).asDiagonal()) + place * place.transpose());
			}
			return inertiaFrom(sum);
		}

		Layout turned(const Matrix3& rotation) const
		{
			Layout layout;
			layout.rotation = rotation;
			for (const Vector3& place : places_)
				layout.offsets.emplace_back(rotation * parent_.shape.halfSizes().cwiseProduct(place));
			const Vector3 momentum = parent_.spinMomentum();
			const Vector3 own = inertia().ldlt().solve(rotation.transpose() * momentum) / parent_.mass;
			layout.spin = rotation * own;
			layout.spinEnergy = momentum.dot(layout.spin) / 2;
			const double allowed = parent_.spinEnergy() * (1 + tolerances::energyRounding) + parent_.storedEnergy;
			layout.gains = layout.spinEnergy > allowed;
			return layout;
		}

		// The rotation that lays the axis of the largest moment along the angular momentum.
		Matrix3 steadiest() const
		{
			const Vector3 axis = Eigen::SelfAdjointEigenSolver<Matrix3>(inertia()).eigenvectors().col(2);
			return Eigen::Quaterniond::FromTwoVectors(axis, parent_.spinMomentum()).toRotationMatrix();
		}

	private:
		void centre()
		{
			Vector3 middle = Vector3::Zero();
			for (std::size_t i = 0; i < places_.size(); ++i)
				middle += pieces_[i].share * places_[i];
			for (Vector3& place : places_)
				place -= middle;
		}
		// How far out a piece is, over how far it may be; the largest of all.
		double excess(std::size_t i, double reach, double margin) const
		{
			return unit_.gauge(places_[i]) / std::max(tolerances::smallestReach, reach - margin * pieces_[i].scale.minCoeff());
		}
		double excess(double reach, double margin) const
		{
			double largest = 0;
			for (std::size_t i = 0; i < places_.size(); ++i)
				largest = std::max(largest, excess(i, reach, margin));
			return largest;
		}

		const Pieces& pieces_;
		const Parent& parent_;
		const Shape unit_;
		const Vector3 moments_;
		std::vector<Vector3> places_;
	};

} // namespace

Vector3 inertiaOfUnitMass(const Shape& shape)
{
	const Vector3 moments = secondMoments(shape.n1(), shape.n2()).cwiseProduct(shape.halfSizes().cwiseAbs2());
	return inertiaFrom(moments.asDiagonal()).diagonal();
}

Vector3 Parent::spinMomentum() const { return rotation * inertia.cwiseProduct(rotation.transpose() * spin); }

double Parent::spinEnergy() const { return spinMomentum().dot(spin) / 2; }

Layout arrange(const Pieces& pieces, const Parent& parent, CounterRandom& random)
{
	Assembly assembly(pieces, parent);
	const double reach = 1 - parent.deepest / parent.shape.smallestHalfSize();
	for (int trial = 0; trial < tolerances::layoutTrials; ++trial) {
		assembly.place(1 + trial * tolerances::spreadStep, reach, tolerances::fragmentMargin);
		const Layout layout = assembly.turned(parent.turnable ? random.rotation() : parent.rotation);
		if (!layout.gains) return layout;
	}
	assembly.place(1 + tolerances::layoutTrials * tolerances::spreadStep, /*reach*/ 1, /*margin*/ 0);
	return assembly.turned(parent.turnable ? assembly.steadiest() : parent.rotation);
}

} // namespace superquadric::fragments
