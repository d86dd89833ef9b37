// A layer of paint as a mask: the closed form of a dab's fall-off, paint laid over black, gradients
// against differences, and what is kept against what is made anew.
#include "app/paint/mask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "app/export/emit.h"
#include "app/paint/texture.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/error.h"
#include "tests/app/pipeline/mask_cases.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// A dab of no hardness, whose fall-off is as wide as its radius, however large texels are.
PaintStroke soft_dab(const Vec3d& centre, double radius, int layer, double opacity = 1.0) {
    PaintStroke dab;
    dab.points = {centre};
    dab.radius = radius, dab.hardness = 0.0, dab.opacity = opacity, dab.layer = layer;
    return dab;
}

/// The coverage by a soft dab: 1 in the middle, 0 from the radius on, 3 t^2 - 2 t^3 between.
double fall_off(double distance, double radius) {
    const double t = std::max(0.0, 1.0 - distance / radius);
    return t * t * (3.0 - 2.0 * t);
}

std::vector<PaintStroke> some_strokes(int layer) {
    PaintStroke across, erased = soft_dab({0.3, 0.2, 0.4}, 0.3, layer, 0.7);
    across.points = {{-0.5, 0.1, 0.5}, {0.1, 0.3, 0.5}, {0.5, -0.2, 0.5}};
    across.radius = 0.22, across.hardness = 0.3, across.opacity = 0.8, across.layer = layer;
    erased.mode = PaintMode::erase;
    return {across, soft_dab({0.1, 0.1, 0.5}, 0.35, layer, 0.6), erased};
}

TEST(PaintMask, ATexelHasTheFallOffOfADab) {
    for (const char* kind : {"quad", "patch"}) {
        Recipe recipe =
            mask_recipe(R"({"node": "paint", "layer": 2})", {fmt::format("atlas.kind={}", kind)});
        const Vec3d centre(0.2, 0.1, 0.5);
        recipe.paint = {soft_dab(centre, 0.4, 2, 0.75), soft_dab({-0.3, 0.0, 0.5}, 0.4, 3)};
        Pipeline pipeline(cube_mesh());
        pipeline.set_recipe(recipe);
        const Image<RgbF> picture = pipeline.synthesize<RgbF>();
        const SolidAtlas& solid = pipeline.solid();
        std::size_t covered = 0;
        for (std::uint32_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                    const double away = glm::distance(solid.maps[span.map](x, y), centre);
                    const double wanted = 0.75 * fall_off(away, 0.4);
                    ASSERT_NEAR(picture(x, y).g, wanted, 1e-6) << kind;
                    covered += wanted > 0.0;
                }
        EXPECT_GT(covered, 500u) << kind;
    }
}

TEST(PaintMask, IsWhitePaintOverBlack) {
    SyntheticAtlas atlas;
    atlas.size = 90, atlas.step = 0.02;
    const SolidAtlas solid = atlas.make(3);
    std::vector<PaintStroke> strokes = some_strokes(4);
    const TexelField mask = paint_mask(solid, strokes, false, 1);
    EXPECT_EQ(mask.slopes.width(), 0u);
    for (PaintStroke& stroke : strokes) stroke.layer = 0, stroke.color = {255, 255, 255};
    Image<RgbF> paint(solid.size, solid.size, {0.0f, 0.0f, 0.0f});
    paint_over(solid, strokes, 1, paint);
    std::size_t covered = 0;
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (std::uint32_t x = 0; x < solid.size; ++x) {
            ASSERT_NEAR(mask.values(x, y), paint(x, y).g, 1e-6);
            covered += paint(x, y).g > 0.0f;
        }
    EXPECT_GT(covered, 100u);
    EXPECT_EQ(mask.values, paint_mask(solid, strokes, true, 3).values) << "threads, gradients";
}

TEST(PaintMask, GradientsAreThoseOfDifferences) {
    const std::vector<PaintStroke> strokes = some_strokes(1);
    std::vector<Vec3d> points;
    for (int i = 0; i < 200; ++i)
        points.emplace_back(0.005 * i - 0.5, 0.3 * std::sin(0.4 * i), 0.45 + 0.05 * std::cos(i));
    const std::vector<Dual> found = paint_mask_at(points, strokes);
    constexpr double h = 1e-6;
    double steepest = 0.0;
    for (int k = 0; k < 3; ++k) {
        std::vector<Vec3d> low = points, high = points;
        for (Vec3d& p : low) p[k] -= h;
        for (Vec3d& p : high) p[k] += h;
        const auto below = paint_mask_at(low, strokes), above = paint_mask_at(high, strokes);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double slope = (above[i].value - below[i].value) / (2.0 * h);
            EXPECT_NEAR(found[i].slope[k], slope, 2e-4) << i;
            steepest = std::max(steepest, std::abs(slope));
        }
    }
    EXPECT_GT(steepest, 1.0);
}

TEST(PaintMask, StrokesOfAMaskAreNoColour) {
    Recipe recipe = mask_recipe(R"({"node": "constant", "value": "#204060"})");
    Pipeline bare(cube_mesh()), with(cube_mesh());
    bare.set_recipe(recipe);
    recipe.paint = some_strokes(1);
    with.set_recipe(recipe);
    EXPECT_EQ(bare.synthesize<Rgb8>(), with.synthesize<Rgb8>());
    EXPECT_EQ(with.records()[Stage::paint].runs, 0u);
}

TEST(PaintMask, IsMadeAgainWhereItsStrokesChange) {
    // A colour map over the mask, whose number is kept; a blend by it; bumps of it.
    for (const char* texture :
         {R"({"node": "color_map", "wrap": "clamp", "stops": [[0, "#000000"], [1, "#ff8000"]],
              "input": {"node": "multiply", "a": {"node": "paint"}, "b": 0.9}})",
          R"({"node": "blend", "base": "#303030", "top": "#ffffff", "mask": {"node": "paint"}})"}) {
        Pipeline pipeline(cube_mesh());
        pipeline.set_cache(std::size_t(1) << 26);
        Recipe recipe = mask_recipe(texture);
        recipe.bump = parse_recipe(R"({"texture": {"node": "fbm"}, "bump": {"height": 0.1,
            "input": {"node": "paint"}}})",
                                   "r")
                          .bump;
        const auto check = [&](std::uint64_t runs, std::vector<PaintStroke> strokes) {
            recipe.paint = std::move(strokes);
            pipeline.set_recipe(recipe);
            Pipeline anew(cube_mesh());
            anew.set_recipe(recipe);
            EXPECT_EQ(*pipeline.picture<Rgb8>(), anew.synthesize<Rgb8>());
            EXPECT_EQ(pipeline.normal_map<Rgb8>(30.0, true), anew.normal_map<Rgb8>(30.0, true));
            EXPECT_EQ(pipeline.records()[Stage::masks].runs, runs);
        };
        check(1, some_strokes(1));
        check(2, {soft_dab({0.0, 0.2, 0.5}, 0.3, 1)});
        std::vector<PaintStroke> more{soft_dab({0.0, 0.2, 0.5}, 0.3, 1)};
        more.push_back(soft_dab({0.4, 0.2, 0.5}, 0.3, 2));
        check(2, more);  // of another mask
        more.push_back(soft_dab({0.4, 0.2, 0.5}, 0.3, 0));
        check(2, more);  // a colour
        check(3, {});
    }
}

TEST(PaintMask, IsWrittenAndReadWithItsLayer) {
    Recipe recipe = mask_recipe(R"({"node": "paint", "layer": 7})");
    recipe.paint = some_strokes(7);
    EXPECT_EQ(parse_recipe(to_json(recipe), "r"), recipe);
    EXPECT_EQ(strokes_of(recipe.paint, 7), recipe.paint);
    EXPECT_TRUE(strokes_of(recipe.paint, 0).empty());
}

TEST(PaintMask, WhereThereAreNoTexelsItIsRefusedByName) {
    const Recipe recipe = mask_recipe(R"({"node": "paint", "layer": 2})");
    try {
        static_cast<void>(emit_glsl(recipe, {}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("its node \"paint\" is worked out"));
    }
}

}  // namespace
}  // namespace burl
