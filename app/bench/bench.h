#pragma once
// Paired timing: the cases of a suite run in turn, A B C A B C ..., so that a machine whose speed
// drifts slows all of them alike; medians and ratios are reported. Suites that compare run time
// with error report both in one scheme.
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/json_text.h"

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

/// Errors of values with a peak of 1 against the float64 reference.
struct BenchError {
    double max = 0.0, rms = 0.0;
    /// Computes the errors of at least one value; both spans must have the same length.
    static BenchError of(std::span<const double> values, std::span<const double> reference);
    /// The PSNR in dB; infinite without an error.
    double psnr() const;
};

/// The time and the errors of one method.
struct BenchResult {
    BenchRow time;  ///< has the result's group and name; no rounds: not timed
    std::optional<BenchError> error{};
    /// Mean number of texels per span of the texture baked; empty where a suite bakes none.
    std::optional<double> texels_per_span{};
};

/// Returns the JSON of a result: group, method, unit, ns_median, ns_lowest, ns_highest (per unit),
/// times_first (median over the rounds of the time divided by that of the group's first method),
/// error_max, error_rms, psnr, and texels_per_span where the suite has it; null where a number is
/// unknown or infinite.
Json result_json(const BenchResult& result);

/// Returns the processor's name, its number of threads and the instruction set of the kernels.
Json machine_json();

/// Formats a table per group; its header gives the texels per span of the group's first result.
std::string result_table(std::span<const BenchResult> results);

}  // namespace burl
