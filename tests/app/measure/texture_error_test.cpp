// Errors of textures against differences worked out texel by texel from the texture's definition.
#include "app/measure/texture_error.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/image/image_diff.h"
#include "app/pipeline/pipeline.h"
#include "app/pipeline/texture_color.h"
#include "procedural/color/srgb.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// Linear light that the definition has at a point of the solid.
using Definition = std::function<Vec3d(const Vec3d& solid)>;

Definition unpainted(const Recipe& recipe) {
    return [color = texture_color(recipe), map = texture_from_solid(recipe)](const Vec3d& p) {
        return color(map(p));
    };
}

struct Expected {
    Image<float> codes;
    double largest = 0.0, rms = 0.0;
};

Expected by_definition(const SolidAtlas& solid, const Image<Rgb8>& texels,
                       const Definition& definition) {
    Expected expected{Image<float>(solid.size, solid.size, -1.0f)};
    double squares = 0.0, count = 0.0;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const Vec3d c = definition(solid.maps[span.map](x, std::int64_t(y)));
                const Rgb8& t = texels(x, y);
                double most = 0.0;
                for (const auto& [code, light] :
                     {std::pair(t.r, c.x), std::pair(t.g, c.y), std::pair(t.b, c.z)}) {
                    const double off =
                        std::abs(double(code) - 255.0 * srgb_encode(std::clamp(light, 0.0, 1.0)));
                    most = std::max(most, off);
                    squares += off * off;
                    ++count;
                }
                expected.codes(x, y) = float(most);
                expected.largest = std::max(expected.largest, most);
            }
    expected.rms = std::sqrt(squares / count);
    return expected;
}

void expect_error(Pipeline& pipeline, const Definition& definition) {
    const auto texels = pipeline.synthesize<Rgb8>();
    const auto error = texture_error(pipeline.solid(), pipeline.recipe(), texels, {});
    ASSERT_TRUE(error);
    const Expected expected = by_definition(pipeline.solid(), texels, definition);
    for (std::size_t y = 0; y < texels.height(); ++y)
        for (std::size_t x = 0; x < texels.width(); ++x)
            ASSERT_NEAR(error->codes(x, y), expected.codes(x, y), 1e-3) << x << " " << y;
    EXPECT_NEAR(error->largest, expected.largest, 1e-3);
    EXPECT_NEAR(error->rms, expected.rms, 1e-4);
}

Pipeline texture_error_with(const std::string& recipe, std::vector<std::string> settings) {
    settings.push_back("atlas.size=64");
    Pipeline pipeline(made::ball(3));
    pipeline.set_recipe(load_recipe(recipe, settings));
    return pipeline;
}

TEST(TextureError, IsTheDifferenceFromTheDefinition) {
    for (const char* recipe : {"marble", "wood", "clouds"}) {
        Pipeline pipeline = texture_error_with(recipe, {"solid.rotate=[10,20,30]"});
        expect_error(pipeline, unpainted(pipeline.recipe()));
    }
}

TEST(TextureError, ShowsCoarseArithmetic) {
    Pipeline coarse = texture_error_with("wood", {});
    Recipe recipe = coarse.recipe();
    recipe.precision = {PrecisionKind::fixed, {8, 6}};
    coarse.set_recipe(recipe);
    expect_error(coarse, unpainted(coarse.recipe()));
    const auto texels = coarse.synthesize<Rgb8>();
    EXPECT_GT(texture_error(coarse.solid(), coarse.recipe(), texels, {})->largest, 3.0);
}

TEST(TextureError, TheReferenceIsPaintedAsTheTextureIs) {
    Pipeline pipeline = texture_error_with("marble", {});
    Recipe recipe = pipeline.recipe();
    // Covers all of the ball evenly.
    recipe.paint = {{{{0, 0, 0}}, 5.0, 1.0, 0.25, {200, 30, 90}, PaintMode::paint}};
    pipeline.set_recipe(recipe);
    const Definition below = unpainted(recipe);
    expect_error(pipeline, [&](const Vec3d& p) {
        return 0.25 * linear_light({200, 30, 90}) + 0.75 * below(p);
    });
}

TEST(TextureError, StopsWhenItIsToldTo) {
    Pipeline pipeline = texture_error_with("marble", {});
    std::stop_source source;
    source.request_stop();
    EXPECT_FALSE(texture_error(pipeline.solid(), pipeline.recipe(), pipeline.synthesize<Rgb8>(),
                               source.get_token()));
}

TEST(TextureError, LevelsKeepTheLargestErrors) {
    TextureError error{Image<float>(5, 5, -1.0f), 7.0, 1.0};
    error.codes(4, 4) = 7.0f;
    error.codes(0, 1) = 1.0f;
    EXPECT_EQ(error_scale(error.largest), 8.0);
    const std::vector<Image<Rgb8>> levels = error_levels(error);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[0](4, 4), false_color(7.0 / 8.0));
    EXPECT_EQ(levels[1](1, 1), false_color(7.0 / 8.0));
    EXPECT_EQ(levels[1](0, 0), false_color(1.0 / 8.0));
    EXPECT_EQ(levels[2](0, 0), false_color(7.0 / 8.0));
    EXPECT_EQ(levels[0](0, 0), levels[0](3, 3));
    EXPECT_NE(levels[0](0, 0), false_color(0.0));
}

TEST(TextureError, SaysWhereFloat64IsNoReference) {
    const Box3 box{Vec3d(-0.5), Vec3d(0.5)};
    Recipe recipe = load_recipe("marble");
    EXPECT_EQ(no_reference(recipe, box), "");
    recipe.solid.translate.x = 1e18;
    EXPECT_NE(no_reference(recipe, box), "");
}

}  // namespace
}  // namespace burl
