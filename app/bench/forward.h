#pragma once
// The suite `burl bench forward`: what forward differences cost and how far they are from exact,
// beside direct evaluation, and the cubes of "Bresenham Noise" (Kameya & Hart, table 1): the
// paper's comparison on today's machine, and its open questions.
#include <cstdint>
#include <string>
#include <vector>

namespace burl {

struct ForwardBench {
    std::string function;  ///< noise by its fade; "marble ...": a ramp and four octaves of it
    std::string method;
    double step = 0.0;          ///< texel in cells of the first octave
    double ns_per_texel = 0.0;  ///< median, one thread
    double error = 0.0;         ///< largest against float64 at the same points
    double cells_per_texel = 0.0, runs_per_texel = 0.0;  ///< 0 for direct evaluation
};

/// Lines of 1,024 texels in random directions near the origin, in `repeats` paired rounds; by
/// function, then method, then step.
std::vector<ForwardBench> bench_forward(int repeats);

/// Three faces of the paper's cube.
struct CubeBench {
    std::string texture, method;
    double milliseconds = 0.0;
    double error = 0.0;                ///< largest against float64, in f
    std::int64_t other_codes = 0;      ///< texels with another sRGB8 colour than by float64
    int largest_step = 0;              ///< most that one of their channels differs
    std::int64_t cells = 0, runs = 0;  ///< of all faces
};

/// Wood (23) and marble (24), `side`^2 texels a face.
std::vector<CubeBench> bench_forward_cubes(int repeats, std::size_t side = 256);

/// How errors grow on the way through a cell (the paper's figures 10 and 11): 256 texels from
/// (0, 0, 0) to (2, 2, 2), differences computed only at cells' first texels.
struct GrowthBench {
    std::string noise, precision;
    double frequency = 1.0;  ///< cells per unit
    struct Error {
        std::size_t texel = 0;  ///< of its cell, from 0
        double largest = 0.0;   ///< over 64 seeds
    };
    std::vector<Error> errors;
};

std::vector<GrowthBench> bench_forward_growth();

}  // namespace burl
