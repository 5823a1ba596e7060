// The independent description of a contact itself, where the answer is known or can be tried.
#include "RandomPairs.hpp"
#include "ReferenceContact.hpp"
#include "CommonScaling.hpp"

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

// Overlapping by a hundredth of the smallest half size.
template <class Function> void withRandomPairs(std::uint64_t seed, const Function& function)
{
	for (std::uint64_t i = 0; i < 100; ++i) {
		const RandomPair pair(seed, i);
		const Shape shape1(pair.sizes1, pair.n11, pair.n12), shape2(pair.sizes2, pair.n21, pair.n22);
		const Placement body1 { shape1, Vector3::Zero(), pair.rotation1 };
		const Real touching = 1 / commonScaling<double>(body1, Placement { shape2, pair.along, pair.rotation2 }).middle();
		const double depth = 0.01 * std::min(shape1.smallestHalfSize(), shape2.smallestHalfSize()) / pair.along.norm();
		function(body1, Placement { shape2, pair.along * (double(touching) - depth), pair.rotation2 });
	}
}

} // namespace

TEST(ReferenceGauge, AgreesWithEquationOneAndItsComplexStep)
{
	RandomBodies random(55);
	for (int i = 0; i < 200; ++i) {
		const Shape shape = random.shape();
		const Placement body { shape, Vector3::Zero(), Matrix3::Identity() };
		const ReferenceShape plain(shape);
		const RealVector x = random.direction().cast<Real>(), h = 1e-6L * random.direction().cast<Real>();
		const ReferenceBody reference(body, Vector3::Zero(), 1);
		const ReferenceGauge g = reference.gauge(x), ahead = reference.gauge(x + h), behind = reference.gauge(x - h);
		const Real f = plain.function(x), scale = g.gradient.norm();
		EXPECT_LT(std::abs(std::pow(g.value, plain.n1) / f - 1), 1e-16L);
		EXPECT_LT((plain.n1 * f / g.value * g.gradient - plain.gradient(x)).norm(), 1e-15L * plain.gradient(x).norm());
		EXPECT_LT((g.hessian * (2 * h) - (ahead.gradient - behind.gradient)).norm(), 1e-9L * scale * h.norm() + 1e-4L * (g.hessian * h).norm());
	}
}

TEST(ReferenceContact, OfEqualSpheresIsClosedForm)
{
	const Shape sphere(Vector3::Constant(2), 2, 2);
	const Vector3 between(1.2, -2.4, 2.4); // 3.6 apart
	const ReferenceContact contact = referenceContact({ sphere, Vector3(5, 6, 7), Matrix3::Identity() }, { sphere, Vector3(5, 6, 7) + between, Matrix3::Identity() });
	EXPECT_LT(contact.error, 1e-15L);
	EXPECT_LT((contact.point - between.cast<Real>() / 2).norm(), 1e-14L);
	EXPECT_LT((contact.normal - between.cast<Real>() / 3.6L).norm(), 1e-14L);
	EXPECT_LT(std::abs(contact.overlap - 0.4L), 1e-14L);
	EXPECT_LT(std::abs(contact.curvature1 - 0.5L) + std::abs(contact.curvature2 - 0.5L), 1e-14L);
	EXPECT_LT((contact.surface1 - between.cast<Real>() * (2 / 3.6L)).norm(), 1e-14L);
	EXPECT_LT((contact.surface2 - between.cast<Real>() * (1.6L / 3.6L)).norm(), 1e-14L);
}

// Nowhere is the objective lower, near or far; and it rises as the strong convexity says that the error's bound rests on.
TEST(ReferenceContact, NoPointUndercutsTheMinimum)
{
	RandomBodies random(56);
	withRandomPairs(57, [&](const Placement& body1, const Placement& body2) {
		const ContactCentre problem(body1, body2);
		const ReferenceContact contact = referenceContact(body1, body2);
		ASSERT_LT(contact.error, 1e-9L);
		const Real least = problem.objective(contact.point);
		for (int k = 0; k < 200; ++k) {
			const RealVector step = (body2.shape.smallestHalfSize() * random.logarithmic(1e-6, 1) * random.direction()).cast<Real>();
			const RealVector in1 = (body1.rotation.cast<Real>().transpose() * step).cwiseQuotient(body1.shape.halfSizes().cast<Real>());
			const RealVector in2 = (body2.rotation.cast<Real>().transpose() * step).cwiseQuotient(body2.shape.halfSizes().cast<Real>());
			const Real rise = ContactCentre::centring / 2 * (in1.squaredNorm() + in2.squaredNorm());
			EXPECT_GE(problem.objective(contact.point + step), least + rise - 1e-14L);
		}
	});
}

TEST(ReferenceContact, LiesOnBothSurfacesAlongTheCommonNormal)
{
	withRandomPairs(58, [&](const Placement& body1, const Placement& body2) {
		const ReferenceContact contact = referenceContact(body1, body2);
		const ReferenceShape shape1(body1.shape), shape2(body2.shape);
		const RealVector between = (body2.position - body1.position).cast<Real>();
		EXPECT_LT(std::abs(shape1.function(RealVector(body1.rotation.cast<Real>().transpose() * contact.surface1)) - 1), 1e-12L);
		EXPECT_LT(std::abs(shape2.function(RealVector(body2.rotation.cast<Real>().transpose() * (contact.surface2 - between))) - 1), 1e-12L);
		EXPECT_LT((contact.surface1 - contact.surface2 - contact.overlap * contact.normal).norm(), 1e-15L);
		EXPECT_GT(contact.overlap, 0);
	});
}
