#pragma once
// Paired timing: the cases of a suite run in turn, A B C A B C ..., so that a machine whose speed
// drifts slows them all alike, and medians and ratios are what is reported.
#include <functional>
#include <string>
#include <vector>

namespace burl {

struct BenchCase {
    std::string name;
    double units = 1.0;  ///< work per run, e.g. faces or texels
    std::string unit;    ///< "face", "texel"
    std::function<void()> run;
    std::string group{};  ///< cases that are compared with one another
};

struct BenchRow {
    std::string name, unit;
    double units = 0.0;
    double median = 0.0, lowest = 0.0, highest = 0.0;  ///< seconds per run
    std::string group{};
    int rounds = 0;            ///< 0: not timed
    double times_first = 0.0;  ///< median over the rounds of its time over its group's first case's
    double ns_per_unit() const { return median * 1e9 / units; }
};

/// One warm-up of each, then `repeats` rounds.
std::vector<BenchRow> run_paired(const std::vector<BenchCase>& cases, int repeats);

/// Names of the suites that bench_suite has; the others have files of their own.
const std::vector<std::string>& bench_suites();

/// The cases of a suite at a size (faces for mesh_io); 0 takes the suite's own.
std::vector<BenchCase> bench_suite(const std::string& suite, std::size_t size);

}  // namespace burl
