#pragma once
// The suite `burl bench synthesis`: baking whole textures by every way there is, against the
// definition in float64.
#include <optional>
#include <string>
#include <vector>

#include "app/bench_result.h"
#include "atlas/mesh.h"

namespace burl {

struct SynthesisSubjects {
    std::optional<Mesh> mesh{};  ///< none: a torus of 6,000 triangles
    std::vector<std::string> recipes{"marble", "wood", "clouds"};  ///< presets or files
    std::size_t side = 1024;                                       ///< texels
};

/// Mesh, layout and spans are ready before the clock starts and nothing is written to a file;
/// `repeats` paired rounds. Errors are of colours in linear light, over the texels that show the
/// mesh; filters and precisions are timed only. Throws Error for recipes that cannot be
/// read.
std::vector<BenchResult> bench_synthesis(int repeats, SynthesisSubjects subjects);

}  // namespace burl
