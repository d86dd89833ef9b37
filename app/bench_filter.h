#pragma once
// The suite `burl bench filter`: what each texel filter costs and how far it is from the mean over
// the texel, per texture and footprint (the error of eq. 9 of Hart et al. 1999, which the paper
// asks to be investigated).
#include <string>
#include <vector>

#include "procedural/texture.h"

namespace burl {

struct FilterBench {
    std::string texture;        ///< preset, or node of a checkerboard
    double footprint;           ///< texel side in cells, of the finest octave (zone plate: in 1/50)
    std::string filter;         ///< as --filter has it, or a checkerboard's own form; "grid:16" and
                                ///< "jitter:16" are unweighted samples
    double rmse = 0.0;          ///< against the mean of the texel, linear light, all channels
    double truth_noise = 0.0;   ///< of that mean itself, RMS
    double ns_per_texel = 0.0;  ///< median, one thread; 0 for grid and jitter
    double cost = 0.0;          ///< over that of `none` in the same rounds; 16 for grid and jitter
};

/// `repeats` paired rounds of `side`^2 texels each for the times; errors are over 4,096 texels at
/// 64 places of the solid, the truth over 64 x 64 samples of each.
std::vector<FilterBench> bench_filters(int repeats, std::size_t side = 256);

}  // namespace burl
