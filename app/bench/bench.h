#pragma once
// Paired timing: the cases of a suite run in turn, A B C A B C ..., so that a machine whose speed
// drifts slows all of them alike; medians and ratios are reported.
#include <functional>
#include <string>
#include <vector>

namespace burl {

/// A piece of work to be timed.
struct BenchCase {
    std::string name;
    double units = 1.0;  ///< work per run, in `unit`s
    std::string unit;    ///< name of the unit, such as "face" or "texel"
    std::function<void()> run;
    std::string group{};  ///< only cases of the same group are compared
};

/// The times of a case.
struct BenchRow {
    std::string name, unit;
    double units = 0.0;
    double median = 0.0, lowest = 0.0, highest = 0.0;  ///< seconds per run
    std::string group{};
    int rounds = 0;  ///< number of rounds; 0: not timed
    /// Median over the rounds of the time divided by that of the group's first case.
    double times_first = 0.0;
    double ns_per_unit() const { return median * 1e9 / units; }
};

/// Runs every case once to warm up, then `repeats` rounds of all cases.
std::vector<BenchRow> run_paired(const std::vector<BenchCase>& cases, int repeats);

/// The names of the suites made by bench_suite(); each other suite has a file of its own.
const std::vector<std::string>& bench_suites();

/// The cases of a suite; `size` is its size (faces for mesh_io), 0 the suite's default.
std::vector<BenchCase> bench_suite(const std::string& suite, std::size_t size);

}  // namespace burl
