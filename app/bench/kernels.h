#pragma once
// The suite `burl bench kernels`: the ways of computing lattice noise beside one another, by how
// many planes of the lattice a texel crosses. It is what the crossovers in
// procedural/octave_streams are taken from, and how far off they are.
#include <algorithm>
#include <string>
#include <vector>

namespace burl {

struct KernelBench {
    std::string noise;
    std::size_t span = 0;    ///< texels
    double crossings = 0.0;  ///< planes per texel, of the first octave
    /// ns per texel, medians, one thread.
    double direct = 0.0, share = 0.0, scanline = 0.0, automatic = 0.0;

    double best() const { return std::min({direct, share, scanline}); }
};

/// Spans of `span` texels in random directions, in `repeats` paired rounds. Coordinates, noise and
/// its sum are timed; no colours.
std::vector<KernelBench> bench_kernels(int repeats, std::size_t span);

}  // namespace burl
