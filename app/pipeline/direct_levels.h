#pragma once
// MIP levels synthesised from the recipe instead of averaged from finer levels: a texel is the mean
// of a few samples, each filtered over its part of the texel, so that a level's cost falls with its
// size and no finer level is needed. docs/reference/filtering.md gives the distance from the
// surface's mean for each number of samples.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Rule of MIP levels 1 and up: averaged from the level below, averaged and then sharpened
/// (atlas/base/sharp_level.h), or direct.
struct LevelRule {
    bool direct = false;
    bool sharp = false;  ///< not of direct levels
    /// The number of samples of a direct level's texel, in a regular grid: 1, 4, 16 or 64.
    std::uint32_t samples = 16;
    bool operator==(const LevelRule&) const = default;
};

/// The rule named "average", "sharp", "direct" (16 samples) or "direct:N". Throws Error(usage) for
/// other names.
LevelRule level_rule_named(const std::string& name);
/// The name that level_rule_named takes.
std::string to_string(const LevelRule& rule);

/// The level whose texels are the samples of `level`: log4(samples) levels finer, but at least 0
/// and at most last_source_level (atlas/build/block_levels.h).
std::uint32_t source_level(const MeshAtlas& atlas, const LevelRule& rule, std::uint32_t level);

/// The recipe by which the samples of levels above 0 are synthesised: the 1999 model in float32
/// without a filter gets the filter `trapezoid`, every other recipe is unchanged. (Filtered graph
/// nodes leave out octaves, which is further from the surface's mean than 16 samples are.)
Recipe sample_recipe(const Recipe& recipe);

/// Synthesises a recipe's texture, in linear light, on an atlas in the recipe's space.
using LevelSynthesis = std::function<Image<RgbF>(const SolidAtlas& solid, const Recipe& recipe)>;

/// Gives the levels 1 to `levels`, averaged from the recipe's texture.
using TextureMeans = std::function<std::vector<Image<RgbF>>(std::uint32_t levels)>;

/// The direct levels 1 to `levels` (at most down to 1 x 1). `solid` is the whole atlas and
/// `texture` its texture in linear light; levels up to log4(samples), whose samples are the
/// texture's texels, are averaged from it.
std::vector<Image<RgbF>> direct_levels(const MeshAtlas& atlas, const SolidAtlas& solid,
                                       const Recipe& recipe, const Image<RgbF>& texture,
                                       std::uint32_t levels, const LevelRule& rule,
                                       const LevelSynthesis& synthesize);

/// The direct levels 1 to `levels` without the texture in memory: `means` gives the levels whose
/// samples are the texture's texels, and is called once at most.
std::vector<Image<RgbF>> direct_levels(const MeshAtlas& atlas, const SolidAtlas& solid,
                                       const Recipe& recipe, const TextureMeans& means,
                                       std::uint32_t levels, const LevelRule& rule,
                                       const LevelSynthesis& synthesize);

/// One direct level, synthesised without any finer level than its samples' one. Level 0 is the
/// texture; numbers beyond the 1 x 1 level give that level.
Image<RgbF> direct_level(const MeshAtlas& atlas, const SolidAtlas& solid, const Recipe& recipe,
                         std::uint32_t level, const LevelRule& rule,
                         const LevelSynthesis& synthesize);

}  // namespace burl
