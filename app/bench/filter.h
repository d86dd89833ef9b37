#pragma once
// The suite `burl bench filter`: what each texel filter costs and how far it is from the mean over
// the texel, per texture and footprint (the error of eq. 9 of Hart et al. 1999, which the paper
// asks to be investigated).
#include <string>
#include <vector>

#include "app/bench/result.h"

namespace burl {

struct FilterBench {
    std::string texture;       ///< preset, or node of a checkerboard
    double footprint;          ///< texel side in cells, of the finest octave (zone plate: in 1/50)
    std::string filter;        ///< as --filter has it, or a checkerboard's own form; "grid:16" and
                               ///< "jitter:16" are unweighted samples
    double truth_noise = 0.0;  ///< of the mean of the texel that errors are against, RMS
    /// One thread, not timed for grid and jitter, which cost 16 times the first; errors of all
    /// channels in linear light.
    BenchResult result{};
};

/// `repeats` paired rounds of `side`^2 texels each for the times; errors are over 4,096 texels at
/// 64 places of the solid, the truth over 64 x 64 samples of each.
std::vector<FilterBench> bench_filters(int repeats, std::size_t side = 256);

}  // namespace burl
