// The cost of contactPair alone, in ns a call, for the three ways in which a bed calls it:
//   warm      a pair that touches and touched at the last call
//   rejected  a pair that is apart, and whose remembered direction still proves it
//   cold      a pair that touches and is met for the first time
// Between two calls every pair moves as it would in a time step; 1,024 states are walked through in turn, so that no call finds
// its data and its branches as the one before left them. With --bed=FILE the pairs of a bed instead. See docs/benchmarks.md.
#include "BedReplay.hpp"
#include "NearPairs.hpp"

#include <pkg/detection/PairContact.hpp>

#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace superquadric::bench {

namespace {

	constexpr int pairCount = 512;
	constexpr std::uint64_t seed = 1;

	enum class Kind {
		Warm,
		Rejected,
		Cold,
	};
	constexpr std::pair<Kind, const char*> kinds[] = { { Kind::Warm, "warm" }, { Kind::Rejected, "rejected" }, { Kind::Cold, "cold" } };

	// A shape with its pairs, which are made when first needed: not at all for benchmarks that a filter leaves out.
	class Case {
	public:
		explicit Case(const Shape& shape)
		        : shape_(shape)
		{
		}

		const std::vector<MovingPair>& pairs(bool touching)
		{
			auto& made = touching ? touching_ : apart_;
			if (!made) made = nearPairs(shape_, touching ? touchingRange : apartRange, pairCount, seed);
			return *made;
		}

	private:
		Shape shape_;
		std::optional<std::vector<MovingPair>> touching_, apart_;
	};

	// Walks through `count` pairs again and again, at either moment in turn, and reports what the solver met. `solve(i, moment,
	// memory, counters)` solves pair i.
	template <class Solve> void walk(benchmark::State& state, std::size_t count, bool forget, Solve solve)
	{
		std::vector<WarmStart> memory(count);
		SolverCounters counters;
		for (std::size_t i = 0; i < count; ++i)
			solve(i, 0, memory[i], counters);
		counters = SolverCounters();
		std::size_t i = 0;
		int moment = 1;
		for (auto _ : state) {
			if (forget) memory[i] = WarmStart();
			benchmark::DoNotOptimize(solve(i, moment, memory[i], counters));
			if (++i == count) {
				i = 0;
				moment = 1 - moment;
			}
		}
		state.counters["pairs"] = double(count);
		state.counters["iterations"] = double(counters.iterations) / double(counters.solves);
		state.counters["fallbacks"] = double(counters.fallbacks) / double(counters.solves);
		state.counters["uncertified"] = double(counters.uncertified);
	}

	template <class Run> void add(const std::string& name, Run run) { benchmark::RegisterBenchmark(name.c_str(), run); }

	void addShape(const std::string& name, const Vector3& halfSizes, double n1, double n2)
	{
		const auto bodies = std::make_shared<Case>(Shape(halfSizes, n1, n2));
		for (const auto& [kind, word] : kinds)
			add(name + "/" + word, [bodies, kind = kind](benchmark::State& state) {
				const auto& pairs = bodies->pairs(kind != Kind::Rejected);
				walk(state, pairs.size(), kind == Kind::Cold, [&](std::size_t i, int moment, WarmStart& warm, SolverCounters& counters) {
					return contactPair(pairs[i].body1, pairs[i].body2[moment], warm, counters);
				});
			});
	}

	// As people write it: 2.5, but 8 without decimals.
	std::string text(double value)
	{
		std::ostringstream out;
		out << value;
		return out.str();
	}

	void addShapes()
	{
		const Vector3 equal(1, 1, 1);
		addShape("shape/cube 8-8", equal, 8, 8);
		addShape("shape/cylinder 8-2", equal, 8, 2);
		addShape("shape/odd 3.3-5.7", equal, 3.3, 5.7);
		addShape("shape/ellipsoid 2-2", Vector3(1, 0.8, 0.6), 2, 2);
		addShape("shape/sphere 2-2", equal, 2, 2);
		for (double n : { 2., 2.5, 3., 4., 5., 6., 8., 10., 12., 16., 20. })
			addShape("exponent/" + text(n), equal, n, n);
		for (double aspect : { 1., 1.5, 2., 3., 5., 7., 10. })
			addShape("aspect/" + text(aspect), Vector3(1, 1, aspect), 8, 8);
	}

	void addBed(const std::string& path)
	{
		const std::shared_ptr<BedReplay> bed = readBed(path);
		for (const auto& [pairs, word] : { std::pair { &bed->touching, "touching" }, std::pair { &bed->apart, "apart" } })
			add(std::string("bed/") + word, [bed, pairs = pairs](benchmark::State& state) {
				walk(state, pairs->size(), false, [&](std::size_t i, int moment, WarmStart& warm, SolverCounters& counters) {
					const auto& bodies = bed->moments[moment];
					return contactPair(bodies[(*pairs)[i].first], bodies[(*pairs)[i].second], warm, counters);
				});
			});
	}

} // namespace

} // namespace superquadric::bench

int main(int argc, char** argv)
{
	using namespace superquadric::bench;
	benchmark::Initialize(&argc, argv);
	const std::string option = "--bed=", rest = argc > 1 ? argv[1] : "";
	const bool bed = rest.compare(0, option.size(), option) == 0;
	if (benchmark::ReportUnrecognizedArguments(bed ? argc - 1 : argc, bed ? argv + 1 : argv)) return 2;
	try {
		bed ? addBed(rest.substr(option.size())) : addShapes();
	} catch (const std::exception& error) {
		std::cerr << argv[0] << ": " << error.what() << '\n';
		return 2;
	}
	benchmark::RunSpecifiedBenchmarks();
}
