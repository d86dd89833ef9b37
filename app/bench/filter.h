#pragma once
// The suite `burl bench filter`: cost and error of each texel filter against the mean over the
// texel, by texture and footprint (the error of eq. 9 of Hart et al. 1999, which the paper leaves
// to be investigated).
#include <string>
#include <vector>

#include "app/bench/result.h"

namespace burl {

/// The results of a filter.
struct FilterBench {
    std::string texture;  ///< preset, or node of a checkerboard
    /// Side of a texel in cells of the finest octave (zone plate: in units of 1/50).
    double footprint;
    /// Value of --filter, or a form of a checkerboard's node; "grid:16" and "jitter:16" are
    /// unweighted samples.
    std::string filter;
    double truth_noise = 0.0;  ///< RMS error of the reference, the sampled mean over a texel
    /// Times are on one thread; grid and jitter are not timed, as they cost 16 times the first
    /// filter. Errors are over all channels in linear light.
    BenchResult result{};
};

/// Times are of `side`^2 texels in `repeats` paired rounds. Errors are over 4,096 texels at 64
/// places of the solid, against the mean of 64 x 64 samples of each.
std::vector<FilterBench> bench_filters(int repeats, std::size_t side = 256);

}  // namespace burl
