// Points, normal, overlap and curvatures of contactPair against the independent description in long double (ReferenceContact.hpp), per pair of
// shape classes, in random places and aligned (faces, edges and corners on each other, half of them all but exactly).
//
// The overlaps lie between 1e-6 and 1e-2 of the smallest half size. Errors: of the overlap relative to the overlap, of the normal in rad,
// of the points X0, X1 and X2 (the largest) relative to the smallest half size, of the curvatures (the larger) relative to the curvature, but
// no smaller one than of the bounding sphere. The error of the reference is at most `referenceError`.
//
// The tables of README.md and docs/accuracy.md are pairs-short.md and pairs.md of SUPERQUADRIC_ACCURACY_TABLE=FOLDER.
#include "AccuracyTable.hpp"
#include "CommonScaling.hpp"
#include "RandomPairs.hpp"
#include "ReferenceContact.hpp"

#include <pkg/detection/PairContact.hpp>

#include <map>

#include <gtest/gtest.h>

using namespace superquadric;
using namespace superquadric::testing;

namespace {

constexpr int pairsEach = 100;
constexpr Real referenceError = 1e-10L;

// Of one set of pairs, an entry per solve.
struct Errors {
	std::vector<double> overlap, normal, point, curvature;

	void add(const Contact& contact, const Placement& body1, const Placement& body2, const ReferenceContact& reference)
	{
		const double smallest = std::min(body1.shape.smallestHalfSize(), body2.shape.smallestHalfSize());
		const auto off = [&](const Vector3& x, const RealVector& expected) { return double((x.cast<Real>() - body1.position.cast<Real>() - expected).norm()) / smallest; };
		overlap.push_back(double(std::abs(contact.overlap / reference.overlap - 1)));
		normal.push_back(double((contact.normal.cast<Real>() - reference.normal).norm()));
		point.push_back(std::max({ off(contact.point, reference.point), off(contact.surface1, reference.surface1), off(contact.surface2, reference.surface2) }));
		const auto bent = [](double curvature, Real expected, const Shape& shape) { return double(std::abs(curvature - expected) / std::max(expected, Real(1 / shape.boundingRadius()))); };
		curvature.push_back(std::max(bent(contact.curvature1, reference.curvature1, body1.shape), bent(contact.curvature2, reference.curvature2, body2.shape)));
	}
	void add(const Errors& other)
	{
		for (auto list : { &Errors::overlap, &Errors::normal, &Errors::point, &Errors::curvature })
			(this->*list).insert((this->*list).end(), (other.*list).begin(), (other.*list).end());
	}
	void writeTo(AccuracyTable& table) const
	{
		for (const std::vector<double>* errors : { &overlap, &normal, &point, &curvature })
			table << median(*errors) << worst(*errors);
		table.endRow();
	}
};

// The pair brought to overlap by about `depth` smallest half sizes, asked cold, after a small motion, and back in its place.
void ask(RandomPair& pair, Errors& errors)
{
	const Shape shape1(pair.sizes1, pair.n11, pair.n12), shape2(pair.sizes2, pair.n21, pair.n22);
	const double smallest = std::min(shape1.smallestHalfSize(), shape2.smallestHalfSize()), depth = smallest * pair.random.logarithmic(1e-6, 1e-2);
	const Placement body1 { shape1, pair.place, pair.rotation1 }, direction { shape2, pair.place + pair.along, pair.rotation2 };
	const double touching = double(1 / commonScaling<double>(body1, direction).middle());
	const Placement body2 { shape2, pair.place + pair.along * (touching - depth / pair.along.norm()), pair.rotation2 };
	const Placement moved { shape2, body2.position + 1e-3 * depth * pair.random.direction(), turn(1e-3 * depth, pair.random.direction()) * body2.rotation };

	const ReferenceContact reference = referenceContact(body1, body2);
	ASSERT_LT(reference.error, referenceError);
	WarmStart warm;
	SolverCounters counters;
	const Placement* const places[] = { &body2, &moved, &body2 };
	for (const Placement* second : places) {
		const Contact contact = contactPair(body1, *second, warm, counters);
		ASSERT_EQ(contact.status, Status::Overlap);
		if (second == &body2) errors.add(contact, body1, body2, reference);
	}
}

} // namespace

TEST(PairAccuracy, PointsNormalAndOverlapPerPairOfShapeClasses)
{
	const std::string quantities = "overlap: median | worst | normal [rad]: median | worst | points: median | worst | curvatures: median | worst";
	AccuracyTable full("shapes | place | " + quantities), summary("shape, with any of these | " + quantities);
	Errors all;
	std::map<std::string, Errors> withAny;
	for (const ShapeClass& one : shapeClasses)
		for (const ShapeClass* two = &one; two != std::end(shapeClasses); ++two)
			for (bool aligned : { false, true }) {
				const std::string names = std::string(one.name) + ", " + two->name, place = aligned ? "aligned" : "random";
				const std::uint64_t seed = std::uint64_t(&one - shapeClasses) * 10 + std::uint64_t(two - shapeClasses);
				Errors errors;
				for (std::uint64_t i = 0; i < pairsEach; ++i) {
					RandomPair pair(seed, 2 * i + aligned, one.exponents, two->exponents, aligned);
					ask(pair, errors);
					ASSERT_FALSE(HasFailure()) << place << " pair " << i << " of " << names;
				}
				full << names << place;
				errors.writeTo(full);
				all.add(errors);
				withAny[one.name].add(errors);
				if (two != &one) withAny[two->name].add(errors);
			}
	for (const ShapeClass& shape : shapeClasses) {
		summary << shape.name;
		withAny[shape.name].writeTo(summary);
	}
	full.writeTo("pairs.md");
	summary.writeTo("pairs-short.md");

	EXPECT_LT(worst(all.overlap), 1e-7); // of overlaps down to 1e-6: 1e-13 of the half size
	EXPECT_LT(worst(all.normal), 1e-10);
	EXPECT_LT(worst(all.point), 1e-8);
	EXPECT_LT(worst(all.curvature), 1e-5);
	EXPECT_LT(median(all.overlap), 1e-11);
	EXPECT_LT(median(all.normal), 1e-15);
	EXPECT_LT(median(all.point), 1e-14);
}
