// A functor's solver counters, one set per thread on a cache line of its own, so that counting costs next to nothing.
#pragma once

#include <pkg/detection/Contact.hpp>

#include <boost/python/dict.hpp>

#include <memory>
#ifdef YADE_OPENMP
#include <omp.h>
#endif

namespace yade {

class ThreadCounters {
public:
	superquadric::SolverCounters& ofThisThread() { return perThread[thread() % mostThreads].counters; }
	void reset() { perThread = std::make_unique<Slot[]>(mostThreads); }
	superquadric::SolverCounters sum() const
	{
		superquadric::SolverCounters total;
		for (int i = 0; i < mostThreads; ++i)
			total += perThread[i].counters;
		return total;
	}
	boost::python::dict asDict() const
	{
		const superquadric::SolverCounters total = sum();
		boost::python::dict result;
		result["solves"] = total.solves;
		result["stillApart"] = total.stillApart;
		result["rejectedBySphere"] = total.rejectedBySphere;
		result["rejectedByDirection"] = total.rejectedByDirection;
		result["rejectedByBox"] = total.rejectedByBox;
		result["coldStarts"] = total.coldStarts;
		result["iterations"] = total.iterations;
		result["fallbacks"] = total.fallbacks;
		result["uncertified"] = total.uncertified;
		return result;
	}

private:
	// YADE's number of threads may change at run time (O.numThreads), so the slots are not counted out to begin with.
	static constexpr int mostThreads = 256;
	struct alignas(64) Slot {
		superquadric::SolverCounters counters;
	};

	static int thread()
	{
#ifdef YADE_OPENMP
		return omp_get_thread_num();
#else
		return 0;
#endif
	}

	std::unique_ptr<Slot[]> perThread = std::make_unique<Slot[]>(mostThreads);
};

} // namespace yade
