#pragma once
// The suite `burl bench gl`: a texture of the 1999 model made by the host, in one pass and in the
// papers' passes on OpenGL, by octaves and size: how long each takes once it is warm, how long the
// first picture took, and how far it is from the definition in float64.
#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/result.h"

namespace burl {

/// Seconds; medians of the rounds.
struct GlBenchParts {
    double gpu = 0.0;       ///< drawing, by OpenGL's clock; 0: it has none
    double draw = 0.0;      ///< drawing, by the host's clock
    double transfer = 0.0;  ///< reading back and packing
};

/// Seconds from nothing to the first picture in host memory.
struct GlColdStart {
    double context = 0.0;  ///< library, context and its functions
    double compile = 0.0;  ///< shaders, as far as linking does it
    double maps = 0.0;     ///< solid coordinates of all texels
    double draw = 0.0;     ///< first draws; drivers finish compiling here
    double total = 0.0;    ///< all these and reading back
};

struct GlBench {
    BenchResult result;  ///< texels; 8-bit sRGB into host memory, maps and programs kept
    std::uint32_t octaves = 0, side = 0;
    int passes = 0;  ///< draws a texture; 0: of the host
    GlBenchParts parts{};
    GlColdStart cold{};
};

struct GlBenchReport {
    std::string opengl;  ///< GlContext::description
    std::vector<GlBench> rows;
};

struct GlBenchSubjects {
    std::vector<std::uint32_t> sides{256, 1024};  ///< texels
    std::vector<std::uint32_t> octaves{1, 4, 8};
};

/// Marble on a torus, and the MIP levels of such textures: `repeats` paired rounds. Errors are of
/// colours in linear light (of levels: against the host's), over every texel up to 1024 x 1024 and
/// over as many in whole rows beyond. Throws Error as create_gl_context.
GlBenchReport bench_gl(const std::string& platform, int repeats, const GlBenchSubjects& subjects);

}  // namespace burl
