#pragma once
// The suite `burl bench forward`: cost and error of forward differences beside direct evaluation,
// and the cubes of "Bresenham Noise" (Kameya & Hart 2000, table 1): the paper's comparison on
// today's machine, and its open questions.
#include <cstdint>
#include <string>
#include <vector>

namespace burl {

/// The results of one method at one step.
struct ForwardBench {
    /// Name of the noise's fade; "marble ...": a ramp and four octaves of it.
    std::string function;
    std::string method;
    double step = 0.0;          ///< side of a texel in cells of the first octave
    double ns_per_texel = 0.0;  ///< median, one thread
    double error = 0.0;         ///< largest error against float64 at the same points
    double cells_per_texel = 0.0, runs_per_texel = 0.0;  ///< 0 for direct evaluation
};

/// Measures lines of 1,024 texels in random directions near the origin, in `repeats` paired rounds.
/// Rows are ordered by function, method and step.
std::vector<ForwardBench> bench_forward(int repeats);

/// The results for three faces of the paper's cube.
struct CubeBench {
    std::string texture, method;
    double milliseconds = 0.0;
    double error = 0.0;                ///< largest error of f against float64
    std::int64_t other_codes = 0;      ///< texels whose sRGB8 colour differs from that in float64
    int largest_step = 0;              ///< largest difference of a channel, in codes
    std::int64_t cells = 0, runs = 0;  ///< number over all faces
};

/// Measures wood (eq. 23) and marble (eq. 24), `side`^2 texels per face.
std::vector<CubeBench> bench_forward_cubes(int repeats, std::size_t side = 256);

/// The growth of errors along a cell (the paper's figures 10 and 11): 256 texels from (0, 0, 0) to
/// (2, 2, 2), with differences computed anew only at the first texel of a cell.
struct GrowthBench {
    std::string noise, precision;
    double frequency = 1.0;  ///< cells per unit
    /// The error at one texel of the cells.
    struct Error {
        std::size_t texel = 0;  ///< index of the texel in its cell, from 0
        double largest = 0.0;   ///< largest error over 64 seeds
    };
    std::vector<Error> errors;
};

/// Measures the growth for all fades, precisions and two frequencies.
std::vector<GrowthBench> bench_forward_growth();

}  // namespace burl
