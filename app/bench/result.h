#pragma once
// What every suite that sets run time against error reports, in one scheme, so that one reader and
// one plot (app/bench/plot.h) do for all of them.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "app/bench/bench.h"

namespace burl {

/// Against the float64 reference; what is compared has a peak of 1.
struct BenchError {
    double max = 0.0, rms = 0.0;
    /// Over pairs of equally many values, at least one.
    static BenchError of(std::span<const double> values, std::span<const double> reference);
    /// dB; infinite without an error.
    double psnr() const;
};

struct BenchResult {
    BenchRow time;  ///< its group and name are the result's; no rounds: not timed
    std::optional<BenchError> error{};
    /// Mean over the spans of the texture it baked; suites without one have none.
    std::optional<double> texels_per_span{};
};

/// group, method, unit, ns_median, ns_lowest, ns_highest (per unit), times_first (the median over
/// the rounds of its time over that of its group's first method), error_max, error_rms, psnr; null
/// where something is not known or infinite; texels_per_span, where the suite has it.
Json result_json(const BenchResult& result);

/// The processor's name, how many threads it has and the instruction set the kernels use.
Json machine_json();

/// A table per group, for people; under its header how long its first result's spans are.
std::string result_table(std::span<const BenchResult> results);

}  // namespace burl
