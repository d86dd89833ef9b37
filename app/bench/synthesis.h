#pragma once
// The suite `burl bench synthesis`: time and error of baking whole textures by every method,
// against the definition in float64.
#include <optional>
#include <string>
#include <vector>

#include "app/bench/result.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The meshes and textures to measure.
struct SynthesisSubjects {
    std::optional<Mesh> mesh{};  ///< mesh; empty: a torus of 6,000 triangles
    std::vector<std::string> recipes{"marble", "wood", "clouds"};  ///< names of presets, or files
    std::size_t side = 1024;  ///< side of the textures in texels
};

/// Returns the mean number of texels per span of an atlas with at least one span. That many texels
/// share the work per span (its start in the lattice, the choice of a kernel).
double mean_span(const SolidAtlas& solid);

/// Measures bakes in `repeats` paired rounds; mesh, layout and spans are not timed and no file is
/// written. Errors are of colours in linear light, over the texels that show the mesh; filters and
/// precisions are timed only. All results have texels_per_span. Throws Error for recipes that
/// cannot be read.
std::vector<BenchResult> bench_synthesis(int repeats, SynthesisSubjects subjects);

}  // namespace burl
