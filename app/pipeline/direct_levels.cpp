#include "app/pipeline/direct_levels.h"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/level.h"

namespace burl {

namespace {

constexpr std::array<std::uint32_t, 4> sample_counts{1, 4, 16, 64};

/// The number of the level of 1 x 1 texels.
std::uint32_t last_of(const SolidAtlas& solid) {
    return std::uint32_t(std::bit_width(solid.size)) - 1;
}

/// Synthesises level `source` >= 1 by the recipe of samples.
Image<RgbF> samples(const SolidAtlas& solid, const Recipe& recipe, std::uint32_t source,
                    const LevelSynthesis& synthesize) {
    return synthesize(solid_level(solid, source), sample_recipe(recipe));
}

}  // namespace

LevelRule level_rule_named(const std::string& name) {
    if (name == "average") return {};
    if (name == "sharp") return {.sharp = true};
    if (name == "direct") return {.direct = true};
    for (const std::uint32_t count : sample_counts)
        if (name == fmt::format("direct:{}", count)) return {.direct = true, .samples = count};
    throw Error(ExitCode::usage,
                fmt::format("MIP levels by {}: must be average, sharp, direct or direct:N, N "
                            "being 1, 4, 16 or 64 samples a texel",
                            name));
}

std::string to_string(const LevelRule& rule) {
    if (rule.direct) return fmt::format("direct:{}", rule.samples);
    return rule.sharp ? "sharp" : "average";
}

std::uint32_t source_level(const MeshAtlas& atlas, const LevelRule& rule, std::uint32_t level) {
    const auto finer = std::uint32_t(std::countr_zero(rule.samples)) / 2;
    return std::min(level - std::min(level, finer), last_source_level(atlas));
}

Recipe sample_recipe(const Recipe& recipe) {
    Recipe result = recipe;
    const bool plain = plain_texture(recipe.texture) && recipe.filter.kind == FilterKind::none;
    if (plain && recipe.precision.kind.value_or(PrecisionKind::float32) == PrecisionKind::float32)
        result.filter.kind = FilterKind::trapezoid;
    return result;
}

std::vector<Image<RgbF>> direct_levels(const MeshAtlas& atlas, const SolidAtlas& solid,
                                       const Recipe& recipe, const Image<RgbF>& texture,
                                       std::uint32_t levels, const LevelRule& rule,
                                       const LevelSynthesis& synthesize) {
    const TextureMeans means = [&](std::uint32_t last) {
        return block_levels(atlas, texture, last);
    };
    return direct_levels(atlas, solid, recipe, means, levels, rule, synthesize);
}

std::vector<Image<RgbF>> direct_levels(const MeshAtlas& atlas, const SolidAtlas& solid,
                                       const Recipe& recipe, const TextureMeans& means,
                                       std::uint32_t levels, const LevelRule& rule,
                                       const LevelSynthesis& synthesize) {
    levels = std::min(levels, last_of(solid));
    std::vector<Image<RgbF>> result;
    while (result.size() < levels) {
        const auto next = std::uint32_t(result.size()) + 1;
        const std::uint32_t source = source_level(atlas, rule, next);
        std::uint32_t end = next;  // the last level that has `source` as its source
        while (end < levels && source_level(atlas, rule, end + 1) == source) ++end;
        if (source == 0) {
            result = means(end);
            continue;
        }
        Image<RgbF> finest = samples(solid, recipe, source, synthesize);
        std::vector<Image<RgbF>> averaged = block_levels(atlas, finest, end, source);
        if (source == next) result.push_back(std::move(finest));
        for (std::size_t l = result.size() + 1; l <= end; ++l)
            result.push_back(std::move(averaged[l - source - 1]));
    }
    return result;
}

Image<RgbF> direct_level(const MeshAtlas& atlas, const SolidAtlas& solid, const Recipe& recipe,
                         std::uint32_t level, const LevelRule& rule,
                         const LevelSynthesis& synthesize) {
    level = std::min(level, last_of(solid));
    const std::uint32_t source = source_level(atlas, rule, level);
    Image<RgbF> finest =
        source == 0 ? synthesize(solid, recipe) : samples(solid, recipe, source, synthesize);
    if (source == level) return finest;
    return std::move(block_levels(atlas, finest, level, source).back());
}

}  // namespace burl
