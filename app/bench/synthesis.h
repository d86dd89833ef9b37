#pragma once
// The suite `burl bench synthesis`: baking whole textures by every way there is, against the
// definition in float64.
#include <optional>
#include <string>
#include <vector>

#include "app/bench/result.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

struct SynthesisSubjects {
    std::optional<Mesh> mesh{};  ///< none: a torus of 6,000 triangles
    std::vector<std::string> recipes{"marble", "wood", "clouds"};  ///< presets or files
    std::size_t side = 1024;                                       ///< texels
};

/// Texels per span, the mean over all spans; at least one. What is done per span (its start in the
/// lattice, the choice of a kernel) is shared by so many texels.
double mean_span(const SolidAtlas& solid);

/// Mesh, layout and spans are ready before the clock starts and nothing is written to a file;
/// `repeats` paired rounds. Errors are of colours in linear light, over the texels that show the
/// mesh; filters and precisions are timed only. All results have texels_per_span. Throws Error for
/// recipes that cannot be read.
std::vector<BenchResult> bench_synthesis(int repeats, SynthesisSubjects subjects);

}  // namespace burl
