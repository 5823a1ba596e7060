// Boxes of 200 random shapes against searches over the surface, and the box test against every corner of both boxes.
#include <pkg/geometry/Bounds.hpp>

#include <tests/support/RandomBodies.hpp>
#include <tests/support/ReferenceShape.hpp>

#include <gtest/gtest.h>

#include <limits>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

// The largest projection of a body's box, corner by corner.
double farthestCorner(const Placement& body, const Vector3& direction)
{
	double farthest = 0;
	for (int corner = 0; corner < 8; ++corner) {
		const Vector3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
		farthest = std::max(farthest, direction.dot(body.toWorld(signs.cwiseProduct(body.shape.halfSizes()))));
	}
	return farthest;
}

// True when points of both boxes are found at the same place: alternating projections between the two convex boxes.
bool boxesMeet(const Placement& body1, const Placement& body2)
{
	const auto nearest = [](const Placement& body, const Vector3& x) {
		const Vector3 inside = body.toBody(x - body.position).cwiseMax(-body.shape.halfSizes()).cwiseMin(body.shape.halfSizes());
		return Vector3(body.position + body.toWorld(inside));
	};
	Vector3 x = body1.position;
	double distance = 0;
	for (int i = 0; i < 3000; ++i) {
		const Vector3 y = nearest(body2, x);
		x = nearest(body1, y);
		distance = (x - y).norm();
		if (distance < 1e-9) return true;
	}
	return false;
}

} // namespace

TEST(Bounds, BoxOfRandomShapesIsExact)
{
	RandomBodies random(41);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape(i % 2 ? 1 : 1e-3);
		const ReferenceShape reference(shape);
		const Matrix3 rotation = i % 10 ? random.rotation() : Matrix3(Matrix3::Identity());
		const Vector3 box = boxHalfExtents(shape, rotation);
		for (int axis = 0; axis < 3; ++axis)
			EXPECT_NEAR(box[axis], reference.searchedSupport(rotation.transpose() * Vector3::Unit(axis)), 1e-14 * shape.boundingRadius());
		for (int k = 0; k < 500; ++k) {
			const Vector3 x = reference.surfacePoint(random.uniform(-pi / 2, pi / 2), random.uniform(-pi, pi)).cast<double>();
			EXPECT_LE(((rotation * x).cwiseAbs() - box).maxCoeff(), 1e-14 * shape.boundingRadius());
		}
	}
}

TEST(Bounds, BoxOfASpinningBodyStaysWithinItsSphereAndFollowsTheTurn)
{
	const Shape plate(Vector3(1, 1, 0.1), 8, 8);
	const Matrix3 quarter = Eigen::AngleAxisd(pi / 2, Vector3::UnitX()).toRotationMatrix();
	EXPECT_LT((boxHalfExtents(plate, Matrix3::Identity()) - Vector3(1, 1, 0.1)).norm(), 1e-15);
	EXPECT_LT((boxHalfExtents(plate, quarter) - Vector3(1, 0.1, 1)).norm(), 1e-14);
	for (int i = 0; i < 100; ++i)
		EXPECT_LE(boxHalfExtents(plate, Eigen::AngleAxisd(i * 0.1, Vector3(1, 2, 3).normalized()).toRotationMatrix()).maxCoeff(), plate.boundingRadius());
}

TEST(Bounds, OrientedBoxTestSeparatesWhatItSaysAndMissesNothing)
{
	RandomBodies random(42);
	int apart = 0, meeting = 0;
	for (int i = 0; i < 1000; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape(random.logarithmic(0.05, 1));
		const Matrix3 rotation1 = random.rotation();
		// A third with parallel faces, where the axes made of two edges vanish.
		const Placement body1 { shape1, random.direction(), rotation1 };
		const double reach = shape1.boundingRadius() + shape2.boundingRadius();
		const Placement body2 { shape2, body1.position + random.uniform(0, 1.2) * reach * random.direction(), i % 3 ? random.rotation() : rotation1 };
		const Vector3 between = body2.position - body1.position;
		Vector3 direction;
		if (orientedBoxesApart(body1, body2, between, direction)) {
			++apart;
			EXPECT_NEAR(direction.norm(), 1, 1e-13);
			EXPECT_GT(between.dot(direction), farthestCorner(body1, direction) + farthestCorner(body2, -direction) - 1e-13);
		} else {
			++meeting;
			EXPECT_TRUE(boxesMeet(body1, body2));
		}
	}
	EXPECT_GT(apart, 100);
	EXPECT_GT(meeting, 100);
}

TEST(Bounds, SpheresApartWhenTheirCentresAreFartherThanTheRadii)
{
	RandomBodies random(44);
	for (int i = 0; i < 100; ++i) {
		const Shape shape1 = random.shape(), shape2 = random.shape(0.1);
		const double reach = shape1.boundingRadius() + shape2.boundingRadius();
		const Vector3 direction = random.direction();
		EXPECT_TRUE(boundingSpheresApart(shape1, shape2, reach * (1 + 1e-12) * direction));
		EXPECT_FALSE(boundingSpheresApart(shape1, shape2, reach * (1 - 1e-12) * direction));
	}
	const Shape cube(Vector3::Constant(1), 8, 8);
	EXPECT_FALSE(boundingSpheresApart(cube, cube, Vector3(std::numeric_limits<double>::quiet_NaN(), 9, 9)));
}
