#pragma once
// MIP levels worked out from the recipe instead of from the levels below them: a texel is the mean
// of a few samples of its own, each filtered over its part of it, so that a level costs the less
// the smaller it is and needs no finer one. How far each number of samples is from the surface's
// mean: docs/reference/filtering.md.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/image.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// How levels 1 and up come about: averaged from the level below, or direct.
struct LevelRule {
    bool direct = false;
    /// Of a direct level's texel: 1, 4, 16 or 64, in a regular grid.
    std::uint32_t samples = 16;
    bool operator==(const LevelRule&) const = default;
};

/// "average", "direct" or "direct:N". Throws Error(usage).
LevelRule level_rule_named(const std::string& name);
std::string to_string(const LevelRule& rule);

/// The level whose texels are samples of those of `level`: log4(samples) finer, but at least 0 and
/// at most last_source_level (atlas/build/block_levels.h).
std::uint32_t source_level(const MeshAtlas& atlas, const LevelRule& rule, std::uint32_t level);

/// The recipe that samples of levels above 0 are of: the 1999 model in float32 without a filter
/// takes `trapezoid`, all else stays as it is. (Nodes of graphs that filter leave out octaves,
/// which is further from the surface's mean than 16 samples are.)
Recipe sample_recipe(const Recipe& recipe);

/// A recipe's texture on an atlas in the recipe's space, in linear light.
using LevelSynthesis = std::function<Image<RgbF>(const SolidAtlas& solid, const Recipe& recipe)>;

/// Levels 1 to so many that are averaged from the recipe's texture.
using TextureMeans = std::function<std::vector<Image<RgbF>>(std::uint32_t levels)>;

/// Levels 1 to `levels` (at most down to 1 x 1). `solid` is the whole atlas, `texture` its texture,
/// which levels are averaged from whose samples are its texels: up to log4(samples).
std::vector<Image<RgbF>> direct_levels(const MeshAtlas& atlas, const SolidAtlas& solid,
                                       const Recipe& recipe, const Image<RgbF>& texture,
                                       std::uint32_t levels, const LevelRule& rule,
                                       const LevelSynthesis& synthesize);

/// The same where somebody else knows the texture; `means` is asked once at most.
std::vector<Image<RgbF>> direct_levels(const MeshAtlas& atlas, const SolidAtlas& solid,
                                       const Recipe& recipe, const TextureMeans& means,
                                       std::uint32_t levels, const LevelRule& rule,
                                       const LevelSynthesis& synthesize);

/// One of them, without the texture; 0 is the texture, beyond 1 x 1 there is only that.
Image<RgbF> direct_level(const MeshAtlas& atlas, const SolidAtlas& solid, const Recipe& recipe,
                         std::uint32_t level, const LevelRule& rule,
                         const LevelSynthesis& synthesize);

}  // namespace burl
