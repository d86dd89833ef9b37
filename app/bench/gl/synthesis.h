#pragma once
// The suite `burl bench gl`: a texture of the 1999 model made by the host, in one pass and in the
// papers' passes on OpenGL, by octaves and size: times once warm, time of the first picture, and
// the error against the definition in float64.
#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/bench.h"

namespace burl {

/// Parts of the time to make a texture: seconds, medians over the rounds.
struct GlBenchParts {
    double gpu = 0.0;       ///< drawing, by OpenGL's timer query; 0: not available
    double draw = 0.0;      ///< drawing, by the host's clock
    double transfer = 0.0;  ///< reading back and packing
};

/// Parts of the time to the first picture in host memory, from scratch, in seconds.
struct GlColdStart {
    double context = 0.0;  ///< library, context and OpenGL functions
    double compile = 0.0;  ///< shaders, as far as linking compiles them
    double maps = 0.0;     ///< solid coordinates of all texels
    double draw = 0.0;     ///< the first draws, in which drivers finish compiling
    double total = 0.0;    ///< sum of all parts and of the transfer
};

/// The results of one method.
struct GlBench {
    /// Time per texel of 8-bit sRGB in host memory, with maps and programs cached.
    BenchResult result;
    std::uint32_t octaves = 0, side = 0;
    int passes = 0;  ///< draws per texture; 0: made by the host
    GlBenchParts parts{};
    GlColdStart cold{};
};

/// All results of the suite.
struct GlBenchReport {
    std::string opengl;  ///< GlContext::description
    std::vector<GlBench> rows;
};

/// The sizes and octaves to measure.
struct GlBenchSubjects {
    std::vector<std::uint32_t> sides{256, 1024};  ///< sides of the textures in texels
    std::vector<std::uint32_t> octaves{1, 4, 8};
};

/// Measures marble on a torus, and the MIP levels of such textures, in `repeats` paired rounds.
/// Errors are of colours in linear light (for MIP levels, against the host's), over every texel up
/// to 1024 x 1024 and over as many texels in whole rows beyond. Throws Error as create_gl_context
/// does.
GlBenchReport bench_gl(const std::string& platform, int repeats, const GlBenchSubjects& subjects);

}  // namespace burl
