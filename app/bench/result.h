#pragma once
// The result of every suite that compares run time with error, in one scheme, so that one reader
// and one plot (app/bench/plot.h) serve all suites.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "app/bench/bench.h"

namespace burl {

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
