#pragma once
// The suite `burl bench synthesis`: time and error of baking whole textures by every method,
// against the definition in float64; and what suites of whole textures share.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "atlas/base/named_files.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

struct BenchCommand;

/// Return the three channels, in linear light, of every texel that shows the mesh, row by row and
/// span by span, of every `step`-th row.
std::vector<double> color_values(const SolidAtlas& solid, const Image<Rgb8>& image,
                                 std::uint32_t step = 1);
std::vector<double> color_values(const SolidAtlas& solid, const Image<RgbF>& image,
                                 std::uint32_t step = 1);

/// Returns the colours of the recipe's definition (Hart et al. 1999, eq. 1 and 2, or its graph) in
/// float64, texel by texel and without filter.
std::vector<double> defined_colors(const SolidAtlas& solid, const Recipe& recipe,
                                   std::uint32_t step = 1);

/// The meshes and textures to measure.
struct SynthesisSubjects {
    std::optional<Mesh> mesh{};  ///< mesh; empty: a torus of 6,000 triangles
    std::vector<std::string> recipes{"marble", "wood", "clouds"};  ///< names of presets, or files
    std::size_t side = 1024;               ///< side of the textures in texels
    NamedFiles named = NamedFiles::below;  ///< where the images of recipes may lie
};

/// Returns what the command line asks for, with textures of `usual_side` unless it has a size.
SynthesisSubjects subjects_of(const BenchCommand& command, std::size_t usual_side);

/// Returns a preset or recipe file for a texture of side x side texels. Throws Error as
/// load_recipe() does, and invalid_file for images that lie elsewhere than `named` lets them.
Recipe sized_recipe(const std::string& name, std::size_t side,
                    NamedFiles named = NamedFiles::below);

/// Replaces the first noise term by one term per octave, in the same order; returns their number.
std::size_t take_apart(Texture& texture);

/// Returns the mean number of texels per span of an atlas with at least one span. That many texels
/// share the work per span (its start in the lattice, the choice of a kernel).
double mean_span(const SolidAtlas& solid);

/// Measures bakes in `repeats` paired rounds; mesh, layout and spans are not timed and no file is
/// written. Errors are of colours in linear light, over the texels that show the mesh; filters and
/// precisions are timed only. All results have texels_per_span. Throws Error for recipes that
/// cannot be read.
std::vector<BenchResult> bench_synthesis(int repeats, SynthesisSubjects subjects);

}  // namespace burl
