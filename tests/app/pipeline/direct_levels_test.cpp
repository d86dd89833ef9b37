// Direct levels against means over grids of samples made texel by texel, and against the surface.
#include "app/pipeline/direct_levels.h"
#include "app/recipe/edit/recipe_json.h"

#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/bake/texture.h"
#include "app/base/embedded.h"
#include "app/measure/metric_texture.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/sharp_level.h"
#include "atlas/build/block_levels.h"
#include "tests/atlas/support/made_meshes.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

double wave(const Vec3d& p) {
    return 0.5 + 0.5 * std::sin(40.0 * p.x + 25.0 * p.y - 31.0 * p.z);
}

/// Point samples of wave, and the sides of the atlases that were asked for.
struct Waves {
    std::vector<std::uint32_t> sides{};
    std::vector<FilterKind> filters{};

    Image<RgbF> operator()(const SolidAtlas& solid, const Recipe& recipe) {
        sides.push_back(solid.size);
        filters.push_back(recipe.filter.kind);
        Image<RgbF> image(solid.size, solid.size);
        for (std::uint32_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    image(x, y).g = float(wave(solid.maps[span.map](x, y)));
        return image;
    }
};

struct SampledSurface {
    Mesh mesh = made::ring(24, 12);
    MeshAtlas atlas;
    SolidAtlas solid;
    Recipe recipe;

    SampledSurface(AtlasKind kind, std::uint32_t size)
        : atlas(build_atlas(mesh, build_connectivity(mesh),
                            {.kind = kind, .size = size, .tries = 1})),
          solid(rasterize(mesh, atlas, atlas.mesh(mesh).positions)) {}

    /// The value that the map which owns a place shows there; in texels, not on a texel's side.
    double at(double x, double y) const {
        for (const Span& span : solid.row(std::size_t(y)))
            if (x >= span.x && x < span.x + span.count) {
                const TexelMap& map = solid.maps[span.map];
                return wave(map.origin + (x - 0.5 - map.anchor_x) * map.step_x +
                            (y - 0.5 - map.anchor_y) * map.step_y);
            }
        return 0.0;
    }
};

LevelRule direct(std::uint32_t samples = 16) {
    return {.direct = true, .samples = samples};
}

// Centres of samples lie on texels' sides, half of which are anybody's: their owner is the one of
// higher x and y.
TEST(DirectLevels, TexelsAreMeansOfARegularGridOfSamples) {
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad, AtlasKind::area}) {
        const std::uint32_t size = kind == AtlasKind::patch ? 512 : 256;
        SampledSurface s(kind, size);
        const std::uint32_t level = s.atlas.patches() ? last_source_level(s.atlas) : 3;
        ASSERT_GE(level, 2u);
        const std::uint32_t width = size >> level, scale = 1 << level;
        for (const std::uint32_t samples : {1u, 4u, 16u, 64u}) {
            const auto side = std::uint32_t(std::lround(std::sqrt(samples)));
            if (side > 1u << level) continue;
            ASSERT_EQ(source_level(s.atlas, direct(samples), level), level - std::log2(side));
            Waves waves;
            const Image<RgbF> image =
                direct_level(s.atlas, s.solid, s.recipe, level, direct(samples), std::ref(waves));
            ASSERT_EQ(image.width(), width);
            for (std::uint32_t y = 0; y < width; y += 3)
                for (std::uint32_t x = 0; x < width; ++x) {
                    double sum = 0.0;
                    for (std::uint32_t j = 0; j < side; ++j)
                        for (std::uint32_t i = 0; i < side; ++i)
                            sum += s.at(scale * (x + (i + 0.5) / side),
                                        scale * (y + (j + 0.5) / side));
                    EXPECT_NEAR(image(x, y).g, sum / samples, 1e-6)
                        << to_string(kind) << samples << ": " << x << ", " << y;
                }
        }
    }
}

TEST(DirectLevels, WorkOutNoMoreTexelsThanTheySample) {
    SampledSurface s(AtlasKind::patch, 512);
    ASSERT_EQ(last_source_level(s.atlas), 2u);  // gutters are 4 texels wide
    const Image<RgbF> texture(512, 512);
    const auto sides = [&](std::uint32_t samples) {
        Waves waves;
        direct_levels(s.atlas, s.solid, s.recipe, texture, 99, direct(samples), std::ref(waves));
        return waves.sides;
    };
    using Sides = std::vector<std::uint32_t>;
    EXPECT_EQ(sides(1), (Sides{256, 128}));  // further levels are means of the last
    EXPECT_EQ(sides(4), (Sides{256, 128}));
    EXPECT_EQ(sides(16), (Sides{256, 128}));
    EXPECT_EQ(sides(64), (Sides{256, 128}));
    for (const std::uint32_t level : {1u, 2u, 5u}) {
        Waves waves;
        direct_level(s.atlas, s.solid, s.recipe, level, direct(4), std::ref(waves));
        EXPECT_EQ(waves.sides, Sides{512u >> std::min(level - 1, 2u)});
    }
}

TEST(DirectLevels, OneByOneTheyAreTheSame) {
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad})
        for (const std::uint32_t samples : {1u, 4u, 16u}) {
            SampledSurface s(kind, 128);
            Waves waves;
            const Image<RgbF> texture = waves(s.solid, s.recipe);
            const auto all = direct_levels(s.atlas, s.solid, s.recipe, texture, 99, direct(samples),
                                           std::ref(waves));
            ASSERT_EQ(all.size(), 7u);
            for (std::uint32_t l = 1; l <= 7; ++l) {
                ASSERT_EQ(all[l - 1].width(), 128u >> l);
                EXPECT_EQ(all[l - 1], direct_level(s.atlas, s.solid, s.recipe, l, direct(samples),
                                                   std::ref(waves)))
                    << to_string(kind) << samples << ": " << l;
            }
            EXPECT_EQ(texture, direct_level(s.atlas, s.solid, s.recipe, 0, direct(samples),
                                            std::ref(waves)));
        }
}

TEST(DirectLevels, SamplesAreFilteredWhereThatIsExact) {
    SampledSurface s(AtlasKind::quad, 128);
    const auto filter_of = [&](const Recipe& recipe, std::uint32_t level) {
        Waves waves;
        direct_level(s.atlas, s.solid, recipe, level, direct(1), std::ref(waves));
        return waves.filters.at(0);
    };
    const Recipe marble = load_recipe("marble"),
                 checks = load_recipe("checks", {"filter.kind=none"});
    EXPECT_EQ(filter_of(marble, 1), FilterKind::trapezoid);
    EXPECT_EQ(filter_of(marble, 0), FilterKind::none);
    EXPECT_EQ(filter_of(checks, 1), FilterKind::none);
    EXPECT_EQ(filter_of(load_recipe("marble", {"filter.kind=supersample"}), 1),
              FilterKind::supersample);
    EXPECT_EQ(filter_of(load_recipe("marble", {"precision.kind=fixed"}), 1), FilterKind::none);
}

TEST(DirectLevels, RulesHaveNames) {
    EXPECT_EQ(level_rule_named("average"), LevelRule{});
    EXPECT_EQ(level_rule_named("sharp"), LevelRule{.sharp = true});
    EXPECT_EQ(to_string(LevelRule{.sharp = true}), "sharp");
    EXPECT_EQ(level_rule_named("direct"), direct(16));
    for (const std::uint32_t samples : {1u, 4u, 16u, 64u}) {
        EXPECT_EQ(level_rule_named(fmt::format("direct:{}", samples)), direct(samples));
        EXPECT_EQ(to_string(direct(samples)), fmt::format("direct:{}", samples));
    }
    for (const char* bad :
         {"", "Direct", "direct:", "direct:2", "direct:016", "average:4", "sharp:2"})
        EXPECT_THROW(level_rule_named(bad), Error) << bad;
}

TEST(LevelsAsked, NameTheirRule) {
    const auto asked = [](const char* levels, const char* rule) {
        return levels_asked(levels, rule, 256, ImageKind::rgb8);
    };
    const auto expect = [&](const char* levels, const char* rule, std::uint32_t count,
                            const LevelRule& expected) {
        const LevelsAsked result = asked(levels, rule);
        EXPECT_EQ(result.count, count) << levels << " " << rule;
        EXPECT_EQ(result.rule, expected) << levels << " " << rule;
    };
    expect("", "", 0, {});
    expect("3", "", 3, {});
    expect("99", "average", 8, {});
    expect("3", "direct", 3, direct());
    expect("all", "direct:4", 8, direct(4));
    expect("direct", "", 8, direct());
    expect("direct:64", "direct:64", 8, direct(64));
    expect("average", "", 8, {});
    expect("sharp", "", 8, {.sharp = true});
    expect("3", "sharp", 3, {.sharp = true});
    for (const auto& [levels, rule] : {std::pair{"direct", "average"},
                                       {"direct:16", "direct:4"},
                                       {"sharp", "average"},
                                       {"3", "best"},
                                       {"direct:3", ""},
                                       {"some", ""},
                                       {"-1", ""}})
        EXPECT_THROW(asked(levels, rule), Error) << levels << " " << rule;
    EXPECT_EQ(levels_asked("direct", "direct:16", 256, ImageKind::rgb8).rule, direct());
    EXPECT_EQ(levels_asked("3", "direct", 256, ImageKind::rgb_float).count, 8u);
}

TEST(DirectLevels, OfAPipelineCountTheTexelsTheyWorkOut) {
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(
        load_recipe("clouds", {"atlas.kind=patch", "atlas.size=256", "atlas.tries=1"}));
    ASSERT_EQ(last_source_level(pipeline.mesh_atlas()), 1u);
    const auto texels = [&](const LevelRule& rule) {
        const Image<RgbF> level = pipeline.level(3, rule);
        EXPECT_EQ(level.width(), 32u);
        const SynthesisWork& work = pipeline.records()[Stage::levels].last.work;
        return std::accumulate(work.texels_skipped.begin(), work.texels_skipped.end(), work.texels);
    };
    EXPECT_EQ(texels(direct(16)), 128u * 128u);
    EXPECT_EQ(texels(direct(64)), 256u * 256u);
    EXPECT_EQ(texels({}), 128u * 128u + 64u * 64u + 32u * 32u);
    const Image<RgbF> texture = pipeline.synthesize<RgbF>();
    EXPECT_EQ(pipeline.levels(texture, 3, direct())[2], pipeline.level(3, direct()));
    EXPECT_EQ(pipeline.levels(texture, 3)[2], pipeline.level(3, {}));
}

TEST(SharpLevels, OfAPipelineAreItsMeansSharpened) {
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(load_recipe("marble", {"atlas.size=128"}));
    const Image<RgbF> texture = pipeline.synthesize<RgbF>();
    std::vector<Image<RgbF>> means = pipeline.levels(texture, 7);
    const std::vector<Image<RgbF>> levels = pipeline.levels(texture, 7, {.sharp = true});
    EXPECT_NE(levels, means);
    for (Image<RgbF>& level : means) sharpen(level);
    EXPECT_EQ(levels, means);
    EXPECT_EQ(pipeline.level(2, {.sharp = true}), means[1]);
}

/// Errors of level 3 at 256 x 256, the first that costs less than level 0: 16 samples are 1/4.
struct Level3 {
    double averaged = 0.0, worked_out = 0.0, noise = 0.0;

    static Level3 of(Pipeline& pipeline, const std::string& recipe, std::size_t points) {
        pipeline.set_recipe(load_recipe(recipe, {"atlas.size=256", "atlas.tries=1"}));
        const SurfaceTruth truth = level_truth(pipeline, 3, 3, points);
        const Image<RgbF> texture = pipeline.synthesize<RgbF>();
        const auto error = [&](const LevelRule& rule) {
            const auto levels = pipeline.levels(texture, 3, rule);
            return level_errors(pipeline.atlas(), levels, truth).at(2);
        };
        EXPECT_EQ(source_level(pipeline.mesh_atlas(), direct(), 3), 1u);
        return {error({}), error(direct()), truth.levels.at(2).noise};
    }
};

TEST(DirectLevels, AreAsNearToTheSurfacesMeanAsAveragedLevelsAre) {
    Pipeline pipeline(sample_mesh("sample:teapot"));
    for (const char* recipe : {"marble", "clouds", "wood"}) {
        const Level3 level = Level3::of(pipeline, recipe, 2000);
        EXPECT_GT(level.averaged, 10.0 * level.noise) << recipe;
        EXPECT_NE(level.worked_out, level.averaged) << recipe;
        EXPECT_LT(level.worked_out, 1.02 * level.averaged + level.noise) << recipe;
    }
}

// Where maps and patterns jump, 64 samples beat 16 by a few hundredths of the error; most, a tenth,
// for the checks of checker-floor, whose sides run along the teapot's planes of symmetry and so
// along whole sides of patches: one offset of the grid of samples counts all along them.
TEST(LongDirectLevels, OfEveryPresetAreAsNearToTheSurfacesMeanAsAveragedLevelsAre) {
    Pipeline pipeline(sample_mesh("sample:teapot"));
    double sum = 0.0;
    std::size_t count = 0;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.find('.')));
        const Level3 level = Level3::of(pipeline, name, 2000);
        EXPECT_LT(level.worked_out, 1.12 * level.averaged + level.noise) << name;
        sum += level.worked_out / std::max(level.averaged, 1e-4);
        ++count;
    }
    EXPECT_GE(count, 25u);
    EXPECT_LT(sum / double(count), 1.015);
}

}  // namespace
}  // namespace burl
