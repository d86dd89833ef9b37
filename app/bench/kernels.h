#pragma once
// The suite `burl bench kernels`: the kernels for lattice noise side by side, by the number of
// lattice planes crossed per texel. The crossovers in procedural/field/octave_streams are taken
// from it, and it shows how far off they are.
#include <algorithm>
#include <string>
#include <vector>

namespace burl {

/// Times of the kernels for one noise, span length and number of crossings.
struct KernelBench {
    std::string noise;
    std::size_t span = 0;    ///< length of a span in texels
    double crossings = 0.0;  ///< lattice planes of the first octave crossed per texel
    /// Median times in ns per texel on one thread, by kernel.
    double direct = 0.0, share = 0.0, scanline = 0.0, automatic = 0.0;

    double best() const { return std::min({direct, share, scanline}); }
};

/// Measures spans of `span` texels in random directions, in `repeats` paired rounds. The time
/// includes coordinates, noise and its sum, and no colours.
std::vector<KernelBench> bench_kernels(int repeats, std::size_t span);

}  // namespace burl
